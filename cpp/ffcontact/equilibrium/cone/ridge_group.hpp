// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/energy/facet_forms.hpp"
#include "ffcontact/equilibrium/tractions/contact_facet.hpp"

namespace ffcontact {

/// Ridges of several bodies that lie on each other in contact facets that match. The
/// corrections of the facets around each (ridge_form) follow each other in
///     x = (w, y_1, .., y_m) of the first, of the second, ..
/// A ridge of one body alone is a group, too.
struct RidgeGroup {
  std::vector<int> ridge;  ///< ascending
  std::vector<int>
      first;  ///< unknown of each ridge in x, and the number of all

  int unknowns() const { return first.back(); }
  auto of_ridge(int k) const { return Eigen::seq(first[k], first[k + 1] - 1); }
};

/// Those of contact facets that match, or face a rigid foundation: in the plane in the order of the line, in space in that of their
/// middles; neither depends on how mesh and surface are numbered.
template <int d>
std::vector<RidgeGroup> ridge_groups(
    const FacetTopology<d>& topology,
    const std::vector<ContactFacet<d>>& contact);

/// A = Z' H Z, block by block.
template <int d>
MatrixXd group_form(const FacetTopology<d>& topology, const RidgeGroup& group,
                    const FacetForms<d>& forms);

/// Z' g
template <int d>
VectorXd group_restricted(const FacetTopology<d>& topology,
                          const RidgeGroup& group, const FacetColumns<d>& g);

/// A boundary facet around ridges of a group.
template <int d>
struct BoundarySpoke {
  int facet;
  /// its moments by x [d^2 x unknowns]
  Matrix<double, CompositeElement<d>::moments, Dynamic> moments;
};
/// Each once, ascending.
template <int d>
std::vector<BoundarySpoke<d>> boundary_spokes(const FacetTopology<d>& topology,
                                              const RidgeGroup& group);

/// The unknowns that boundary facets take part in: the wrenches, and the modes of these.
template <int d>
std::vector<int> unknowns_on_boundary(const FacetTopology<d>& topology,
                                      const RidgeGroup& group);

}  // namespace ffcontact
