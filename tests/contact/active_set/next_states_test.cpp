// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/active_set/next_states.hpp"

#include <gtest/gtest.h>

namespace ffcontact {
namespace {

using State = ContactState;

/// One node on a condensed relation that only says what displacements and loads are
/// large.
State next(const FrictionCone& cone, State now, const Vector2d& P,
           const Vector2d& v, double previous = 0) {
  CondensedContact contact;
  contact.primary = {0, 1};
  contact.position = (VectorXi(2) << 0, 1).finished();
  contact.S = Matrix2d::Identity();
  contact.g = Vector2d::Constant(1e-3);
  contact.E = contact.F = MatrixXd(2, 0);
  contact.v_prescribed = Vector2d(0, previous);
  return next_states(contact, {{cone}}, {now}, {P, v}).front();
}

FrictionCone coulomb(double mu) {
  FrictionCone cone;
  cone.friction = mu;
  return cone;
}
FrictionCone tresca(double bound) {
  FrictionCone cone;
  cone.cohesion = bound;
  return cone;
}

TEST(NextStates, of_coulombs_law) {
  const FrictionCone cone = coulomb(0.5);
  EXPECT_EQ(next(cone, State::stick, {-2, 0.9}, {0, 0}), State::stick);
  EXPECT_EQ(next(cone, State::stick, {-2, -1.1}, {0, 0}), State::slip_forward);
  EXPECT_EQ(next(cone, State::stick, {-2, 1.1}, {0, 0}), State::slip_backward);
  EXPECT_EQ(next(cone, State::stick, {1, 0}, {0, 0}), State::open);
  EXPECT_EQ(next(cone, State::slip_forward, {-2, -1}, {0, 1}),
            State::slip_forward);
  EXPECT_EQ(next(cone, State::slip_forward, {-2, -1}, {0, -1}), State::stick);
  EXPECT_EQ(next(cone, State::slip_backward, {-2, 1}, {0, 1}), State::stick);
  EXPECT_EQ(next(cone, State::open, {0, 0}, {-1, 0}), State::open);
  EXPECT_EQ(next(cone, State::open, {0, 0}, {1, 0}), State::stick);
  EXPECT_EQ(next(cone, State::open, {0, 0}, {1, -1}), State::slip_backward);
}

TEST(NextStates, without_friction_slip_in_contact) {
  EXPECT_EQ(next({}, State::slip_forward, {-1, 0}, {0, 1}),
            State::slip_forward);
  EXPECT_EQ(next({}, State::slip_forward, {1, 0}, {0, 1}), State::open);
  EXPECT_EQ(next({}, State::open, {0, 0}, {1, -1}), State::slip_forward);
}

TEST(NextStates, of_trescas_law_hold_open_nodes) {
  const FrictionCone cone = tresca(1);
  EXPECT_EQ(next(cone, State::stick, {1, 0.5}, {0, 0}), State::open_stick);
  EXPECT_EQ(next(cone, State::open_stick, {0, 2}, {-1, 0}),
            State::open_slip_backward);
  EXPECT_EQ(next(cone, State::open_slip_forward, {0, -1}, {1, 1}),
            State::slip_forward);
}

TEST(NextStates, beyond_the_shear_limit_slip_under_it) {
  FrictionCone cone = coulomb(0.5);
  cone.limit = 0.8;
  EXPECT_EQ(next(cone, State::stick, {-2, 0.9}, {0, 0}),
            State::limited_backward);
  EXPECT_EQ(next(cone, State::stick, {-1, 0.7}, {0, 0}), State::slip_backward);
}

/// v_t has the rounding of `previous`, of which it is a difference.
TEST(NextStates, are_not_changed_by_the_rounding_of_an_earlier_slip) {
  const auto sliding = [](double vt, double previous) {
    return next(coulomb(0.5), State::slip_forward, {-2, -1}, {0, vt}, previous);
  };
  EXPECT_EQ(sliding(-5e-15, 1e-2), State::slip_forward);
  EXPECT_EQ(sliding(-5e-15, 0), State::stick);
  EXPECT_EQ(sliding(-1e-13, 1e-2), State::stick);
}

TEST(NextStates, begin_with_the_nearest_that_a_node_may_have) {
  EXPECT_EQ(start_state({}, State::stick), State::slip_forward);
  EXPECT_EQ(start_state({}, State::open_stick), State::open);
  EXPECT_EQ(start_state(coulomb(1), State::stick), State::stick);
  EXPECT_EQ(start_state(coulomb(1), State::open_slip_forward), State::open);
  EXPECT_EQ(start_state(tresca(1), State::open), State::open_stick);
  EXPECT_EQ(start_state(tresca(1), State::open_slip_backward),
            State::open_slip_backward);
}

}  // namespace
}  // namespace ffcontact
