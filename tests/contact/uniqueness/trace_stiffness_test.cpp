// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/uniqueness/trace_stiffness.hpp"

#include <gtest/gtest.h>

#include "support/bodies.hpp"
#include "support/condensed.hpp"
#include "support/random.hpp"

namespace ffcontact::test {
namespace {

/// A block on a longer one, its right side on a symmetry axis: there the vertices below
/// alone move the last node along t.
TEST(trace_stiffness, holds_the_relation_of_rows_that_opposite_vertices_move) {
  Bodies two =
      bodies({shifted(rectangle(4, 3, 4, 3), {1, 4}), rectangle(8, 4, 8, 4)},
             {material(1e3, 0.3), material(2e3, 0.2)}, {{0, bottom, 1, top}});
  clamp(two.problem, two.label(1, bottom));
  prescribe(two.problem, two.label(0, right), 0);
  const Condensed condensed(two.problem);
  const CondensedContact& contact = condensed.contact;
  const TraceStiffness traces = trace_stiffness(contact);
  const Index f = contact.S.rows();
  ASSERT_EQ(contact.dependent.size(), 1u);
  ASSERT_EQ(traces.S.rows(), f + 1);
  EXPECT_EQ(traces.row.back(), contact.dependent[0]);
  EXPECT_EQ(traces.place[contact.dependent[0]], f);

  std::mt19937 random(1);
  const VectorXd v = random_vector(f, random);
  const VectorXd q = VectorXd::Constant(1, 300);
  VectorXd all(f + 1), forces(f + 1);
  all << v, contact.E.transpose() * v + contact.F * q;
  forces << contact.S * v - contact.E * q, q;
  EXPECT_LT(relative_difference(traces.S * all, forces), 1e-12);
}

TEST(trace_stiffness, is_s_on_a_rigid_foundation) {
  const Condensed condensed(example_1(Multiplier::force, 4));
  const TraceStiffness traces = trace_stiffness(condensed.contact);
  EXPECT_EQ(traces.S, condensed.contact.S);
  EXPECT_EQ(traces.row, condensed.contact.primary);
  for (char followed : traces.is_followed) EXPECT_FALSE(followed);
}

}  // namespace
}  // namespace ffcontact::test
