// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/stress/linear_stress.hpp"
//
#include "freefem/arguments.hpp"

namespace ffcontact::plugin {

/// Components xx, yy, xy of an expression, null where it is not given.
using VoigtExpression = std::array<Expression, 3>;

/// tau0 = sigma0 - C eps0 on the triangles of one body.
struct InitialStress {
  /// the linear function on each triangle that is nearest to tau0, by the quadrature that
  /// FreeFEM's int2d uses by default, so that its means are those of the script's loads
  /// [9 x triangles]
  Matrix<double, 9, Dynamic> at_vertices;
  /// |tau0 less its linear part|, |tau|^2 = int C^-1 tau : tau
  double oscillation;
};

/// @param strain  eps0 with engineering shear
/// @param stress  sigma0 [MPa]
InitialStress initial_stress_of(Stack stack, const VoigtExpression& strain,
                                const VoigtExpression& stress,
                                const Hooke& hooke,
                                const Fem2D::Mesh& fem_mesh);

}  // namespace ffcontact::plugin
