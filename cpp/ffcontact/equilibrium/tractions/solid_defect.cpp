// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/solid_defect.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Largest difference of the tractions on the outer faces to those with given moments.
double outer_jump(const TetrahedronCorners& corners, const SolidStress& stress,
                  const FaceLoads& on_faces) {
  const TetrahedronCorners vectors = face_vectors(corners);
  double largest = 0;
  for (int k = 0; k < 4; ++k) {
    const Vector3d n = vectors.col(k).normalized();
    const Matrix3d moments = on_faces.middleCols<3>(3 * k);
    Matrix3d jump = face_density(moments, vectors.col(k).norm());
    for (int j = 0; j < 3; ++j)
      jump.col(j) -= traction(stress.col(4 * k + j), n);
    largest = std::max(largest, max_norm(jump));
  }
  return largest;
}

Matrix3d density_on(const SolidMesh& mesh, const Facets<3>& faces, int face,
                    const FaceMoments& moments) {
  const Matrix3d of_face = moments.col(face).reshaped(3, 3);
  return face_density(of_face, facet_measure(mesh, faces, face));
}

}  // namespace

EquilibriumDefect tetrahedron_defect(const TetrahedronCorners& corners,
                                     const SolidStress& stress,
                                     const FaceLoads& on_faces,
                                     const SolidBodyLoads& body_loads) {
  const double volume = piola_matrix(corners).determinant() / 6,
               largest_face = face_vectors(corners).colwise().norm().maxCoeff();
  EquilibriumDefect defect;
  defect.divergence = volume / largest_face *
                      max_norm(divergences(corners, stress) +
                               body_force_of(body_loads, volume));
  defect.jump = std::max(max_norm(inner_jumps(corners, stress)),
                         outer_jump(corners, stress, on_faces));
  return defect;
}

double boundary_defect(const SolidMesh& mesh, const Facets<3>& faces,
                       const FaceTractions& boundary,
                       const FaceMoments& moments) {
  double largest = 0;
  for (int f = 0; f < faces.count(); ++f) {
    if (!boundary.known.col(f).any()) continue;
    const Matrix3d off = density_on(mesh, faces, f, moments) -
                         density_on(mesh, faces, f, boundary.moments);
    for (int c = 0; c < 3; ++c)
      if (boundary.known(c, f))
        largest = std::max(largest, max_norm(off.row(c)));
  }
  return largest;
}

double largest_traction(const SolidMesh& mesh, const Facets<3>& faces,
                        const FaceMoments& moments) {
  double largest = 0;
#pragma omp parallel for reduction(max : largest)
  for (int f = 0; f < faces.count(); ++f)
    largest = std::max(largest, max_norm(density_on(mesh, faces, f, moments)));
  return largest;
}

}  // namespace ffcontact
