// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <type_traits>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/checks/compliance_ratio.hpp"
#include "ffcontact/interface/joined_contact.hpp"
#include "ffcontact/mesh/topology.hpp"
//
#include "problem/contact_statement.hpp"
#include "problem/pair_sides.hpp"

namespace ffcontact::plugin {

/// A contact problem as a script states it: one mesh or several, and label=, friction=,
/// kineticfriction=, slipbound=, compliance=, gap=, normal=[nx, ny] (one contact direction a
/// vertex in place of the normals of lines, smooth curves or faces), corner= (BoundaryCurves;
/// of plane bodies), previous= (displacement of the load step before; an empty array is
/// none), side= (1 or 2: which body of a pair carries the multipliers). All is evaluated when
/// it is stated.
///
/// One mesh: label= faces a rigid foundation, or the labels opposite= of the same mesh,
/// which then is of bodies that share no vertex. Several meshes: body k faces body k + 1,
/// with label1=, label2=, ... in place of label=; bodies between two others have two
/// labels, the first faces the body before, the second the one after. Coefficients are
/// those of the body that comes first. Without gap= the gap against a body is that of the
/// meshes.
///
/// The multipliers are on the line or surface of the body that comes first (side 1), or,
/// where the other's can carry them and yields much more (compliance_ratio), on that
/// (side 2). Both are prepared; it is side 1 until choose_sides knows the matrices.
template <int d>
struct ContactProblem : Bodies<d>, Carrier<d> {
  const SimplexMesh<d>& mesh = this->joined.mesh;
  /// of each pair: the first of its nodes; then the number of all nodes
  std::vector<long> first_node;
  /// that carries the multipliers, 1 or 2, of each pair; none on a rigid foundation
  std::vector<long> side;
  std::vector<int> body_of_pair;  ///< that comes first

  /// @throws std::invalid_argument  if a mesh, a label or a coefficient is not usable
  ContactProblem(Stack stack, const NamedArguments& named,
                 const FemMeshes<d>& meshes)
      : Bodies<d>(meshes), previous_(stated_previous(stack, named, *this)) {
    state(stack, named, nullptr);
  }
  /// The same of bodies that processes hold parts of.
  ContactProblem(Stack stack, const NamedArguments& named,
                 JoinedBodies<d> whole, const PlacesElsewhere<d>& elsewhere,
                 VectorXd previous)
      : Bodies<d>(std::move(whole)), previous_(std::move(previous)) {
    state(stack, named, &elsewhere);
  }
  ContactProblem(const ContactProblem&) = delete;
  ContactProblem& operator=(const ContactProblem&) = delete;

  /// Moves the multipliers of pairs whose side is not stated to the side that is to carry them,
  /// one for all pairs of the same bodies: where their lines meet nodes of both sides would
  /// stand for one jump.
  void choose_sides(const ElasticSystem& system);

  /// The joined mesh with its facets and stars: of plane bodies made once; that of solids,
  /// which is large, is the caller's.
  /// @throws std::invalid_argument  if a body touches itself in a single vertex
  std::conditional_t<d == 2, const Topology<d>&, Topology<d>> topology() const;

  /// Of the nodes [mm, d x p].
  Matrix<double, d, Dynamic> places() const {
    return mesh.vertices(Eigen::all, this->contact.vertex).colwise() +
           mesh.origin;
  }

  /// -1 at nodes of side 2, whose contact direction points into the body that comes first, 1 at
  /// others [p].
  VectorXd own_signs() const;
  /// Contact directions out of the body that comes first [d x p].
  Matrix<double, d, Dynamic> own_normals() const {
    return this->contact.normal * own_signs().asDiagonal();
  }

 private:
  void state(Stack stack, const NamedArguments& named,
             const PlacesElsewhere<d>* elsewhere);
  const Carrier<d>& carrier_of(std::size_t k) const {
    const PairSides<d>& pair = pairs_[k];
    return !pair.rigid && side[k] == 2 ? *pair.other : pair.own;
  }
  void join_carriers();

  /// The side that pairs of the same bodies want: a stated one, or that which yields more; by
  /// the bodies.
  std::map<std::set<int>, int> wanted_sides(const ElasticSystem& system) const;

  std::vector<PairSides<d>> pairs_;
  std::vector<std::set<int>> bodies_of_pair_;
  CompliantLayer layer_;
  VectorXd previous_;  ///< displacement of the load step before; empty for none
  mutable std::optional<Topology<2>> topology_;  ///< made when an estimate asks
};

template <int d>
void ContactProblem<d>::state(Stack stack, const NamedArguments& named,
                              const PlacesElsewhere<d>* elsewhere) {
  if (d == 3) require_no_corner(named);
  const double corner = stated_corner(stack, named);
  layer_ = stated_layer(stack, named);
  const auto stated = stated_pairs(stack, named, this->joined);
  for (const StatedPair& pair : stated) {
    body_of_pair.push_back(pair.body);
    bodies_of_pair_.push_back(bodies_of(pair, this->joined));
  }
  pairs_ =
      read_sides(Statement<d>{stack, named, *this, elsewhere, corner}, stated);
  for (const PairSides<d>& pair : pairs_)
    if (!pair.rigid) side.push_back(std::max(1, pair.wanted));
  join_carriers();
}

template <int d>
std::map<std::set<int>, int> ContactProblem<d>::wanted_sides(
    const ElasticSystem& system) const {
  std::map<std::set<int>, int> wanted;
  std::map<std::set<int>, double> softness;  // of the first side, a logarithm
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const PairSides<d>& pair = pairs_[k];
    if (pair.rigid) continue;
    if (pair.wanted != 0 || !pair.other)
      wanted.emplace(bodies_of_pair_[k], std::max(1, pair.wanted));
    else
      softness[bodies_of_pair_[k]] +=
          std::log(pair.compliance_ratio(system) / much_softer);
  }
  for (const auto& [bodies, sum] : softness)
    wanted.emplace(bodies, sum > 0 ? 2 : 1);
  return wanted;
}

template <int d>
void ContactProblem<d>::choose_sides(const ElasticSystem& system) {
  const std::map<std::set<int>, int> wanted = wanted_sides(system);
  for (std::size_t k = 0; k < pairs_.size(); ++k)
    if (pairs_[k].wanted == 0 && pairs_[k].other)
      side[k] = wanted.find(bodies_of_pair_[k])->second;
  join_carriers();
}

template <int d>
VectorXd ContactProblem<d>::own_signs() const {
  VectorXd signs = VectorXd::Ones(count_of(this->own_vertex));
  for (std::size_t k = 0; k < pairs_.size(); ++k)
    if (&carrier_of(k) != &pairs_[k].own)
      signs.segment(first_node[k], first_node[k + 1] - first_node[k])
          .setConstant(-1);
  return signs;
}

template <int d>
void ContactProblem<d>::join_carriers() {
  Carrier<d>& all = *this;
  all = {};
  first_node = {0};
  std::vector<LineOrSurface<d>> contacts;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const Carrier<d>& carrier = carrier_of(k);
    contacts.push_back(carrier.contact);
    append_stated(carrier, all);
    first_node.push_back(count_of(all.own_vertex));
  }
  all.contact = joined_contact<d>(contacts);
  if (!all.law.has_bonded()) all.law.bonded.clear();
  if (previous_.size() > 0)
    all.law.previous = without_bonded<d, Matrix<double, d - 1, Dynamic>>(
        all.law, contact_components(all.contact, previous_)
                     .template bottomRows<d - 1>());
  all.law.layer = layer_;
  require_valid(all.law, all.contact);
  if (all.kinetic.given())
    require_kinetic(all.kinetic.friction, all.law.friction);
}

template <int d>
std::conditional_t<d == 2, const Topology<d>&, Topology<d>>
ContactProblem<d>::topology() const {
  if constexpr (d == 3) {
    return topology_of(mesh, this->facets);
  } else {
    if (!topology_) topology_ = topology_of(mesh, this->facets);
    return *topology_;
  }
}

}  // namespace ffcontact::plugin
