// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/stress_norms.hpp"

#include <Eigen/LU>

#include "ffcontact/equilibrium/stress/polynomial_stress.hpp"

namespace ffcontact {

namespace {

struct TriangleNorms {
  double difference, sum;
  CompositeStress stress;
};

template <class OfTriangle>
StressNorms norms_of_all(int triangles, const OfTriangle& of_triangle) {
  StressNorms norms{VectorXd(triangles), 0,
                    std::vector<CompositeStress>(triangles)};
  VectorXd sum(triangles);
#pragma omp parallel for
  for (int t = 0; t < triangles; ++t) {
    const TriangleNorms own = of_triangle(t);
    norms.difference[t] = own.difference;
    norms.stress[t] = own.stress;
    sum[t] = own.sum;
  }
  norms.sum = sum.sum();
  return norms;
}

}  // namespace

StressNorms composite_norms(const Mesh& mesh, const Hooke& hooke,
                            const LinearStresses& stress,
                            const EdgeLoadsOfAll& difference,
                            const BodyLoadsOfAll& body_loads) {
  return norms_of_all(mesh.cell_count(), [&](int t) -> TriangleNorms {
    const TriangleCorners corners = corners_of(mesh, t);
    const Matrix3d compliance = hooke[t].inverse();
    const CompositeStress sigma = composite_of(stress.at_vertices(t));
    const CompositeStress tau =
        composite_stress(corners, difference.col(t), body_loads.col(t));
    return {energy(corners, compliance, tau),
            energy(corners, compliance, tau + 2 * sigma), sigma + tau};
  });
}

StressNorms polynomial_norms(const Mesh& mesh, const Hooke& hooke,
                             const LinearStresses& stress,
                             const EdgeLoadsOfAll& difference,
                             const BodyLoadsOfAll& body_loads) {
  return norms_of_all(mesh.cell_count(), [&](int t) -> TriangleNorms {
    const PolynomialStress tau = polynomial_stress(
        corners_of(mesh, t), hooke[t], difference.col(t), body_loads.col(t));
    const Matrix3d sigma = stress.at_vertices(t);
    return {energy(tau, Matrix3d::Zero()), energy(tau, 2 * sigma),
            corner_values(tau) + composite_of(sigma)};
  });
}

}  // namespace ffcontact
