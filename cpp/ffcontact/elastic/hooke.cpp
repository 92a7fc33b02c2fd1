// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/hooke.hpp"

#include <Eigen/Cholesky>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

Matrix3d isotropic(double lambda, double G) {
  Matrix3d C;
  C << lambda + 2 * G, lambda, 0,  //
      lambda, lambda + 2 * G, 0,   //
      0, 0, G;
  return C;
}

void require_elliptic(const Hooke& hooke, int triangle_count) {
  require_size("Hooke's tensor", static_cast<Index>(hooke.size()), triangle_count);
  for (std::size_t t = 0; t < hooke.size(); ++t) {
    const Matrix3d& C = hooke[t];
    const bool good = C.allFinite() && C.isApprox(C.transpose(), 1e-12) &&
                      C.llt().info() == Eigen::Success;
    if (!good)
      refuse("Hooke's tensor on triangle ", t, " is not symmetric and positive definite");
  }
}

Vector3d strain(const Mesh& mesh, const Ref<const VectorXd>& displacement, int triangle) {
  const Matrix<double, 2, 3> gradients = hat_gradients(mesh, triangle);
  Matrix2d grad = Matrix2d::Zero();  // du_i / dx_j
  for (int k = 0; k < 3; ++k)
    grad += displacement.segment<2>(2 * mesh.cells(k, triangle)) *
            gradients.col(k).transpose();
  return {grad(0, 0), grad(1, 1), grad(0, 1) + grad(1, 0)};
}

Matrix3Xd stresses(const Mesh& mesh, const Hooke& hooke,
                   const Ref<const VectorXd>& displacement) {
  Matrix3Xd result(3, mesh.cells.cols());
#pragma omp parallel for
  for (int t = 0; t < mesh.cell_count(); ++t)
    result.col(t) = hooke[t] * strain(mesh, displacement, t);
  return result;
}

}  // namespace ffcontact
