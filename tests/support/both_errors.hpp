// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <cmath>

#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "support/solid_estimates.hpp"

/// The error of an admissible pair of solids against a finer mesh.
namespace ffcontact::test {

/// The barycentric coordinates on a face of another one that lies in it and is seen from
/// the same side [3 x 3]; nothing, with 0 columns, where it does not.
inline Matrix3Xd places_on_face(const Matrix3d& face, const Matrix3d& other) {
  const Vector3d vector = facet_vector(face), n = vector.normalized();
  Matrix4d at;
  at << face, n, Eigen::RowVector4d(1, 1, 1, 0);
  Matrix<double, 4, 3> points;
  points << other, Eigen::RowVector3d::Ones();
  const Matrix<double, 4, 3> places = at.inverse() * points;
  const double size = std::sqrt(vector.norm());
  const bool is_inside = places.topRows<3>().minCoeff() > -1e-9 &&
                         places.row(3).cwiseAbs().maxCoeff() < 1e-9 * size &&
                         facet_vector(other).dot(n) > 0;
  return is_inside ? Matrix3Xd(places.topRows<3>()) : Matrix3Xd(3, 0);
}

/// int of sigma_hat n . u over the boundary, which is int of sigma_hat : eps(u) where
/// there are no body forces.
/// @param moments  of sigma_hat on the faces of the coarse mesh
/// @param u        on the fine mesh, whose boundary faces lie in those of the coarse one
inline double boundary_work(const SolidProblem& coarse,
                            const FaceMoments& moments,
                            const SolidProblem& fine, const VectorXd& u) {
  double work = 0, covered = 0, whole = 0;
  for (int f = 0; f < coarse.faces.count(); ++f) {
    if (!coarse.faces.on_boundary(f)) continue;
    const Matrix3d corners =
        coarse.mesh.vertices(Eigen::all, coarse.faces.vertices.col(f));
    const double area = facet_measure(coarse.mesh, coarse.faces, f);
    const Matrix3d of_face = moments.col(f).reshaped(3, 3),
                   density = facet_density<3>(of_face, area);
    whole += area;
    for (int g = 0; g < fine.faces.count(); ++g) {
      if (!fine.faces.on_boundary(g)) continue;
      const Vector3i vertices = fine.faces.vertices.col(g);
      const Matrix3Xd places =
          places_on_face(corners, fine.mesh.vertices(Eigen::all, vertices));
      if (places.cols() == 0) continue;
      const double part = facet_measure(fine.mesh, fine.faces, g);
      covered += part;
      const Matrix3d on_part =
          facet_moments_of<3>(Matrix3d(density * places), part);
      for (int k = 0; k < 3; ++k)
        work += on_part.col(k).dot(u.segment<3>(3 * vertices[k]));
    }
  }
  EXPECT_NEAR(covered / whole, 1, 1e-12);
  return work;
}

/// |sigma - sigma_hat|^2 + |u - u_hat|^2, integrated exactly, with the solution u on a finer
/// mesh in place of the exact one. Without friction and with Tresca's law it is not larger
/// than e^2, nor is it for that solution where its contact nodes are among those of faces
/// that match: (2.20) holds in it term by term.
/// @param u_hat  that of the estimate on the fine mesh
inline double both_errors_square(const SolidProblem& coarse,
                                 const Estimate<3>& found,
                                 const SolidProblem& fine, const VectorXd& u,
                                 const VectorXd& u_hat) {
  const RowMatrix K = stiffness(fine.mesh, solved_solid(fine, {}).hooke);
  const double sum = found.e / found.relative, of_u_hat = u_hat.dot(K * u_hat),
               of_u = u.dot(K * u),
               of_sigma_hat =
                   (found.elastic * found.elastic + sum * sum) / 2 - of_u_hat;
  const VectorXd off = u - u_hat;
  return of_sigma_hat - 2 * boundary_work(coarse, found.moments, fine, u) +
         of_u + off.dot(K * off);
}

}  // namespace ffcontact::test
