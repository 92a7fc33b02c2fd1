// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/bound_pair.hpp"

#include <gtest/gtest.h>

#include "ffcontact/bounds/quantity.hpp"
#include "support/estimates.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The pairs of u_h and its estimate under L - s l and L + s l, which are good for bounds.
struct TwoPairs {
  Problem problem = example_2(Multiplier::force, 0, 4);
  double s = 0.3;
  Quantity<2> quantity{BodyLoadsOfCells<2>::Zero(6, problem.mesh.cells.cols()),
                       {},
                       Matrix4Xd::Zero(4, problem.mesh.boundary.cols())};
  Topology<2> topology = topology_of(problem.mesh);
  ElasticSystem system = problem.system();
  SolvedBody<2> body;
  BoundPair<2> plus, minus;

  TwoPairs() {
    problem.law.slip_bound = everywhere(problem.line, 0.2);
    VectorXd load = VectorXd::Zero(problem.b.size());
    add_traction(problem.mesh, left, {1, 0.5}, load, quantity.tractions);
    body = solved_body(problem, solution(0));
    plus = pair(s);
    minus = pair(-s);
  }

  ContactSolution solution(double t) {
    system = problem.system();
    system.load += t * on_free_dofs(system, load_of(problem.mesh, quantity));
    return solve_contact(problem.mesh, problem.line, problem.law, system);
  }

  BoundPair<2> pair(double t) {
    SolvedBody<2> other = solved_body(problem, solution(t));
    other.neumann += t * quantity.tractions;
    const Estimate<2> estimate =
        estimate_error<2>(topology, problem.line, system, other);
    return {solution(-t).displacement, estimate.stress, estimate.tractions};
  }

  double width() const {
    const MatchedBodies<2> bodies({topology, problem.line, system, body});
    return load_of(problem.mesh, quantity).dot(plus.v - minus.v) +
           excess(bodies, plus, s) + excess(bodies, minus, s);
  }
  double of_cells() const {
    const MatchedBodies<2> bodies({topology, problem.line, system, body});
    return width_of_cells(bodies, plus, minus, s).sum();
  }
  double defect() const { return std::abs(width() / of_cells() - 1); }
};

TEST(BoundPair, contributions_add_up_whatever_v_is) {
  TwoPairs pairs;
  EXPECT_LT(pairs.defect(), 1e-10);
  Random random(1);
  const VectorXd more = on_free_dofs(
      pairs.system, 1e-4 * random_vector(pairs.plus.v.size(), random));
  pairs.plus.v += more;
  EXPECT_LT(pairs.defect(), 1e-10);
}

/// They rest on equilibrium with the loads, with l and with the tractions.
TEST(BoundPair, contributions_do_not_add_up_of_spoiled_fields) {
  TwoPairs pairs;
  pairs.plus.tau[5](0, 0) += 1e-3;
  EXPECT_GT(pairs.defect(), 1e-8);
  pairs = TwoPairs();
  pairs.minus.rho.tangential(0, 1) -= 1e-3;  // v_n is 0

  EXPECT_GT(pairs.defect(), 1e-8);
  pairs = TwoPairs();
  pairs.quantity.tractions *= 1.001;
  EXPECT_GT(pairs.defect(), 1e-8);
}

}  // namespace
}  // namespace ffcontact
