// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/estimate/error/facing_faces.hpp"
#include "ffcontact/mesh/topology.hpp"
#include "support/solid_stacks.hpp"

/// Two bricks whose meshes do not match, with the contact faces that may be relaxed.
namespace ffcontact::test {

struct FacingContact {
  SolidStack stack;
  Topology<3> topology;
  HookeTensors<3> hooke;
  VectorXd displacement;  ///< of all dofs
  std::vector<ContactFacet<3>> contact;
  Matrix3Xd nodal;                  ///< tractions before
  std::vector<Matrix3d> tractions;  ///< of contact

  /// @param low  of the lower brick, 3 x 2 x 1 as the upper one, which stands on z = 0
  FacingContact(const Vector3d& low, double friction, Random& random)
      : stack(
            {random_brick(random_cells(2, 3, random), {0, 0, 0}, {3, 2, 1},
                          random),
             random_brick(random_cells(2, 4, random), low, {3, 2, 1}, random)},
            friction),
        topology(topology_of(stack.problem.mesh)),
        hooke(topology.mesh.cell_count(), isotropic<3>(2, 1)),
        displacement(1e-3 * random_vector(stack.problem.b.size(), random)),
        contact(facing_faces(topology.mesh, topology.facets,
                             stack.problem.surface, stack.problem.law,
                             displacement)),
        nodal(random_tractions(stack.problem.surface.node_count(), random)) {
    for (std::size_t m = 0; m < contact.size(); ++m)
      tractions.push_back(random_tractions(3, random));
  }

  const ContactSurface& surface() const { return stack.problem.surface; }

  /// Of all faces, where those of contact are not continuous.
  SurfaceTractions on_faces() const {
    SurfaceTractions all = tractions_by_face(surface(), nodal);
    for (std::size_t m = 0; m < contact.size(); ++m)
      all.col(contact[m].index) = tractions[m].reshaped();
    return all;
  }

 private:
  static Matrix3Xd random_tractions(Index count, Random& random) {
    Matrix3Xd tractions = random_matrix(3, count, random);
    tractions.row(0) = -tractions.row(0).cwiseAbs();
    return tractions;
  }
};

}  // namespace ffcontact::test
