// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/contact_pass.hpp"

#include <algorithm>
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
    : topology_(setting.body.topology), forms_(forms), contact_(setting) {
  for (const ContactFacet<d>& facet : contact_.facets()) {
    tractions_.push_back(traction_on<d>(facet, moments));
    const int cell = topology_.facets.cells(0, facet.facet);
    stress_ = std::max(stress_, max_norm(setting.body.stress.mean.col(cell)));
  }
  for (RidgeGroup& group : ridge_groups<d>(topology_, contact_.facets()))
    stars_.emplace_back(topology_, std::move(group), contact_, forms);
  colour();
}

/// The lowest colour that no star before it with a cell in common has.
template <int d>
void ContactPass<d>::colour() {
  std::map<int, std::vector<int>> taken;  // of each cell
  for (int s = 0; s < count_of(stars_); ++s) {
    std::vector<int> cells;
    for (int ridge : stars_[s].group().ridge)
      for (const Wedge& wedge : wedges_of<d>(topology_, ridge))
        cells.push_back(wedge.cell);
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
    const Star& star = stars_[colour[k]];
    changes[k] =
        star.change(-group_restricted<d>(topology_, star.group(), residual),
                    scales, tractions_);
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
      if (found[k].fall > 0)
        add(stars_[colour[k]].group(), found[k].x, corrections, residual);
    }
  }
  return fall;
}

/// Stars of one colour share facets outside their cells: one after the other.
template <int d>
void ContactPass<d>::add(const RidgeGroup& group, const VectorXd& x,
                         FacetColumns<d>& corrections,
                         FacetColumns<d>& residual) const {
  for (int k = 0; k < count_of(group.ridge); ++k)
    add_around<d>(topology_, forms_, group.ridge[k], x(group.of_ridge(k)),
                  corrections, residual);
}

template <int d>
double ContactPass<d>::contact_part() const {
  const double sum = sum_over(tractions_.size(), [&](int m) {
    return contact_term<d>(contact_.facets()[m], tractions_[m]);
  });
  return 2 * sum;
}

template class ContactPass<FFCONTACT_DIMENSION>;

}  // namespace ffcontact
