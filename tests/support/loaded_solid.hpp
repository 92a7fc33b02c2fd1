// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "ffcontact/elastic/stiffness.hpp"
#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "ffcontact/mesh/topology.hpp"
#include "support/free_displacement.hpp"
#include "support/solids.hpp"
#include "support/uniform.hpp"

/// Solids without contact, with all that their stresses have to balance.
namespace ffcontact::test {

struct LoadedSolid {
  Topology<3> topology;
  HookeTensors<3> hooke;
  RowMatrix A;
  VectorXd b;
  FaceMoments neumann;
  BodyLoadsOfCells<3> body_loads;

  explicit LoadedSolid(const SolidMesh& solid, double E = 1, double nu = 0.3)
      : topology(topology_of(solid)),
        hooke(solid.cell_count(),
              isotropic<3>(E * nu / (1 + nu) / (1 - 2 * nu), E / 2 / (1 + nu))),
        A(stiffness(solid, hooke)),
        b(VectorXd::Zero(A.rows())),
        neumann(FaceMoments::Zero(9, solid.boundary.cols())),
        body_loads(BodyLoadsOfCells<3>::Zero(12, solid.cell_count())) {}

  const SolidMesh& mesh() const { return topology.mesh; }
  ElasticSystem system() const { return elastic_system(A, b, 3); }
  FaceTractions boundary() const {
    return given_tractions(mesh(), topology.facets, system().prescribed,
                           neumann);
  }
  CellStresses<3> stress(const VectorXd& u) const {
    return stresses(mesh(), hooke, u);
  }
  CellStresses<3> computed_stress() const {
    return stress(displacement(system()));
  }

  void prescribe(int vertex, int component, double value) {
    const int dof = 3 * vertex + component;
    A.coeffRef(dof, dof) = 1e30;
    b[dof] = 1e30 * value;
  }
  /// u_c on a side.
  void guide(int side, int component, const SolidField& u) {
    for (int v : vertices_on(mesh(), side))
      prescribe(v, component, u(mesh().vertices.col(v))[component]);
  }
  void move(int side, const SolidField& u) {
    for (int c = 0; c < 3; ++c) guide(side, c, u);
  }
  /// The traction that is linear between its values at the vertices of a side.
  void load(int side, const SolidField& traction) {
    for (Index f = 0; f < mesh().boundary.cols(); ++f) {
      if (mesh().boundary_label[f] != side) continue;
      const Matrix3d x = mesh().vertices(Eigen::all, mesh().boundary.col(f));
      Matrix3d density;
      for (int k = 0; k < 3; ++k) density.col(k) = traction(x.col(k));
      const Matrix3d moments =
          facet_moments_of<3>(density, facet_vector(x).norm());
      neumann.col(f) += moments.reshaped();
      for (int k = 0; k < 3; ++k)
        b.segment<3>(3 * mesh().boundary(k, f)) += moments.col(k);
    }
  }
  /// int f phi_i on one tetrahedron.
  void push(int t, const CellBodyLoads<3>& loads) {
    body_loads.col(t) += loads.reshaped();
    for (int k = 0; k < 4; ++k)
      b.segment<3>(3 * mesh().cells(k, t)) += loads.col(k);
  }
};

/// Clamped below, guided on two sides, loaded on the others and in the body, all at
/// random.
inline LoadedSolid random_loaded_solid(const SolidMesh& solid,
                                       std::mt19937& random) {
  const Uniform entry{-1, 1};
  const auto any = [&](const Vector3d&) {
    return Vector3d(entry(random), entry(random), entry(random));
  };
  LoadedSolid body(solid);
  body.load(high_x, any);
  body.load(high_z, any);
  body.load(low_y, [&](const Vector3d& x) {  // not along the guided component
    return Vector3d(entry(random), 0 * x.y(), entry(random));
  });
  for (int t = 0; t < solid.cell_count(); ++t)
    body.push(t, CellBodyLoads<3>::NullaryExpr([&] { return entry(random); }));
  body.guide(low_y, 1, any);
  body.guide(low_x, 0, [](const Vector3d&) { return Vector3d(0, 0, 0); });
  body.move(low_z, any);
  return body;
}

}  // namespace ffcontact::test
