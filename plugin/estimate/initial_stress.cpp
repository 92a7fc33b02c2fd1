// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/initial_stress.hpp"

#include "freefem/plane_values.hpp"

namespace ffcontact::plugin {

namespace {

CellQuadrature<2> quadrature_of_triangles() {
  const auto& points = Fem2D::QuadratureFormular_T_5;
  CellQuadrature<2> quadrature{Matrix3Xd(3, points.n), VectorXd(points.n)};
  for (int q = 0; q < points.n; ++q) {
    const double x = points[q].x, y = points[q].y;
    quadrature.hats.col(q) << 1 - x - y, x, y;
    quadrature.weights[q] = points[q].a;
  }
  return quadrature;
}

SampledVoigt<2> sampled(Stack stack, const VoigtExpression<2>& expression,
                        const Fem2D::Mesh& fem_mesh) {
  SampledVoigt<2> values;
  for (int c = 0; c < 3; ++c)
    values[c] = at_quadrature_points(stack, expression[c], fem_mesh);
  return values;
}

}  // namespace

InitialStress<2> initial_stress_of(Stack stack,
                                   const VoigtExpression<2>& strain,
                                   const VoigtExpression<2>& stress,
                                   const Hooke& hooke,
                                   const Fem2D::Mesh& fem_mesh) {
  VectorXd area(fem_mesh.nt);
  for (int t = 0; t < fem_mesh.nt; ++t) area[t] = fem_mesh[t].area;
  return nearest_linear_stress<2>(
      quadrature_of_triangles(), sampled(stack, strain, fem_mesh),
      sampled(stack, stress, fem_mesh), hooke, area);
}

}  // namespace ffcontact::plugin
