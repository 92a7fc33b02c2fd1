// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/contact/law/surface_law.hpp"
#include "ffcontact/interface/pairing/facing_surface.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"
//
#include "freefem/arguments.hpp"
#include "freefem/solid_values.hpp"
#include "problem/bodies.hpp"
#include "problem/contact_statement.hpp"
#include "problem/stated_pairs.hpp"

namespace ffcontact::plugin {

/// A contact problem of solids as a script states it, with the parameters, bodies and
/// sides of ContactProblem: one mesh3 or several; normal=[nx, ny, nz] is one contact
/// direction a vertex in place of the faces' normals. All is evaluated when it is stated.
struct SolidProblem : Bodies<3> {
  const SolidMesh& mesh = joined.mesh;
  ContactSurface surface;
  SurfaceLaw law;
  KineticFriction kinetic;
  /// of each node, or nearest to what it faces, in the mesh of the body that comes first
  std::vector<long> own_vertex;
  /// where the nodes of each pair begin, and their number
  std::vector<long> first_node;
  /// that carries the multipliers, 1 or 2, of each pair; none on a rigid foundation
  std::vector<long> side;
  std::vector<int> body_of_pair;  ///< that comes first

  /// @throws std::invalid_argument  if a mesh, a label or a coefficient is not usable
  SolidProblem(Stack stack, const NamedArguments& named,
               const std::vector<pmesh3>& meshes);
  /// The same of bodies that processes hold parts of.
  SolidProblem(Stack stack, const NamedArguments& named, JoinedSolids whole,
               const PlacesElsewhere<3>& elsewhere, VectorXd previous);
  SolidProblem(const SolidProblem&) = delete;
  SolidProblem& operator=(const SolidProblem&) = delete;

  /// Moves the multipliers of each pair whose side is not stated to the side that is to
  /// carry them.
  void choose_sides(const ElasticSystem& system);

  Matrix3Xd places() const;  ///< of the nodes [mm, 3 x p]

 private:
  /// The surface of one pair of bodies that carries the multipliers, with what belongs to
  /// its nodes.
  struct Carrier {
    ContactSurface surface;
    SurfaceLaw law;
    VectorXd kinetic;  ///< mu of what slips; empty where it is not given
    std::vector<long> own_vertex;
  };
  struct Pair {
    int wanted = 0;  ///< side, or 0
    ContactSurface whole;
    std::vector<FacingPolygon> polygons;  ///< none on a rigid foundation
    Carrier own;
    std::optional<Carrier> other;
  };

  void state(Stack stack, const NamedArguments& named);
  ContactSurface stated_surface(Stack stack, const NamedArguments& named,
                                int body, const std::vector<int>& labels) const;
  void require_one_side(const StatedPair& stated,
                        const ContactSurface& whole) const;
  std::vector<FacingPolygon> smooth_polygons(
      const ContactSurface& whole, const std::vector<int>& opposite) const;
  void add_pair(Stack stack, const NamedArguments& named,
                const StatedPair& stated);
  void add_facing_pair(Stack stack, const NamedArguments& named,
                       const StatedPair& stated, Pair pair);
  Carrier exchanged(Stack stack, const NamedArguments& named,
                    const StatedPair& stated) const;
  std::optional<Carrier> as_good(const Carrier& own, Stack stack,
                                 const NamedArguments& named,
                                 const StatedPair& stated) const;
  Carrier carrier(Stack stack, const NamedArguments& named, int body,
                  FacingSurface facing,
                  const std::vector<FacePlace>& places) const;
  void append_carrier(const Carrier& carrier);
  void join_carriers();

  std::vector<Pair> pairs_;
  /// while it is stated
  const PlacesElsewhere<3>* elsewhere_ = nullptr;
  CompliantLayer layer_;
  VectorXd previous_;  ///< displacement of the load step before; empty for none
};

}  // namespace ffcontact::plugin
