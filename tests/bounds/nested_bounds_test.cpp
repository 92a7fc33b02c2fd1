// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "ffcontact/bounds/quantity_bounds.hpp"
#include "support/bodies.hpp"
#include "support/bounded.hpp"
#include "support/nested_reference.hpp"
#include "support/quantities.hpp"
#include "support/springs.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The same problem with directions that turn along the line, at a rate [1/mm].
Problem turned(Problem problem, double rate) {
  ContactLine& line = problem.line;
  for (int i = 0; i < line.node_count(); ++i) {
    const double slope = rate * (problem.mesh.vertices(0, line.vertex[i]) - 3),
                 length = std::hypot(1, slope);
    line.normal.col(i) =
        (line.normal.col(i) + slope * line.tangent(i)) / length;
    problem.law.gap[i] /= length;
    problem.law.previous[i] /= length;
  }
  return problem;
}

/// On straight lines and on curves, with and without springs.
RC_GTEST_PROP(NestedBounds, narrow_and_hold_references, (Random random)) {
  const RandomBlock block = random_block(random);
  const double slip_bound = *rc::gen::inRange(0, 3) * *real(0, 2),
               rate = *rc::gen::inRange(0, 2) * *real(-0.1, 0.1);
  const Vector2d gap(*real(0, 1e-2), *real(0, 1e-3)),
      previous(*real(-1e-3, 1e-3), *real(-1e-3, 1e-3));
  const MatrixXd root = 20 * random_matrix(2, *rc::gen::inRange(0, 3), random);
  const Spring spring{root * root.transpose(), 1e-2 * random_vector(2, random)};
  const RandomQuantity quantity(block.mesh, random);
  const auto solved_on = [&](int times) {
    Problem problem = turned(with_law(block.on(subdivided(block.mesh, times)),
                                      slip_bound, gap, previous),
                             rate);
    BoundarySprings<2> springs;
    if (root.cols() > 0) {
      put_springs(
          problem.mesh, right,
          [&](const Vector2d&, const Vector2d&) { return spring; }, springs);
      assemble(springs, problem);
    }
    return Solved(problem, springs);
  };
  const auto bounds_on = [&](int times) {
    const Solved solved = solved_on(times);
    return solved.bounds(quantity.on(solved.problem));
  };
  const QuantityBounds wide = bounds_on(0), narrow = bounds_on(2);
  RC_PRE(moves(wide));
  require_that_they_narrow(wide, narrow);
  const Solved finest = solved_on(3);
  require_that_they_hold(wide, narrow.value,
                         finest.value(quantity.on(finest.problem)));
}

/// Two blocks whose meshes do not match, and a quantity of one of them.
class RandomBlocks {
 public:
  explicit RandomBlocks(Random& random)
      : meshes_{shifted(random_rows(random), {0, 1}), random_rows(random)},
        slip_bound_(*rc::gen::inRange(0, 3) * *real(0, 2)),
        shift_(1e-3 * random_vector(2, random) - Vector2d(0, 3e-3)),
        on_side_(3 * random_vector(2, random)),
        kind_(random() % 4),
        w_(random_vector(2, random)) {}

  QuantityBounds bounds(int times) const {
    const Bodies two = on(times);
    const Solved solved(two.problem);
    EXPECT_TRUE(solved.estimate().refinement);
    return solved.bounds(quantity(two));
  }
  /// l(u_h)
  double value(int times) const {
    const Bodies two = on(times);
    return Solved(two.problem).value(quantity(two));
  }

 private:
  Bodies on(int times) const {
    Bodies two =
        bodies({subdivided(meshes_[0], times), subdivided(meshes_[1], times)},
               {material(1e3, 0.3), material(2e3, 0.2)}, {{0, bottom, 1, top}});
    Problem& problem = two.problem;
    if (slip_bound_ > 0)
      problem.law.slip_bound = everywhere(problem.line, slip_bound_);
    clamp(problem, two.label(0, top), [&](const Vector2d&) { return shift_; });
    clamp(problem, two.label(1, bottom));
    add_traction(problem, two.label(1, left), on_side_);
    return two;
  }

  static Mesh random_rows(Random& random) {
    return with_random_rows(*rc::gen::inRange(2, 6), 2, 3, 1, random);
  }

  Quantity<2> quantity(const Bodies& two) const {
    const Problem& problem = two.problem;
    if (kind_ == 0) return on_label<2>(problem.mesh, two.label(0, left), w_);
    if (kind_ == 1) return on_label<2>(problem.mesh, two.label(0, bottom), w_);
    if (kind_ == 2) return on_label<2>(problem.mesh, two.label(1, top), w_);
    return stress_of(problem, {w_[0], w_[1], 0.5},
                     [&](int t) { return t >= two.joined.first_cell[1]; });
  }

  Mesh meshes_[2];
  double slip_bound_;
  Vector2d shift_, on_side_;
  unsigned kind_;
  Vector2d w_;
};

RC_GTEST_PROP(NestedBounds, of_two_bodies_narrow_and_hold_references,
              (Random random)) {
  require_nested_bounds(RandomBlocks(random), 0, 2, 3);
}

}  // namespace
}  // namespace ffcontact
