// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/initial_stress.hpp"
#include "freefem/solid_point.hpp"

namespace ffcontact::plugin {

namespace {

const auto& points() { return Fem2D::QuadratureFormular_Tet_5; }

R3 place_of(int q) { return {points()[q].x, points()[q].y, points()[q].z}; }

CellQuadrature<3> quadrature_of_tetrahedra() {
  CellQuadrature<3> quadrature{Matrix4Xd(4, points().n), VectorXd(points().n)};
  for (int q = 0; q < points().n; ++q) {
    const R3 x = place_of(q);
    quadrature.hats.col(q) << 1 - x.x - x.y - x.z, x.x, x.y, x.z;
    quadrature.weights[q] = points()[q].a;
  }
  return quadrature;
}

SampledVoigt<3> sampled(Stack stack, const VoigtExpression<3>& expression,
                        const SolidPart& solid) {
  SampledVoigt<3> values;
  values.fill(MatrixXd::Zero(points().n, solid.fem_mesh->nt));
  if (!expression[0]) return values;
  SolidPoint point(stack, solid);
  for (int t = 0; t < solid.fem_mesh->nt; ++t)
    for (int q = 0; q < points().n; ++q) {
      point.go_to_tetrahedron(t, place_of(q));
      for (int c = 0; c < voigt_size<3>; ++c)
        values[c](q, t) = point.value(expression[c]);
    }
  return values;
}

}  // namespace

InitialStress<3> initial_stress_of(Stack stack,
                                   const VoigtExpression<3>& strain,
                                   const VoigtExpression<3>& stress,
                                   const HookeTensors<3>& hooke,
                                   const SolidPart& solid) {
  VectorXd volume(solid.fem_mesh->nt);
  for (Index t = 0; t < volume.size(); ++t)
    volume[t] =
        signed_volume(solid.mesh, solid.first_cell + static_cast<int>(t));
  return nearest_linear_stress<3>(quadrature_of_tetrahedra(),
                                  sampled(stack, strain, solid),
                                  sampled(stack, stress, solid), hooke, volume);
}

}  // namespace ffcontact::plugin
