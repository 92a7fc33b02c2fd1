// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/bound_pair.hpp"

#include <gtest/gtest.h>

#include "ffcontact/bounds/coulomb_on_line.hpp"
#include "ffcontact/bounds/quantity.hpp"
#include "ffcontact/contact/solve_contact.hpp"
#include "support/estimates.hpp"
#include "support/random.hpp"
#include "support/springs.hpp"

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
  BoundarySprings<2> springs;
  SolvedBody<2> body;
  BoundPair<2> plus, minus;

  /// @param k  of springs on the right [MPa/mm]
  explicit TwoPairs(double k = 0) {
    problem.law.slip_bound = everywhere(problem.line, 0.2);
    if (k > 0) {
      const Spring spring{k * Matrix2d::Identity(), {1e-4, 0}};
      put_springs(
          problem.mesh, right,
          [&](const Vector2d&, const Vector2d&) { return spring; }, springs);
      assemble(springs, problem);
    }
    VectorXd load = VectorXd::Zero(problem.b.size());
    add_traction(problem.mesh, left, {1, 0.5}, load, quantity.tractions);
    body = with_springs(solution(0));
    plus = pair(s);
    minus = pair(-s);
  }

  ContactSolution<2> solution(double t) {
    system = problem.system();
    system.load += t * on_free_dofs(system, load_of(problem.mesh, quantity));
    return solve_contact(problem.mesh, problem.line, problem.law, system);
  }

  SolvedBody<2> with_springs(const ContactSolution<2>& solution) const {
    SolvedBody<2> solved = solved_body(problem, solution);
    solved.springs = springs;
    return solved;
  }

  BoundPair<2> pair(double t) {
    SolvedBody<2> other = with_springs(solution(t));
    other.neumann += t * quantity.tractions;
    const Estimate<2> estimate =
        estimate_error<2>(topology, problem.line, system, other);
    return {solution(-t).displacement, estimate.stress, estimate.tractions, 0,
            estimate.spring_tractions};
  }

  MatchedBodies<2> bodies() const {
    return MatchedBodies<2>({topology, problem.line, system, body});
  }
  double defect(const CoulombTerms<2>* coulomb = nullptr) const {
    const double width = load_of(problem.mesh, quantity).dot(plus.v - minus.v) +
                         excess(bodies(), plus, s, coulomb) +
                         excess(bodies(), minus, s, coulomb),
                 of_cells =
                     width_of_cells(bodies(), plus, minus, s, coulomb).sum();
    return std::abs(width / of_cells - 1);
  }
  CoulombTerms<2> coulomb(double share) const {
    return coulomb_terms(
        bodies(), estimate_error<2>(topology, problem.line, system, body),
        share);
  }
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

TEST(BoundPair, contributions_add_up_with_coulombs_law) {
  for (const double k : {0, 100}) {
    const TwoPairs pairs(k);
    const CoulombTerms<2> coulomb = pairs.coulomb(0.4);
    EXPECT_LT(pairs.defect(&coulomb), 1e-10);
  }
}

/// Of the known pair the excess is that of e; what v is away from u_hat costs its energy.
TEST(BoundPair, coulombs_law_adds_what_is_away_from_the_known_pair) {
  const TwoPairs pairs(100);
  const double m = 0.4, s = pairs.s;
  const CoulombTerms<2> none = pairs.coulomb(0), coulomb = pairs.coulomb(m);
  BoundPair<2> pair = coulomb.known;
  const auto added = [&] {
    return excess(pairs.bodies(), pair, s, &coulomb) -
           excess(pairs.bodies(), pair, s, &none);
  };
  const Estimate<2> estimate = estimate_error<2>(
      pairs.topology, pairs.problem.line, pairs.system, pairs.body);
  const double square = estimate.e * estimate.e,
               of_pair = excess(pairs.bodies(), pair, s, &none),
               elastic = 2 * (square - 2 * s * of_pair);
  EXPECT_NEAR(of_pair, excess(pairs.bodies(), pair, s), 1e-12 * of_pair);
  EXPECT_NEAR(added(), m / (4 * s) * elastic, 1e-12 * of_pair);
  Random random(1);
  const VectorXd w =
      on_free_dofs(pairs.system, 1e-4 * random_vector(pair.v.size(), random));
  pair.v += w;
  const double energy = w.dot(pairs.problem.A * w);
  EXPECT_NEAR(added(), m / (4 * s) * (elastic + energy / (1 - m)),
              1e-12 * energy);
}

/// They rest on equilibrium with l.
TEST(BoundPair, contributions_do_not_add_up_to_that_of_another_quantity) {
  TwoPairs pairs;
  pairs.quantity.tractions *= 1.001;
  EXPECT_GT(pairs.defect(), 1e-8);
}

}  // namespace
}  // namespace ffcontact
