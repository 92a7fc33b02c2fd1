// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/interface/joined_contact.hpp"
#include "ffcontact/interface/pairing/facing_surface.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"
#include "support/solid_problems.hpp"

/// Solids that face each other.
namespace ffcontact::test {

/// A brick of random cells from `low` on, moved and in random order.
inline SolidMesh random_brick(const Vector3i& cells, const Vector3d& low,
                              const Vector3d& size, std::mt19937& random) {
  const Vector3d cell = size.cwiseQuotient(cells.cast<double>());
  SolidMesh mesh = shuffled(
      moved(brick(cells, size), cell.minCoeff(), 0.15, random), random);
  mesh.vertices.colwise() += low;
  return mesh;
}

/// A surface of a joined mesh with what it faces.
inline FacingSurface facing(const SolidMesh& mesh, const Facets<3>& faces,
                            int label, int opposite_label) {
  const ContactSurface whole = contact_surface(mesh, faces, {label});
  return facing_surface(mesh, faces, whole,
                        facing_polygons(mesh, faces, whole, {opposite_label}));
}

/// Bodies of one material as a stack: the side low_z of each faces the side high_z of
/// the next.
struct SolidStack {
  JoinedSolids joined;
  SolidProblem problem;

  SolidStack(const std::vector<SolidMesh>& bodies, double friction)
      : joined(joined_mesh(bodies)),
        problem(joined.mesh, friction, {label(0, low_z)}) {
    std::vector<ContactSurface> surfaces;
    std::vector<double> gap;
    for (int k = 0; k + 1 < joined.body_count(); ++k) {
      const FacingSurface pair = facing(problem.mesh, problem.faces,
                                        label(k, low_z), label(k + 1, high_z));
      surfaces.push_back(pair.surface);
      gap.insert(gap.end(), pair.gap.begin(), pair.gap.end());
    }
    problem.surface = joined_contact<3>(surfaces);
    problem.law.friction =
        VectorXd::Constant(problem.surface.node_count(), friction);
    problem.law.gap = Map<VectorXd>(gap.data(), problem.surface.node_count());
  }

  int label(int body, int side) const { return joined.label(body, side); }
  int last() const { return joined.body_count() - 1; }
  /// A body between two smooth walls.
  void guide(int body) {
    problem.guide(label(body, low_x), 0);
    problem.guide(label(body, low_y), 1);
  }
};

}  // namespace ffcontact::test
