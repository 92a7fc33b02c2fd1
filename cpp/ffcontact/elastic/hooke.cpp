// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/hooke.hpp"

#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

namespace {

/// Does elimination meet none but positive pivots? That of a symmetric matrix of this size
/// takes the compiler less than Eigen's factorisations, and no memory.
template <class Tensor>
bool has_positive_pivots(Tensor C) {
  for (Index k = 0; k < C.rows(); ++k) {
    if (!(C(k, k) > 0)) return false;
    for (Index j = k + 1; j < C.cols(); ++j)
      for (Index i = j; i < C.rows(); ++i)
        C(i, j) -= C(i, k) * C(j, k) / C(k, k);
  }
  return true;
}

template <class Tensor>
bool is_elliptic(const Tensor& C) {
  return C.allFinite() && C.isApprox(C.transpose(), 1e-12) &&
         has_positive_pivots(C);
}

/// du_i / dx_j
template <int dim>
MatrixOf<dim> gradient(const SimplexMesh<dim>& mesh,
                       const Ref<const VectorXd>& displacement, int cell) {
  const auto hats = hat_gradients(mesh, cell);
  MatrixOf<dim> result = MatrixOf<dim>::Zero();
  for (int k = 0; k <= dim; ++k) {
    const auto u = vector_at<dim>(displacement, mesh.cells(k, cell));
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) result(i, j) += u[i] * hats(j, k);
  }
  return result;
}

}  // namespace

template <int dim>
VoigtMatrix<dim> isotropic(double lambda, double G) {
  VoigtMatrix<dim> C = VoigtMatrix<dim>::Zero();
  C.template topLeftCorner<dim, dim>().setConstant(lambda);
  C.diagonal().setConstant(G);
  C.diagonal().template head<dim>().setConstant(lambda + 2 * G);
  return C;
}

void require_elliptic(const HookeTensors<FFCONTACT_DIMENSION>& hooke,
                      int cell_count) {
  require_size("Hooke's tensor", static_cast<Index>(hooke.size()), cell_count);
  for (std::size_t t = 0; t < hooke.size(); ++t)
    if (!is_elliptic(hooke[t]))
      refuse("Hooke's tensor on ", MeshWords<FFCONTACT_DIMENSION>::cell, " ", t,
             " is not symmetric and positive definite");
}

template <int dim>
VoigtVector<dim> strain(const SimplexMesh<dim>& mesh,
                        const Ref<const VectorXd>& displacement, int cell) {
  const MatrixOf<dim> grad = gradient(mesh, displacement, cell);
  VoigtVector<dim> result;
  for (int i = 0; i < dim; ++i) {
    result[i] = grad(i, i);
    for (int j = i + 1; j < dim; ++j)
      result[voigt_place<dim>[i][j]] = grad(i, j) + grad(j, i);
  }
  return result;
}

template <int dim>
Matrix<double, voigt_size<dim>, Dynamic> stresses(
    const SimplexMesh<dim>& mesh, const HookeTensors<dim>& hooke,
    const Ref<const VectorXd>& displacement) {
  Matrix<double, voigt_size<dim>, Dynamic> result(voigt_size<dim>,
                                                  mesh.cells.cols());
#pragma omp parallel for
  for (int t = 0; t < mesh.cell_count(); ++t)
    result.col(t) = hooke[t] * strain(mesh, displacement, t);
  return result;
}

template VoigtMatrix<FFCONTACT_DIMENSION> isotropic<FFCONTACT_DIMENSION>(
    double, double);
template VoigtVector<FFCONTACT_DIMENSION> strain(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const Ref<const VectorXd>&, int);
template Matrix<double, voigt_size<FFCONTACT_DIMENSION>, Dynamic>
stresses<FFCONTACT_DIMENSION>(const SimplexMesh<FFCONTACT_DIMENSION>&,
                              const HookeTensors<FFCONTACT_DIMENSION>&,
                              const Ref<const VectorXd>&);

}  // namespace ffcontact
