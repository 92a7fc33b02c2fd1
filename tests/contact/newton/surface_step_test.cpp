// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/newton/surface_step.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "ffcontact/contact/law/cones_of_law.hpp"
#include "support/any_step.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// P and v where the bounds of all nodes grow by s bound_change.
RC_GTEST_PROP(SurfaceStep, line_is_the_step_at_other_bounds, (Random random)) {
  AnyStep any(random_block(*real(0, 2), random), random);
  const auto nodes = static_cast<Index>(any.states.size());
  const VectorXd bound_change = random_vector(nodes, random);
  const auto line =
      surface_step_line(any.contact, any.equations(), any.rows, bound_change);
  RC_ASSERT(line.has_value());
  const auto agree = [&](double s) {
    const ContactRows step = any.exact();
    const double v_size = any.size_of(step) + line->along.v.norm(),
                 P_size = v_size * any.contact.S.diagonal().maxCoeff();
    return (line->at.v + s * line->along.v - step.v).norm() < 1e-9 * v_size &&
           (line->at.P + s * line->along.P - step.P).norm() < 1e-9 * P_size;
  };
  RC_ASSERT(agree(0));
  const double s = *real(-1, 1);
  for (Index i = 0; i < nodes; ++i) any.states[i].given += s * bound_change[i];
  RC_ASSERT(agree(s));
}

/// P - Pi(P - c v) of rows that none holds, with P = S v - g.
VectorXd natural_residual(const AnyStep& any, const NodalLaw& law,
                          const VectorXd& v) {
  const ContactRows rows = rows_of(any.contact, v, VectorXd());
  VectorXd missed = rows.P;
  for (int i = 0; i < law.node_count(); ++i) {
    const Vector3d tau = any.map.tau(rows, i);
    const double rho = law.cone[i].bound(tau[0]), size = tau.tail<2>().norm();
    missed[3 * i] -= std::min(tau[0], 0.0);
    missed.segment<2>(3 * i + 1) -=
        (size > rho ? rho / size : 1.0) * tau.tail<2>();
  }
  return missed;
}

/// By differences; friction from 3 on makes either sign.
RC_GTEST_PROP(SurfaceStep, orientation_is_the_sign_of_a_determinant,
              (Random random)) {
  const SolidProblem problem = block_problem(
      moved(brick({4, 2, 2}, {80, 40, 40}), 20, 0.15, random),
      *rc::gen::element(BlockCase::shear, BlockCase::lift), *real(3, 30));
  AnyStep any(problem, random);
  const NodalLaw law = nodal_law(problem.law, problem.surface);
  const Index n = any.contact.S.rows();
  RC_ASSERT(n == any.rows.v.size());
  const VectorXd v = 1e-3 * random_vector(n, random);
  any.rows = rows_of(any.contact, v, VectorXd());
  for (int i = 0; i < law.node_count(); ++i)
    any.states[i] = node_state(law.cone[i], any.map.tau(any.rows, i));
  MatrixXd derivative(n, n);
  for (Index k = 0; k < n; ++k) {
    const VectorXd step = 1e-9 * VectorXd::Unit(n, k);
    derivative.col(k) = (natural_residual(any, law, v + step) -
                         natural_residual(any, law, v - step)) /
                        any.contact.S.diagonal().maxCoeff() / 2e-9;
  }
  const auto line = surface_step_line(any.contact, any.equations(), any.rows,
                                      VectorXd::Zero(law.node_count()));
  RC_ASSERT(line.has_value());
  const bool positive = derivative.determinant() > 0;
  RC_CLASSIFY(positive);
  RC_ASSERT((line->orientation > 0) == positive);
}

/// Two nodes of a free body that nothing pushes.
TEST(SurfaceStep, line_is_nothing_where_a_body_is_free) {
  Random random(1);
  SolidProblem problem(brick({1, 1, 1}, {1, 1, 1}), 0.5);
  AnyStep any(problem, random);
  for (NodeState& state : any.states) state = node_state({}, Vector3d(1, 0, 0));
  EXPECT_FALSE(surface_step_line(any.contact, any.equations(), any.rows,
                                 VectorXd::Zero(problem.surface.node_count())));
}

}  // namespace
}  // namespace ffcontact
