// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "ffcontact/equilibrium/stress/linear_stress.hpp"
//
#include "freefem/body_values.hpp"

namespace ffcontact::plugin {

/// Components of an expression in Voigt's order, all of them null where it is not given.
template <int d>
using VoigtExpression = std::array<Expression, voigt_size<d>>;

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

/// @param strain  eps0 with engineering shear
/// @param stress  sigma0 [MPa]
template <int d>
InitialStress<d> initial_stress_of(Stack stack,
                                   const VoigtExpression<d>& strain,
                                   const VoigtExpression<d>& stress,
                                   const HookeTensors<d>& hooke,
                                   const BodyPart<d>& part) {
  const CellQuadrature<d> quadrature = cell_quadrature<d>();
  const auto& [phi, weights] = quadrature;
  const MatrixXd weighted = weights.asDiagonal() * phi.transpose();
  const Matrix<double, d + 1, d + 1> mass = phi * weighted;
  const MatrixXd to_vertices = weighted * mass.inverse();
  InitialStress<d> result;
  result.at_vertices.resize(Eigen::NoChange, part.cell_count());
  double square = 0;
  PointOf<d> point(stack, part);
  for (int t = 0; t < result.at_vertices.cols(); ++t) {
    const CellStresses<d> tau = in_cell<d>(point, t, stress, phi) -
                                hooke[t] * in_cell<d>(point, t, strain, phi);
    const VertexStress<d> at_vertices = tau * to_vertices;
    result.at_vertices.col(t) = at_vertices.reshaped();
    const CellStresses<d> beyond = tau - at_vertices * phi,
                          compliant = hooke[t].inverse() * beyond;
    square += signed_volume(part.mesh, part.first_cell + t) *
              beyond.cwiseProduct(compliant).colwise().sum().dot(weights);
  }
  result.oscillation = std::sqrt(square);
  return result;
}

/// Initial stresses of the bodies, joined; empty where none has any.
template <int d>
class InitialStresses {
 public:
  /// @param cells  of all bodies
  explicit InitialStresses(int cells) : cells_(cells) {}

  /// Those of one body, as for initial_stress_of. @return their oscillation
  double add(Stack stack, const VoigtExpression<d>& strain,
             const VoigtExpression<d>& stress, const HookeTensors<d>& hooke,
             const BodyPart<d>& part) {
    if (!strain[0] && !stress[0]) return 0;
    if (values_.cols() == 0)
      values_.setZero(LinearStresses<d>::Values::RowsAtCompileTime, cells_);
    const InitialStress<d> own =
        initial_stress_of<d>(stack, strain, stress, hooke, part);
    values_.middleCols(part.first_cell, own.at_vertices.cols()) =
        own.at_vertices;
    return own.oscillation;
  }

  LinearStresses<d> joined() const {
    return values_.cols() > 0 ? LinearStresses<d>::of_values(values_)
                              : LinearStresses<d>();
  }

 private:
  int cells_;
  typename LinearStresses<d>::Values values_;  ///< at the vertices of all cells
};

}  // namespace ffcontact::plugin
