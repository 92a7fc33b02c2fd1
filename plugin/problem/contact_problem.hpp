// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"
#include "ffcontact/mesh/topology.hpp"
//
#include "problem/bodies.hpp"
#include "problem/contact_statement.hpp"
#include "problem/stated_pairs.hpp"

namespace ffcontact::plugin {

/// Reads multiplier=: what pn and pt stand for.
/// @throws std::invalid_argument  if it is neither "force" nor "pressure"
Multiplier multiplier_of(Stack stack, const NamedArguments& named);

/// A contact problem as a script states it: one mesh or several, and label=, friction=,
/// kineticfriction=, slipbound=, compliance=, gap=, normal=[nx, ny] (one contact direction a
/// vertex in place of the lines' and smooth curves' normals), corner= (BoundaryCurves),
/// previous= (displacement of the load step before; an empty array is none), side= (1 or 2:
/// which body of a pair carries the multipliers). All is evaluated when it is stated.
///
/// One mesh: label= faces a rigid foundation, or the labels opposite= of the same mesh,
/// which then is of bodies that share no vertex. Several meshes: body k faces body k + 1,
/// with label1=, label2=, ... in place of label=; bodies between two others have two
/// labels, the first faces the body before, the second the one after. Coefficients are
/// those of the body that comes first. Without gap= the gap against a body is that of the
/// meshes.
///
/// The multipliers are on the line of the body that comes first (side 1), or, where the
/// other's line can carry them and yields much more (compliance_ratio), on that (side 2).
/// Both are prepared; it is side 1 until choose_sides knows the matrices.
struct ContactProblem : Bodies<2> {
  const Mesh& mesh = joined.mesh;
  ContactLine line;
  ContactLaw law;  ///< multiplier left at its default
  KineticFriction kinetic;
  std::vector<long>
      /// of each node, or nearest to what it faces, in the mesh of the body that comes
      /// first
      own_vertex;
  /// of each node, or of what it faces, on the line of the body that comes first [mm]
  VectorXd abscissa;
  /// of each node, out of the body that comes first [2 x p]
  Matrix2Xd own_normal;
  Matrix2Xd
      edge_abscissa;  ///< likewise of the ends of each contact edge [2 x m]
  /// of each pair: the first of its nodes; then the number of all nodes
  std::vector<long> first_node;
  /// that carries the multipliers, 1 or 2, of each pair; none on a rigid foundation
  std::vector<long> side;
  std::vector<int> body_of_pair;  ///< that comes first

  /// @throws std::invalid_argument  if a mesh, a label or a coefficient is not usable
  ContactProblem(Stack stack, const NamedArguments& named,
                 const std::vector<pmesh>& meshes);
  /// The same of bodies that processes hold parts of.
  ContactProblem(Stack stack, const NamedArguments& named, JoinedMesh whole,
                 const PlacesElsewhere<2>& elsewhere, VectorXd previous);
  ContactProblem(const ContactProblem&) = delete;
  ContactProblem& operator=(const ContactProblem&) = delete;

  /// Moves the multipliers of each pair whose side is not stated to the side that is to
  /// carry them.
  void choose_sides(const ElasticSystem& system);

  /// The joined mesh with its edges and stars, made once.
  /// @throws std::invalid_argument  if a body touches itself in a single vertex
  const Topology<2>& topology() const;

  /// Nodal pressures from the script's pn and pt [2 x p].
  Matrix2Xd pressures(KN<double>* normal, KN<double>* tangential) const;

 private:
  /// The line of one pair of bodies that carries the multipliers, with what belongs to
  /// its nodes and edges.
  struct Carrier {
    ContactLine line;
    StatedLaw stated;
    std::vector<long> own_vertex;
    VectorXd abscissa;
    Matrix2Xd edge_abscissa;
  };
  struct Pair {
    bool rigid;
    int wanted;  ///< side, or 0
    Carrier own;
    std::optional<Carrier> other;
  };

  void state(Stack stack, const NamedArguments& named);
  ContactLine own_line(Stack stack, const NamedArguments& named,
                       const StatedPair& pair) const;
  void require_one_side(const StatedPair& pair, const ContactLine& own) const;
  void add_pair(Stack stack, const NamedArguments& named,
                const StatedPair& pair);
  void add_facing_pair(Stack stack, const NamedArguments& named,
                       const StatedPair& stated, const ContactLine& own);
  Carrier carrier(Stack stack, const NamedArguments& named, int body,
                  const ContactLine& stated, ContactLine line,
                  bool on_opposite) const;
  void join_carriers();
  void clear_line();
  void append_carrier(const Carrier& carrier, bool on_opposite);

  mutable std::optional<Topology<2>> topology_;  ///< made when an estimate asks
  std::vector<Pair> pairs_;
  double corner_ = 0;  ///< of curves [degrees]
  BoundaryCurves curves_;
  /// while it is stated
  const PlacesElsewhere<2>* elsewhere_ = nullptr;
  CompliantLayer layer_;
  VectorXd previous_;  ///< displacement of the load step before; empty for none
};

}  // namespace ffcontact::plugin
