// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/solid_residual.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// |T| sigma grad phi_i on each tetrahedron of the star of vertex i.
Matrix3Xd solid_star_forces(const SolidTopology& topology, int vertex,
                            const Ref<const Matrix6Xd>& stress) {
  const SolidStars& stars = topology.stars;
  Matrix3Xd forces(3, stars.count(vertex));
  for (int k = 0; k < forces.cols(); ++k) {
    const int place = stars.start[vertex] + k, t = stars.cell[place];
    const TetrahedronCorners vectors =
        face_vectors(corners_of(topology.mesh, t));
    // |T| grad phi_i = -A n / 3 of the opposite face
    const Vector3d gradient = vectors.col(stars.local[place]) / -3;
    forces.col(k) = traction(stress.col(t), gradient);
  }
  return forces;
}

/// Calls of_face(face) for the boundary faces at a vertex.
template <class OfFace>
void for_boundary_faces(const SolidTopology& topology, int vertex,
                        const OfFace& of_face) {
  const SolidStars& stars = topology.stars;
  for (int k = stars.start[vertex]; k < stars.start[vertex + 1]; ++k)
    for (int j = 1; j < 4; ++j) {
      const int opposite = (stars.local[k] + j) % 4,
                face = topology.faces.of_cell(opposite, stars.cell[k]);
      if (topology.faces.on_boundary(face)) of_face(face);
    }
}

/// Adds a force on a vertex where no support answers.
void add_force(const Vector3d& force, int vertex, SolidResidual& residual) {
  for (int c = 0; c < 3; ++c)
    if (!residual.supported(c, vertex)) residual.missing(c, vertex) += force[c];
}

/// Adds a force on a vertex and the moments of the boundary tractions there, whose
/// supports are noted.
void add_with_tractions(Vector3d force, const SolidTopology& topology,
                        int vertex, const FaceTractions& boundary,
                        SolidResidual& residual) {
  for_boundary_faces(topology, vertex, [&](int face) {
    const int place = topology.faces.place_of(vertex, face);
    force += boundary.moments.col(face).segment<3>(3 * place);
    for (int c = 0; c < 3; ++c)
      if (!boundary.known(c, face)) residual.supported(c, vertex) = true;
  });
  add_force(force, vertex, residual);
}

}  // namespace

Matrix3Xd star_loads(const SolidTopology& topology, int vertex,
                     const Ref<const Matrix6Xd>& stress,
                     const SolidBodyLoadsOfAll& body_loads) {
  const SolidStars& stars = topology.stars;
  Matrix3Xd loads = solid_star_forces(topology, vertex, stress);
  for (int k = 0; k < loads.cols(); ++k) {
    const int place = stars.start[vertex] + k;
    loads.col(k) -=
        body_loads.col(stars.cell[place]).segment<3>(3 * stars.local[place]);
  }
  return loads;
}

SolidResidual nodal_residual(const SolidTopology& topology,
                             const Ref<const Matrix6Xd>& stress,
                             const SolidBodyLoadsOfAll& body_loads,
                             const FaceTractions& boundary) {
  const int vertices = topology.mesh.vertex_count();
  SolidResidual residual{Matrix3Xd::Zero(3, vertices), {}, 0};
  residual.supported.setConstant(3, vertices, false);
  double scale = max_norm(boundary.moments);
#pragma omp parallel for reduction(max : scale)
  for (int v = 0; v < vertices; ++v) {
    if (topology.stars.count(v) == 0) continue;
    const Matrix3Xd loads = star_loads(topology, v, stress, body_loads);
    scale = std::max(scale, max_norm(loads));
    add_with_tractions(-loads.rowwise().sum(), topology, v, boundary, residual);
  }
  residual.scale = scale;
  return residual;
}

SolidResidual with_forces(SolidResidual residual, const VectorXd& forces) {
  const Matrix3Xd added = forces.reshaped(3, residual.missing.cols());
  residual.missing += residual.supported.select(0, added);
  residual.scale = std::max(residual.scale, max_norm(forces));
  return residual;
}

SolidResidual less_stress(const SolidTopology& topology, SolidResidual residual,
                          const Ref<const Matrix6Xd>& added) {
#pragma omp parallel for
  for (int v = 0; v < topology.mesh.vertex_count(); ++v) {
    if (topology.stars.count(v) == 0) continue;
    const Vector3d sum = solid_star_forces(topology, v, added).rowwise().sum();
    add_force(-sum, v, residual);
  }
  return residual;
}

}  // namespace ffcontact
