// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ffcontact/bounds/bounds_by_turns.hpp"
#include "support/bounded.hpp"
#include "support/bounded_solids.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The least that comes of changes of each of some numbers, one at a time.
template <class Numbers, class Outcome>
double least_of_changes(Numbers& numbers, double change,
                        const Outcome& outcome) {
  double least = infinity;
  for (double& number : numbers.reshaped()) {
    const double kept = number;
    number += change;
    least = std::min(least, outcome());
    number = kept;
  }
  return least;
}

template <class Outcome>
double least_of_changes(ContactDensities& rho, double change,
                        const Outcome& outcome) {
  return std::min(least_of_changes(rho.normal, change, outcome),
                  least_of_changes(rho.tangential, change, outcome));
}
template <class Outcome>
double least_of_changes(SurfaceDensities& rho, double change,
                        const Outcome& outcome) {
  return least_of_changes(rho.on_faces, change, outcome);
}

/// Bounds of a quantity by pairs for t = s and t = -s whose numbers are changed.
template <int d>
class TwoBounds {
 public:
  BoundPair<d> plus, minus;

  /// @param solved, first  stay where they are
  TwoBounds(const SolvedProblem<d>& solved, const Estimate<d>& first,
            const Quantity<d>& quantity)
      : bounded_(bounded_quantity(solved, first, quantity)),
        s_(0.1 * bounded_.stress / bounded_.load.norm()) {
    BoundsByTurns<d> turns(bounded_, {});
    plus = turns.bound(s_, 2, RelaxationSettings{2}).pair;
    minus = turns.bound(-s_, 2, RelaxationSettings{2}).pair;
  }

  double width() const {
    return bounded_.of(plus.v) - bounded_.of(minus.v) +
           excess(bounded_.bodies, plus, s_) +
           excess(bounded_.bodies, minus, s_);
  }
  /// What contributions miss of the width, relative to it.
  double defect() const {
    const double sum = width_of_cells(bounded_.bodies, plus, minus, s_).sum();
    return std::abs(sum / width() - 1);
  }
  /// How far v does not keep clear.
  double depth() const {
    return std::max(depth_of<d>(bounded_.bodies, bounded_.clear, plus.v),
                    depth_of<d>(bounded_.bodies, bounded_.clear, minus.v));
  }

  /// Away from the gap, where rho does not count, and strained in all cells.
  void move_at_random() {
    Random random(1);
    const double size = 0.1 * max_norm(plus.v);
    for (BoundPair<d>* pair : {&plus, &minus})
      pair->v +=
          on_free_dofs(bounded_.solved.system,
                       VectorXd(size * random_vector(pair->v.size(), random)));
  }
  bool is_prescribed(int dof) const {
    return bounded_.solved.system.prescribed[dof];
  }

 private:
  BoundedQuantity<d> bounded_;
  double s_;
};

/// A change of one number in 1000 is to make no less [1].
constexpr double noticed = 1e-8;

template <int d>
void expect_that_each_number_of_stress_and_traction_counts(TwoBounds<d> two) {
  two.move_at_random();
  EXPECT_LT(two.defect(), 1e-11);
  constexpr double change = 5e-3;  // of 5 MPa
  const auto defect = [&] { return two.defect(); };
  for (BoundPair<d>* pair : {&two.plus, &two.minus}) {
    for (SubcellStress<d>& tau : pair->tau)
      EXPECT_GT(least_of_changes(tau, change, defect), noticed);
    EXPECT_GT(least_of_changes(pair->rho, change, defect), noticed);
  }
}

/// Where v is prescribed contributions miss the width; elsewhere v does not keep clear, or
/// the bound is worse: there v minimises it.
template <int d>
void expect_that_each_number_of_displacement_counts(TwoBounds<d> two) {
  const double change = 1e-3 * max_norm(two.plus.v), width = two.width();
  EXPECT_LT(two.defect(), 1e-11);
  EXPECT_EQ(two.depth(), 0);
  for (BoundPair<d>* pair : {&two.plus, &two.minus})
    for (int dof = 0; dof < pair->v.size(); ++dof)
      for (const double by : {change, -change}) {
        const double kept = pair->v[dof];
        pair->v[dof] += by;
        if (two.is_prescribed(dof)) {
          EXPECT_GT(two.defect(), noticed);
        } else if (two.depth() == 0) {
          EXPECT_GT(two.width(), (1 + noticed) * width);
        }
        pair->v[dof] = kept;
      }
}

template <int d>
void expect_that_each_number_counts(const SolvedProblem<d>& solved,
                                    const Quantity<d>& quantity) {
  const Estimate<d> first = estimate_error<d>(solved.topology, solved.contact,
                                              solved.system, solved.body);
  const TwoBounds<d> two(solved, first, quantity);
  expect_that_each_number_of_stress_and_traction_counts(two);
  expect_that_each_number_of_displacement_counts(two);
}

/// Contact is closed and open, sticks and slips; no strain of a cell is prescribed.
TEST(SpoiledBounds, of_plane_bodies_tell) {
  Problem problem = example_2(Multiplier::force, 0, 3);
  problem.law.slip_bound = everywhere(problem.line, 0.2);
  problem.law.gap = linear_along(problem, {0, 2.5e-5});
  add_traction(problem, left, {0, 1});
  const Solved solved(problem);
  expect_that_each_number_counts(
      solved.as_problem(),
      on_label<2>(problem.mesh, left, {1.0 / 40, 0.5 / 40}));
}

TEST(SpoiledBounds, of_solids_tell) {
  SolidProblem problem(brick({2, 1, 1}, {2, 1, 1}));
  problem.guide(low_x, 0);
  problem.load(high_z, {0, 0, -5});
  problem.law.slip_bound = on_all_nodes(problem, 2);
  const SolidWithAnswer solved(problem);
  expect_that_each_number_counts(
      solved.as_problem(), on_label<3>(problem.mesh, high_x, {1, 0.5, 0.2}));
}

}  // namespace
}  // namespace ffcontact
