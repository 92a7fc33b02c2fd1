// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/solve_contact.hpp"
#include "ffcontact/elastic/loads_and_supports.hpp"
#include "ffcontact/elastic/stiffness.hpp"
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "ffcontact/mesh/facets.hpp"
#include "support/solids.hpp"

/// Solids on a rigid foundation that the tests share.
namespace ffcontact::test {

/// A body of E = 13000 MPa, nu = 0.2 as a script states it, its side low_z on a rigid
/// plane.
struct SolidProblem {
  SolidMesh mesh;
  Facets<3> faces;
  ContactSurface surface;
  ContactLaw<3> law;
  RowMatrix A;
  VectorXd b;
  FaceMoments neumann;  ///< of the loads on sides

  explicit SolidProblem(const SolidMesh& solid, double friction = 0,
                        std::vector<int> labels = {low_z})
      : mesh(solid),
        faces(facets_of(mesh)),
        surface(contact_surface(mesh, faces, labels)),
        A(stiffness(mesh, HookeTensors<3>(
                              mesh.cell_count(),
                              isotropic<3>(13e3 * 0.2 / 0.72, 13e3 / 2.4)))),
        b(VectorXd::Zero(A.rows())),
        neumann(FaceMoments::Zero(9, mesh.boundary.cols())) {
    law.friction = VectorXd::Constant(surface.node_count(), friction);
  }

  ElasticSystem system() const { return elastic_system(A, b, 3); }
  ContactSolution<3> solve(const ContactSettings& settings = {}) const {
    return solve_contact(mesh, surface, law, system(), settings);
  }

  void prescribe(int vertex, int component, double value) {
    const int dof = 3 * vertex + component;
    A.coeffRef(dof, dof) = 1e30;
    b[dof] = 1e30 * value;
  }
  /// u_c = 0 on a side.
  void guide(int side, int component) {
    for (int v : vertices_on(mesh, side)) prescribe(v, component, 0);
  }
  void move(int side, const SolidField& u) {
    for (int v : vertices_on(mesh, side)) {
      const Vector3d value = u(mesh.vertices.col(v));
      for (int c = 0; c < 3; ++c) prescribe(v, c, value[c]);
    }
  }
  /// A traction [MPa], constant on a side.
  void load(int side, const Vector3d& traction) {
    add_traction(mesh, side, traction, b, neumann);
  }
};

/// Load cases of a block 80 x 40 x 40 whose side high_z is held.
enum class BlockCase { press, press_x, shear, lift };

inline SolidProblem block_problem(const SolidMesh& mesh, BlockCase loads,
                                  double friction) {
  SolidProblem problem(mesh, friction);
  if (loads == BlockCase::press || loads == BlockCase::press_x) {
    problem.load(high_x, {-10, 0, 0});
    if (loads == BlockCase::press) problem.load(high_y, {0, -5, 0});
    problem.guide(low_x, 0);
    problem.guide(low_y, 1);
    problem.move(high_z, [](const Vector3d&) { return Vector3d::Zero(); });
  } else if (loads == BlockCase::shear) {
    problem.move(high_z,
                 [](const Vector3d&) { return Vector3d(0.02, 0.01, -0.03); });
  } else {
    problem.move(high_z, [](const Vector3d& x) {
      return Vector3d(0.02, 0, -0.02 + 0.001 * x.x());
    });
  }
  return problem;
}

}  // namespace ffcontact::test
