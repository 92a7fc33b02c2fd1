// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/boundary_relaxation.hpp"

#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "ffcontact/linear/dense/congruent.hpp"
#include "ffcontact/linear/dense/products.hpp"
#include "ffcontact/linear/minimum/quadratic_minimum.hpp"

namespace ffcontact {

namespace {

/// The densities that the four unknowns of a spoke have on an edge, at its vertex and at
/// the other end.
Matrix4d spoke_densities(const BoundarySpoke& spoke, double length) {
  Matrix4d density;
  for (int c = 0; c < 4; ++c)
    density.col(c) =
        facet_density<2>(spoke.moments.col(c).reshaped(2, 2), length)
            .reshaped();
  return density;
}

/// What the corrections of a group do to the end values (r_n,i, r_t,i, r_n,j, r_t,j) of
/// one free contact edge.
struct EdgeEnds {
  int edge;
  Matrix<double, 4, Dynamic> change;  ///< [4 x unknowns]

  EdgeEnds(const BoundarySpoke& spoke, int e, const ContactLine& line,
           int unknowns)
      : edge(e) {
    const Matrix2d frame = edge_frame(line, e);
    const Matrix4d density = spoke_densities(spoke, line.length[e]);
    change.setZero(4, unknowns);
    for (int end = 0; end < 2; ++end) {
      const int place = spoke.runs_along_edge ? end : 1 - end;
      spoke.spread(frame * density.middleRows<2>(2 * place),
                   change.middleRows<2>(2 * end));
    }
  }
};

std::vector<EdgeEnds> free_ends(const StarGroup& group,
                                const FreeContact& contact) {
  std::vector<EdgeEnds> ends;
  for (const BoundarySpoke& spoke : group.spokes) {
    const int e = own_edge(spoke, contact);
    if (e >= 0) ends.emplace_back(spoke, e, contact.line, group.unknowns());
  }
  return ends;
}

/// Cost and cone of the free ends as functions of the corrections.
struct ContactTerms {
  VectorXd cost;  ///< linear part of e^2
  MatrixXd C;
  VectorXd d;
  VectorXd reach;  ///< lengths of the rows as conditions on end values
  Index rows = 0;

  void add(const EdgeEnds& ends, const FreeContact& contact) {
    const auto& [e, change] = ends;
    const FreeTractions& tractions = contact.tractions;
    const EdgeCone cone = edge_cone(contact.line, contact.law, e);
    cost += change.transpose() * interleaved(tractions.normal_cost.col(e),
                                             tractions.tangential_cost.col(e));
    C.middleRows(rows, cone.C.rows()) = product(cone.C, change);
    d.segment(rows, cone.d.size()) =
        // r is inside: the rest is rounding
        (cone.d - cone.C * end_values(tractions.densities, e)).cwiseMin(0);
    reach.segment(rows, cone.d.size()) = cone.C.rowwise().norm();
    rows += cone.d.size();
  }
};

ContactTerms contact_terms(const std::vector<EdgeEnds>& ends, int unknowns,
                           const FreeContact& contact) {
  const auto most = EdgeCone::most_rows * static_cast<Index>(ends.size());
  ContactTerms terms{VectorXd::Zero(unknowns), MatrixXd(most, unknowns),
                     VectorXd(most), VectorXd(most)};
  for (const EdgeEnds& of_edge : ends) terms.add(of_edge, contact);
  terms.C.conservativeResize(terms.rows, Eigen::NoChange);
  terms.d.conservativeResize(terms.rows);
  terms.reach.conservativeResize(terms.rows);
  return terms;
}

/// The conditions on x for y = Z x, without those that no x can change.
void restrict(const MatrixXd& Z, ContactTerms& terms) {
  Index kept = 0;
  const MatrixXd C = product(terms.C, Z);
  const double size = Z.norm();
  for (Index row = 0; row < C.rows(); ++row)
    if (C.row(row).norm() >
        negligible_change * size * terms.C.row(row).norm()) {
      terms.d[kept] = terms.d[row];
      terms.C.row(kept++) = terms.C.row(row);
    }
  terms.C = product(terms.C.topRows(kept), Z);
  terms.d.conservativeResize(kept);
}

/// By how much corrections y change e^2: y'Hy + slope'y.
struct EnergyChange {
  MatrixXd H;
  VectorXd slope;

  double fall(const VectorXd& y) const { return -y.dot(H * y) - y.dot(slope); }
};

EnergyChange energy_change(const FacetTopology<2>& topology,
                           const FacetForms<2>& forms, const StarGroup& group,
                           const FacetColumns<2>& residual,
                           const VectorXd& cost) {
  EnergyChange change{MatrixXd::Zero(cost.size(), cost.size()), cost};
  auto& [H, slope] = change;
  for (std::size_t s = 0; s < group.ridge.size(); ++s) {
    const int ridge = group.ridge[s], first = group.first[s],
              size = group.first[s + 1] - first;
    H.block(first, first, size, size) = ridge_form<2>(
        topology, ridge, shifts_around<2>(topology, ridge).data(), forms);
    slope.segment(first, size) -= 2 * restricted<2>(topology, ridge, residual);
  }
  return change;
}

/// y = Z x that lowers e^2 most inside the cone.
std::optional<VectorXd> best_corrections(const EnergyChange& change,
                                         const MatrixXd& Z,
                                         ContactTerms terms) {
  restrict(Z, terms);
  const auto x =
      quadratic_minimum(2 * congruent(change.H, Z),
                        Z.transpose() * change.slope, terms.C, terms.d);
  if (!x) return std::nullopt;
  return Z * *x;
}

/// Do corrections y leave the tractions in the cone but for so much [MPa]?
bool stay_in_cone(const ContactTerms& terms, const VectorXd& y,
                  double rounding) {
  return ((terms.d - terms.C * y).array() <= rounding * terms.reach.array())
      .all();
}

}  // namespace

BoundaryChange relax_boundary(const FacetTopology<2>& topology,
                              const FacetForms<2>& forms,
                              const BoundaryTractions& boundary,
                              const StarGroup& group,
                              const FacetColumns<2>& residual,
                              FreeContact& contact) {
  const MatrixXd Z = admissible_corrections(group, boundary, &contact);
  if (Z.cols() == 0) return {};
  const std::vector<EdgeEnds> ends = free_ends(group, contact);
  const ContactTerms terms = contact_terms(ends, group.unknowns(), contact);
  const EnergyChange energy =
      energy_change(topology, forms, group, residual, terms.cost);
  const auto y = best_corrections(energy, Z, terms);
  const double fall = y ? energy.fall(*y) : 0;
  if (!(fall > 0) || !stay_in_cone(terms, *y, contact.tractions.rounding))
    return {};

  for (const auto& [e, change] : ends) {
    ContactDensities& densities = contact.tractions.densities;
    set_end_values(densities, e, end_values(densities, e) + change * *y);
  }
  return {*y, fall};
}

}  // namespace ffcontact
