// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/contact_pass.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "ffcontact/base/over.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/energy/ridge_form.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Has one of these cells taken a colour?
bool is_taken(const std::map<int, std::vector<int>>& colours_of_cell,
              const std::vector<int>& cells, int colour) {
  return std::any_of(cells.begin(), cells.end(), [&](int cell) {
    const auto taken = colours_of_cell.find(cell);
    return taken != colours_of_cell.end() &&
           std::count(taken->second.begin(), taken->second.end(), colour) > 0;
  });
}

}  // namespace

template <int d>
ContactPass<d>::ContactPass(const FacetSetting<d>& setting,
                            const FacetForms<d>& forms,
                            const FacetColumns<d>& moments)
    : topology_(setting.body.topology),
      forms_(forms),
      contact_(setting),
      oscillation_(setting.oscillation),
      oscillation_of_(setting.contact.size()) {
  for (const ContactFacet<d>& facet : contact_.facets()) {
    tractions_.push_back(traction_on<d>(facet, moments));
    const int cell = topology_.facets.cells(0, facet.facet);
    stress_ = std::max(stress_, max_norm(setting.body.stress.mean.col(cell)));
  }
  for (RidgeGroup& group : ridge_groups<d>(topology_, contact_.facets()))
    stars_.emplace_back(topology_, std::move(group), contact_, forms);
  add_facing_stars();
  colour();
}

/// What the tractions of a star do not leave to the facets that they face, by its corrections.
template <int d>
MatrixXd ContactPass<d>::form_of_oscillation(const FacingStar<d>& star) const {
  struct PartOfStar {
    int oscillation, part;
    const MatrixXd& tractions;
  };
  std::vector<PartOfStar> parts;
  for (std::size_t i = 0; i < star.contact.size(); ++i)
    for (const auto& [k, part] : oscillation_of_[star.contact[i]])
      parts.push_back({k, part, star.tractions[i]});
  const Index unknowns = star.columns.Z.cols();
  MatrixXd form = MatrixXd::Zero(unknowns, unknowns);
  for (const PartOfStar& row : parts)
    for (const PartOfStar& column : parts) {
      if (row.oscillation != column.oscillation) continue;
      const FacingOscillation<d>& of = oscillation_[row.oscillation];
      form += row.tractions.transpose() *
              of.form(of.parts[row.part], of.parts[column.part]) *
              column.tractions;
    }
  return form;
}

template <int d>
void ContactPass<d>::add_facing_stars() {
  for (int k = 0; k < count_of(oscillation_); ++k)
    for (int part = 0; part < count_of(oscillation_[k].parts); ++part)
      oscillation_of_[oscillation_[k].parts[part].contact].emplace_back(k,
                                                                        part);
  facing_ = facing_stars<d>(topology_, contact_.facets());
  elastic_.resize(facing_.size());
  beyond_.resize(facing_.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t s = 0; s < facing_.size(); ++s) {
    FacingStar<d>& star = facing_[s];
    star.columns = with_least_modes<d>(topology_, forms_,
                                       std::move(star.columns), elastic_[s]);
    beyond_[s] = form_of_oscillation(star);
  }
  for (std::size_t s = 0; s < facing_.size(); ++s)
    stars_.emplace_back(contact_, facing_[s].contact, facing_[s].tractions,
                        elastic_[s] + weight_ * beyond_[s]);
}

template <int d>
void ContactPass<d>::weigh(double first_square) {
  constexpr double gain = 4, least = 1.0 / 256, most = 4;
  const double square = oscillation();
  if (!(square > 0)) return;
  weight_ = std::clamp(first_square / square / (gain * gain), least, most);
  for (std::size_t s = 0; s < facing_.size(); ++s)
    stars_[group_count() + s] =
        Star(contact_, facing_[s].contact, facing_[s].tractions,
             elastic_[s] + weight_ * beyond_[s]);
}

/// o^2
template <int d>
double ContactPass<d>::oscillation() const {
  return sum_over(oscillation_.size(),
                  [&](int k) { return oscillation_[k].value(tractions_); });
}

template <int d>
std::vector<int> ContactPass<d>::cells_of(int star) const {
  if (star >= group_count())
    return cells_beside<d>(topology_.facets,
                           facing_[star - group_count()].columns.facet);
  std::vector<int> cells;
  for (int ridge : stars_[star].group().ridge)
    for (const Wedge& wedge : wedges_of<d>(topology_, ridge))
      cells.push_back(wedge.cell);
  return cells;
}

/// Half the slope of e^2 by the corrections of a star, without contact_term.
template <int d>
VectorXd ContactPass<d>::slope_of(int star,
                                  const FacetColumns<d>& residual) const {
  if (star < group_count())
    return -group_restricted<d>(topology_, stars_[star].group(), residual);
  const FacingStar<d>& facing = facing_[star - group_count()];
  VectorXd slope = -restricted<d>(facing.columns, residual);
  for (std::size_t i = 0; i < facing.contact.size(); ++i)
    for (const auto& [k, part] : oscillation_of_[facing.contact[i]])
      slope += weight_ * facing.tractions[i].transpose() *
               oscillation_[k].slope(oscillation_[k].parts[part], tractions_);
  return slope;
}

/// The lowest colour that no star before it with a cell in common has.
template <int d>
void ContactPass<d>::colour() {
  std::map<int, std::vector<int>> taken;  // of each cell
  for (int s = 0; s < count_of(stars_); ++s) {
    const std::vector<int> cells = cells_of(s);
    int colour = 0;
    while (is_taken(taken, cells, colour)) ++colour;
    for (int cell : cells) taken[cell].push_back(colour);
    if (colour == count_of(colours_)) colours_.emplace_back();
    colours_[colour].push_back(s);
  }
}

template <int d>
typename ContactStar<d>::Scales ContactPass<d>::scales(
    double least_fall) const {
  double largest = stress_;
  for (const MatrixOf<d>& traction : tractions_)
    largest = std::max(largest, max_norm(traction));
  return {least_fall, largest};
}

/// Of the stars of one colour, all from the same residual.
template <int d>
std::vector<typename ContactStar<d>::Change> ContactPass<d>::changes(
    const std::vector<int>& colour, const typename Star::Scales& scales,
    const FacetColumns<d>& residual) {
  std::vector<typename Star::Change> changes(colour.size());
  constexpr std::size_t worth_threads = 64;  // fewer stars than a wait takes
#pragma omp parallel for if (colour.size() >= worth_threads)
  for (std::size_t k = 0; k < colour.size(); ++k) {
    changes[k] = stars_[colour[k]].change(slope_of(colour[k], residual), scales,
                                          tractions_);
  }
  return changes;
}

template <int d>
double ContactPass<d>::pass(double least_fall, FacetColumns<d>& corrections,
                            FacetColumns<d>& residual) {
  const typename Star::Scales of_pass = scales(least_fall);
  double fall = 0;
  for (const std::vector<int>& colour : colours_) {
    const auto found = changes(colour, of_pass, residual);
    for (std::size_t k = 0; k < colour.size(); ++k) {
      fall += found[k].fall;
      if (found[k].fall > 0) add(colour[k], found[k].x, corrections, residual);
    }
  }
  return fall;
}

/// Stars of one colour share facets outside their cells: one after the other.
template <int d>
void ContactPass<d>::add(int star, const VectorXd& x,
                         FacetColumns<d>& corrections,
                         FacetColumns<d>& residual) const {
  if (star >= group_count())
    return add_columns<d>(topology_, forms_,
                          facing_[star - group_count()].columns, x, corrections,
                          residual);
  const RidgeGroup& group = stars_[star].group();
  for (int k = 0; k < count_of(group.ridge); ++k)
    add_around<d>(topology_, forms_, group.ridge[k], x(group.of_ridge(k)),
                  corrections, residual);
}

template <int d>
double ContactPass<d>::contact_part() const {
  const double sum = sum_over(tractions_.size(), [&](int m) {
    return contact_term<d>(contact_.facets()[m], tractions_[m]);
  });
  return 2 * sum + weight_ * oscillation();
}

template class ContactPass<FFCONTACT_DIMENSION>;

}  // namespace ffcontact
