// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Components of a symmetric tensor in Voigt's order: xx, yy, xy in the plane, xx, yy,
/// zz, yz, xz, xy in space.
template <int dim>
constexpr int voigt_size = dim*(dim + 1) / 2;

/// Place of component ij in Voigt's order.
template <int dim>
constexpr std::array<std::array<int, dim>, dim> voigt_place{};
template <>
inline constexpr std::array<std::array<int, 2>, 2> voigt_place<2>{
    {{0, 2}, {2, 1}}};
template <>
inline constexpr std::array<std::array<int, 3>, 3> voigt_place<3>{
    {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}}};

template <int dim>
using VoigtVector = Matrix<double, voigt_size<dim>, 1>;
template <int dim>
using VoigtMatrix = Matrix<double, voigt_size<dim>, voigt_size<dim>>;

/// Hooke's tensor on each cell [MPa], in Voigt's order with engineering shear: in the
/// plane
///     (sigma_xx, sigma_yy, sigma_xy) = C (eps_xx, eps_yy, 2 eps_xy).
template <int dim>
using HookeTensors = std::vector<VoigtMatrix<dim>>;
using Hooke = HookeTensors<2>;

/// Voigt stresses, constant on each cell [MPa].
template <int dim>
using CellStresses = Matrix<double, voigt_size<dim>, Dynamic>;

/// sigma = lambda tr(eps) I + 2 G eps with Lame's constants [MPa]; plane strain in the
/// plane.
template <int dim = 2>
VoigtMatrix<dim> isotropic(double lambda, double G);

/// @throws std::invalid_argument  naming the first cell whose tensor is not finite,
///                                symmetric and positive definite
void require_elliptic(const HookeTensors<2>& hooke, int cell_count);
void require_elliptic(const HookeTensors<3>& hooke, int cell_count);

/// Strain of the linear displacement on one cell, Voigt with engineering shear [-].
template <int dim>
VoigtVector<dim> strain(const SimplexMesh<dim>& mesh,
                        const Ref<const VectorXd>& displacement, int cell);

/// sigma_h = C eps(u_h), one column per cell [MPa].
template <int dim>
CellStresses<dim> stresses(const SimplexMesh<dim>& mesh,
                           const HookeTensors<dim>& hooke,
                           const Ref<const VectorXd>& displacement);

/// Traction sigma n of a Voigt stress on a normal [MPa].
template <class Stress, class Normal>
auto traction(const Eigen::MatrixBase<Stress>& stress,
              const Eigen::MatrixBase<Normal>& normal) {
  constexpr int dim = Normal::SizeAtCompileTime;
  const VoigtVector<dim> s = stress;
  const VectorOf<dim> n = normal;
  VectorOf<dim> result;
  for (int i = 0; i < dim; ++i) {
    result[i] = s[voigt_place<dim>[i][0]] * n[0];
    for (int j = 1; j < dim; ++j) result[i] += s[voigt_place<dim>[i][j]] * n[j];
  }
  return result;
}

}  // namespace ffcontact
