// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/ridge_group.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/unions.hpp"
#include "ffcontact/equilibrium/energy/ridge_form.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Places nearer to each other than this part of the body's size are the same.
constexpr double same_place = 1e-9;

/// The ridges of contact facets and those that they lie on, in sets that hang together, each
/// by its root.
template <int d>
std::map<int, std::set<int>> joined_ridges(
    const FacetTopology<d>& topology,
    const std::vector<ContactFacet<d>>& contact, Unions& joined) {
  const auto& of_facet = topology.ridges.of_facet;
  std::vector<int> ridges;
  for (const ContactFacet<d>& facet : contact)
    for (int k = 0; k < d && facet.facing.empty(); ++k) {
      const int own = of_facet(k, facet.facet);
      ridges.push_back(own);
      if (facet.opposite < 0) continue;
      const int other = of_facet(facet.opposite_corner[k], facet.opposite);
      ridges.push_back(other);
      joined.join(own, other);
    }
  return joined.sets_of(ridges);
}

/// Sorts groups by their lowest middles, in steps of a length.
template <int d>
void sort_by_middles(const FacetTopology<d>& topology, double step,
                     std::vector<RidgeGroup>& groups) {
  using RoundedPlace = std::array<double, d>;
  std::multimap<RoundedPlace, RidgeGroup> in_order;
  for (RidgeGroup& group : groups) {
    RoundedPlace lowest;
    lowest.fill(std::numeric_limits<double>::infinity());
    for (int ridge : group.ridge) {
      const Vector3d place =
          ridge_middle(topology.mesh, topology.ridges, ridge) / step;
      lowest = std::min(lowest, {std::round(place[0]), std::round(place[1]),
                                 std::round(place[2])});
    }
    in_order.emplace(lowest, std::move(group));
  }
  groups.clear();
  for (auto& [place, group] : in_order) groups.push_back(std::move(group));
}

template <int d>
RidgeGroup group_of(const FacetTopology<d>& topology,
                    const std::set<int>& ridges) {
  RidgeGroup group{{ridges.begin(), ridges.end()}, {0}};
  for (int ridge : group.ridge)
    group.first.push_back(group.first.back() +
                          unknowns_around<d>(topology.ridges, ridge));
  return group;
}

/// Adds what the k-th ridge has for the facet at a place around it.
template <int d>
void add_spoke(const FacetTopology<d>& topology, const RidgeGroup& group, int k,
               int place, std::map<int, BoundarySpoke<d>>& spokes) {
  using Element = CompositeElement<d>;
  constexpr int wrench = Element::wrench, modes = Element::modes;
  const int facet = topology.ridges.facets_of(group.ridge[k])[place];
  const FacetMatrix<d> V = wrench_basis<d>(topology.facet_corners(facet));
  BoundarySpoke<d> none{facet,
                        MatrixXd::Zero(Element::moments, group.unknowns())};
  auto& moments = spokes.emplace(facet, std::move(none)).first->second.moments;
  moments.template middleCols<wrench>(group.first[k]) +=
      V.template leftCols<wrench>() *
      wrench_shift<d>(topology, facet, group.ridge[k]).matrix();
  moments.template middleCols<modes>(group.first[k] + wrench + modes * place) +=
      V.template rightCols<modes>();
}

}  // namespace

template <int d>
std::vector<RidgeGroup> ridge_groups(
    const FacetTopology<d>& topology,
    const std::vector<ContactFacet<d>>& contact) {
  Unions joined(topology.ridges.count());
  auto sets = joined_ridges<d>(topology, contact, joined);
  std::vector<RidgeGroup> groups;
  for (const ContactFacet<d>& facet : contact)
    for (int k = d - 1; k >= 0;
         --k) {  // opposite to the last vertex: the first
      const int ridge = topology.ridges.of_facet(k, facet.facet);
      const auto set = sets.extract(joined.root(ridge));
      if (!set.empty()) groups.push_back(group_of<d>(topology, set.mapped()));
    }
  if constexpr (d == 3)
    if (!groups.empty())
      sort_by_middles(topology,
                      same_place * box_sides(topology.mesh.vertices).maxCoeff(),
                      groups);
  return groups;
}

template <int d>
MatrixXd group_form(const FacetTopology<d>& topology, const RidgeGroup& group,
                    const FacetForms<d>& forms) {
  MatrixXd A = MatrixXd::Zero(group.unknowns(), group.unknowns());
  for (int k = 0; k < count_of(group.ridge); ++k)
    A(group.of_ridge(k), group.of_ridge(k)) =
        ridge_form<d>(topology, group.ridge[k],
                      shifts_around<d>(topology, group.ridge[k]).data(), forms);
  return A;
}

template <int d>
VectorXd group_restricted(const FacetTopology<d>& topology,
                          const RidgeGroup& group, const FacetColumns<d>& g) {
  VectorXd x(group.unknowns());
  for (int k = 0; k < count_of(group.ridge); ++k)
    x(group.of_ridge(k)) = restricted<d>(topology, group.ridge[k], g);
  return x;
}

template <int d>
std::vector<BoundarySpoke<d>> boundary_spokes(const FacetTopology<d>& topology,
                                              const RidgeGroup& group) {
  std::map<int, BoundarySpoke<d>> spokes;
  for (int k = 0; k < count_of(group.ridge); ++k) {
    const std::vector<int> around =
        facets_around<d>(topology.ridges, group.ridge[k]);
    for (int place = 0; place < count_of(around); ++place)
      if (topology.facets.on_boundary(around[place]))
        add_spoke<d>(topology, group, k, place, spokes);
  }
  std::vector<BoundarySpoke<d>> result;
  for (auto& [facet, spoke] : spokes) result.push_back(std::move(spoke));
  return result;
}

template <int d>
std::vector<int> unknowns_on_boundary(const FacetTopology<d>& topology,
                                      const RidgeGroup& group) {
  constexpr int wrench = CompositeElement<d>::wrench,
                modes = CompositeElement<d>::modes;
  std::vector<int> unknowns;
  for (int k = 0; k < count_of(group.ridge); ++k) {
    int next = group.first[k];
    for (int i = 0; i < wrench; ++i) unknowns.push_back(next++);
    for (int facet : topology.ridges.facets_of(group.ridge[k]))
      for (int mode = 0; mode < modes; ++mode, ++next)
        if (topology.facets.on_boundary(facet)) unknowns.push_back(next);
  }
  return unknowns;
}

template std::vector<RidgeGroup> ridge_groups(
    const FacetTopology<FFCONTACT_DIMENSION>&,
    const std::vector<ContactFacet<FFCONTACT_DIMENSION>>&);
template MatrixXd group_form(const FacetTopology<FFCONTACT_DIMENSION>&,
                             const RidgeGroup&,
                             const FacetForms<FFCONTACT_DIMENSION>&);
template VectorXd group_restricted<FFCONTACT_DIMENSION>(
    const FacetTopology<FFCONTACT_DIMENSION>&, const RidgeGroup&,
    const FacetColumns<FFCONTACT_DIMENSION>&);
template std::vector<BoundarySpoke<FFCONTACT_DIMENSION>> boundary_spokes(
    const FacetTopology<FFCONTACT_DIMENSION>&, const RidgeGroup&);
template std::vector<int> unknowns_on_boundary(
    const FacetTopology<FFCONTACT_DIMENSION>&, const RidgeGroup&);

}  // namespace ffcontact
