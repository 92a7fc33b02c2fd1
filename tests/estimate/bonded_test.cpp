// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/bonded.hpp"

#include <gtest/gtest.h>

#include "ffcontact/estimate/bodies/matched_bodies.hpp"
#include "ffcontact/estimate/displacement/bonded_displacement.hpp"
#include "ffcontact/linear/sparse_lu.hpp"
#include "support/estimates.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

const Material stiff = material(70e3, 0.3), soft = material(3e3, 0.3);

/// Vertices that all but meet face each other otherwise (CommonRefinement).
bool is_exact(const Estimate<2>& estimate) {
  return !estimate.refinement || estimate.refinement->exact;
}

/// A linear displacement has no error, whatever the meshes between the bodies.
RC_GTEST_PROP(BondedEstimate, linear_displacements_have_no_error,
              (Random random)) {
  const Bodies two = random_patch(stiff, 2, random);
  const Estimate<2> estimate =
      estimated(two.problem, solved(two.problem), sweeps(0));
  RC_ASSERT(estimate.relative < (is_exact(estimate) ? 1e-8 : 1e-4));
  RC_ASSERT(estimate.contact == 0);
  RC_ASSERT(estimate.penetration == 0);
}

TEST(BondedEstimate, linear_displacements_have_no_error_to_rounding) {
  for (const double angle : {0.0, 0.4})
    for (const auto& [upper, lower] : {std::pair(7, 11), std::pair(11, 7)}) {
      Bodies two = bonded_blocks(upper, lower, stiff, stiff, angle);
      prescribe_around(two);
      const Estimate<2> estimate =
          estimated(two.problem, solved(two.problem), sweeps(0));
      EXPECT_TRUE(estimate.admissible) << estimate.reason;
      EXPECT_LT(estimate.relative, 1e-12);
    }
}

/// Work of the loads on a displacement of vertices.
double work_of_loads(const Problem& problem, const VectorXd& u) {
  const ElasticSystem system = problem.system();
  return without(system.prescribed, problem.b).dot(u);
}

/// The energy of the solution, on one fine mesh 6 x 9.
double energy_of_one_mesh() {
  Problem one = body(rectangle(72, 108, 6, 9), soft);
  for (int t = 0; t < one.mesh.cell_count(); ++t)
    if (centroid_of(one.mesh, t).y() > 5) one.hooke[t] = stiff.hooke();
  one.A = stiffness(one.mesh, one.hooke);
  add_traction(one, top, {3, 7});
  clamp(one, bottom);
  return work_of_loads(one, SparseLu(SparseMatrix(one.A)).solve(one.b));
}

Hooke refined_hooke(const Problem& problem, const Estimate<2>& estimate) {
  Hooke hooke;
  for (int t : estimate.refinement->parent) hooke.push_back(problem.hooke[t]);
  return hooke;
}

/// Twice the potential energy of a displacement of the refined bodies.
double twice_potential(const Problem& problem, const Estimate<2>& estimate,
                       const VectorXd& u) {
  const RowMatrix K =
      stiffness(estimate.refinement->mesh, refined_hooke(problem, estimate));
  return u.dot(K * u) - 2 * work_of_loads(problem, u.head(problem.b.size()));
}

/// e^2 is the sum of the squares of both errors, so that e is above that of u_hat, and not by
/// much.
TEST(BondedEstimate, bounds_the_error_of_two_materials_closely) {
  const double exact = energy_of_one_mesh();
  for (const Multiplier multiplier : both_multipliers) {
    Bodies two = bonded_blocks(5, 7, stiff, soft);
    pull(two);
    two.problem.law.multiplier = multiplier;
    const ContactSolution<2> solution = solved(two.problem);
    for (int count : {2, 6}) {
      const Estimate<2> estimate =
          estimated(two.problem, solution, sweeps(count));
      ASSERT_TRUE(estimate.admissible) << estimate.reason;
      EXPECT_EQ(estimate.contact, 0);
      EXPECT_LT(estimate.equilibrium.largest(), 1e-10);
      const double error = std::sqrt(
          twice_potential(two.problem, estimate, estimate.displacement) +
          exact);
      EXPECT_GT(estimate.e, error);
      EXPECT_LT(estimate.e, (count > 2 ? 1.1 : 1.15) * error);
    }
  }
}

/// Of all displacements without a jump that differ from it along the line u_hat has the least
/// potential energy.
TEST(BondedEstimate, u_hat_has_the_least_energy) {
  Bodies two = bonded_blocks(5, 7, stiff, soft);
  pull(two);
  const Estimate<2> estimate =
      estimated(two.problem, solved(two.problem), sweeps(0));
  const ContactLine& line = estimate.refinement->line;
  const VectorXd& u_hat = estimate.displacement;
  const double least = twice_potential(two.problem, estimate, u_hat);
  for (int i = 0; i < line.node_count(); ++i)
    for (const double step : {1e-4, -1e-4})
      for (int c = 0; c < 2; ++c) {
        VectorXd u = u_hat;
        u[2 * line.vertex[i] + c] += step;
        visit_opposite(line, i, [&](int v, double) { u[2 * v + c] += step; });
        EXPECT_EQ(contact_components(line, u).col(i), Vector2d(0, 0));
        EXPECT_GT(twice_potential(two.problem, estimate, u), least);
      }
}

TEST(BondedEstimate, of_a_rigid_foundation_is_0_on_it) {
  Problem problem = bonded_body(rectangle(8, 6, 4, 3), stiff, {bottom, left});
  add_traction(problem, top, {1, 5});
  const Estimate<2> estimate = estimated(problem, solved(problem));
  EXPECT_TRUE(estimate.admissible) << estimate.reason;
  EXPECT_EQ(estimate.contact, 0);
  EXPECT_LT(estimate.relative, 0.11);
  for (int v : problem.line.vertex)
    EXPECT_EQ(estimate.displacement.segment<2>(2 * v), Vector2d(0, 0));
  // r_hat of any sign, and one for each side of the corner
  EXPECT_GT(estimate.tractions.normal.maxCoeff(), 1);
  EXPECT_LT(estimate.tractions.normal.minCoeff(), -0.1);
}

/// The part of a ring between two radii over 2 radians, whose side `bottom` has the first one.
Mesh ring_part(int along, int across, double radius, double to) {
  Mesh mesh = rectangle(along, across, 2, std::abs(to - radius));
  const double side = to < radius ? -1 : 1;
  for (auto x : mesh.vertices.colwise()) {
    const double angle = -side * (x[0] - 1), r = radius + side * x[1];
    x << r * std::sin(angle), -r * std::cos(angle);
  }
  return mesh;
}

/// Tractions are linear on the edges of curves, so that nothing is beyond e.
TEST(BondedEstimate, falls_with_the_size_on_curves) {
  double last = 0;
  for (int n : {1, 2}) {
    Bodies two = bonded_bodies(
        {ring_part(11 * n, 3 * n, 10, 5), ring_part(7 * n, 3 * n, 10, 15)},
        {stiff, soft}, {{0, bottom, 1, bottom}});
    clamp(two.problem, two.label(1, top));
    add_traction(two.problem, two.label(0, top), {0, 7});
    const Estimate<2> estimate =
        estimated(two.problem, solved(two.problem), sweeps(4));
    EXPECT_TRUE(estimate.admissible) << estimate.reason;
    EXPECT_EQ(estimate.oscillation, 0);
    EXPECT_EQ(estimate.contact, 0);
    EXPECT_LT(estimate.relative, n == 1 ? 0.25 : 0.6 * last);
    last = estimate.relative;
  }
}

/// Three blocks at random of which one is glued to the one between, which slides on the other.
/// The bonded edges pay nothing, and u_hat is continuous there and clear on the others.
RC_GTEST_PROP(BondedEstimate, is_admissible_beside_what_slides,
              (Random random)) {
  const auto cells = [&] { return *rc::gen::inRange(2, 10); };
  const int bonded = *rc::gen::inRange(0, 2);
  Bodies three = partly_bonded_bodies(
      {shifted(with_random_rows(cells(), 2, 6, 2, random), {0, 5}),
       shifted(with_random_rows(cells(), 3, 6, 3, random), {0, 2}),
       with_random_rows(cells(), 2, 6, 2, random)},
      {stiff, soft, stiff}, {{0, bottom, 1, top}, {1, bottom, 2, top}}, bonded,
      *rc::gen::element(0.0, 0.3, 1.0));
  three.problem.law.multiplier =
      *rc::gen::element(Multiplier::force, Multiplier::pressure);
  clamp(three.problem, three.label(2, bottom));
  for (const int body : {0, 1})
    prescribe(three.problem, three.label(body, left), 0);
  add_traction(three.problem, three.label(0, top), {1, -7});
  add_traction(three.problem, three.label(1, right), {*real(-5, 5), 3});
  const ContactSolution<2> solution = solved(three.problem);
  RC_ASSERT(solution.status == ContactStatus::converged);
  const Estimate<2> estimate = estimated(three.problem, solution, sweeps(1));
  RC_ASSERT(estimate.admissible || !is_exact(estimate));
  const ContactLaw<2>& law = three.problem.law;
  for (int e = 0; e < three.problem.line.edge_count(); ++e)
    if (law.is_bonded(three.problem.line.edge_node(0, e)))
      RC_ASSERT(solution.state[three.problem.line.edge_node(0, e)] ==
                ContactState::stick);
  RC_ASSERT(estimate.penetration <= 1e-12 || !is_exact(estimate));
  RC_ASSERT(estimate.cone <= 1e-12);
  RC_ASSERT(estimate.contact >= 0);
}

TEST(BondedEstimate, says_where_supports_tear_the_bodies_apart) {
  Bodies two = bonded_blocks(5, 7, stiff, soft);
  prescribe_around(two);
  ContactSolution<2> solution = solved(two.problem);
  const int corner = two.joined.first_vertex[1] + 8 * 4;
  solution.displacement[2 * corner] += 1e-10;
  const Estimate<2> estimate = estimated(two.problem, solution, sweeps(0));
  EXPECT_FALSE(estimate.admissible);
  EXPECT_NE(estimate.reason.find("u jumps between bonded bodies by"),
            std::string::npos)
      << estimate.reason;
}

}  // namespace
}  // namespace ffcontact
