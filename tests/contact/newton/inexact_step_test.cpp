// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/newton/inexact_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "ffcontact/contact/condensed_answer.hpp"
#include "support/any_step.hpp"
#include "support/threads.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Whatever the states: four digits a step, with residuals of double precision.
RC_GTEST_PROP(InexactStep, gains_four_digits_a_step, (Random random)) {
  const AnyStep any(random_block(*real(0, 2), random), random);
  const ContactRows exact = any.exact();
  InexactStep step(any.contact);
  ContactRows rows = any.rows;
  double missed = (rows.v - exact.v).norm();
  const double size = any.size_of(exact) + missed;
  for (int k = 0; k < 3; ++k) {
    RC_ASSERT(step.solve(any.contact, any.equations(), rows));
    const double left = (rows.v - exact.v).norm();
    RC_ASSERT(left <= 0.05 * missed + 1e-12 * size);
    missed = left;
  }
  RC_ASSERT(missed <= 1e-9 * size);
  RC_ASSERT((rows.P - exact.P).norm() <=
            1e-9 * size * any.contact.S.diagonal().maxCoeff());
}

/// A factor of other states serves too.
RC_GTEST_PROP(InexactStep, solves_what_comes_after, (Random random)) {
  AnyStep any(random_block(*real(0, 2), random), random);
  InexactStep step(any.contact);
  ContactRows rows = any.rows;
  RC_ASSERT(step.solve(any.contact, any.equations(), rows));
  const std::size_t node = random() % any.states.size();
  any.states[node].open = any.states[node].slips = !any.states[node].open;
  any.states[node].share = any.states[node].ratio = 0;
  const ContactRows exact = any.exact();
  for (int k = 0; k < 4; ++k)
    RC_ASSERT(step.solve(any.contact, any.equations(), rows));
  RC_ASSERT((rows.v - exact.v).norm() <= 1e-9 * any.size_of(exact));
}

TEST(SingleStiffness, products_do_not_depend_on_threads) {
  Random random(1);
  const SolidProblem problem =
      block_problem(brick({24, 12, 1}, {80, 40, 40}), BlockCase::press, 0.5);
  const AnyStep any(problem, random);
  const SingleStiffness S(any.contact);
  std::vector<int> places;
  for (int p = 0; p < S.size(); ++p)
    if (random() % 3 > 0) places.push_back(p);
  const auto n = static_cast<Index>(places.size());
  const VectorXf x = random_vector(n, random).cast<float>();
  const auto product = [&] { return S.product(places, x); };
  const VectorXf one = on_threads(1, product);
  EXPECT_EQ(on_threads(2, product), one);
  VectorXd v = VectorXd::Zero(S.size());
  for (Index k = 0; k < n; ++k)
    v[any.contact.position[S.row(places[k])]] =
        S.scale(places[k]) * static_cast<double>(x[k]);
  const VectorXd P = any.contact.S * v;
  for (int p = 0; p < S.size(); ++p)
    EXPECT_NEAR(one[p], S.scale(p) * P[any.contact.position[S.row(p)]], 1e-4);
}

}  // namespace
}  // namespace ffcontact
