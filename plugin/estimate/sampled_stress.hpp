// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "ffcontact/equilibrium/stress/linear_stress.hpp"

namespace ffcontact::plugin {

/// tau0 = sigma0 - C eps0 on the cells of one body.
template <int d>
struct InitialStress {
  /// the linear function on each cell that is nearest to tau0, by the quadrature that
  /// FreeFEM's int2d or int3d uses by default, so that its means are those of the script's
  /// loads
  typename LinearStresses<d>::Values at_vertices;
  /// |tau0 less its linear part|, |tau|^2 = int C^-1 tau : tau
  double oscillation;
};

/// A quadrature on the cells of a mesh.
template <int d>
struct CellQuadrature {
  Matrix<double, d + 1, Dynamic> hats;  ///< hat functions at the points
  VectorXd weights;                     ///< in parts of the volume
};

/// Components at the points of all cells [points x cells] each.
template <int d>
using SampledVoigt = std::array<MatrixXd, voigt_size<d>>;

template <int d>
CellStresses<d> on_cell(const SampledVoigt<d>& values, int cell) {
  CellStresses<d> tau(voigt_size<d>, values[0].rows());
  for (int c = 0; c < voigt_size<d>; ++c)
    tau.row(c) = values[c].col(cell).transpose();
  return tau;
}

/// @param eps0    strains at the points
/// @param sigma0  stresses
/// @param volume  of each cell
template <int d>
InitialStress<d> nearest_linear_stress(const CellQuadrature<d>& quadrature,
                                       const SampledVoigt<d>& eps0,
                                       const SampledVoigt<d>& sigma0,
                                       const HookeTensors<d>& hooke,
                                       const VectorXd& volume) {
  const auto& [phi, weights] = quadrature;
  const MatrixXd weighted = weights.asDiagonal() * phi.transpose();
  const Matrix<double, d + 1, d + 1> mass = phi * weighted;
  const MatrixXd to_vertices = weighted * mass.inverse();
  InitialStress<d> result;
  result.at_vertices.resize(Eigen::NoChange, volume.size());
  double square = 0;
  for (int t = 0; t < volume.size(); ++t) {
    const CellStresses<d> tau =
        on_cell<d>(sigma0, t) - hooke[t] * on_cell<d>(eps0, t);
    const VertexStress<d> at_vertices = tau * to_vertices;
    result.at_vertices.col(t) = at_vertices.reshaped();
    const CellStresses<d> beyond = tau - at_vertices * phi,
                          strain = hooke[t].inverse() * beyond;
    square +=
        volume[t] * beyond.cwiseProduct(strain).colwise().sum().dot(weights);
  }
  result.oscillation = std::sqrt(square);
  return result;
}

}  // namespace ffcontact::plugin
