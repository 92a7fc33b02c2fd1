// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>

#include "ffcontact/estimate/facing_error.hpp"
#include "ffcontact/estimate/first_surface_tractions.hpp"
#include "ffcontact/estimate/surface_tractions.hpp"
#include "ffcontact/estimate/unstressed.hpp"
#include "support/cut_solids.hpp"
#include "support/solid_estimates.hpp"
#include "support/solid_stacks.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The upper half of a solid pressed on its lower one, and moved sideways.
struct Halves {
  CutSolid cut;
  SolidStack stack;

  Halves(const Vector3i& half_cells, double friction, const Vector3d& shift,
         std::mt19937& random)
      : cut(half_cells, false, 0.12, random),
        stack(cut.pieces(random), friction) {
    press(stack.problem, stack.label(0, high_z), stack.label(1, low_z), shift);
  }

  static void press(SolidProblem& problem, int top, int ground,
                    const Vector3d& shift) {
    problem.move(top, [&](const Vector3d& x) {
      return Vector3d(shift + 1e-4 * Vector3d(0, 0, x.x()));
    });
    problem.move(ground, [](const Vector3d&) { return Vector3d::Zero(); });
  }
};

Halves random_halves(double friction, Random& random) {
  const Vector3d by = random_vector(3, random);
  return {Vector3i(1 + random() % 2, 1 + random() % 2, 1 + random() % 2),
          friction,
          {1e-3 * by.x(), 1e-3 * by.y(), -1.2e-3 + 1e-3 * by.z()},
          random};
}

void require_sound(const SolidEstimate& found) {
  RC_ASSERT(found.reason == "");
  RC_ASSERT(found.equilibrium.largest() < 1e-10);
  RC_ASSERT(found.cone < 1e-13);
  RC_ASSERT(found.oscillation < 1e-9 * found.e);
  RC_ASSERT(std::abs(found.local.norm() - found.relative) <
            1e-12 * found.relative);
  RC_ASSERT(std::abs(found.history.back() - found.e) < 1e-12 * found.e);
  const double e = found.e;
  RC_ASSERT(std::abs(found.elastic * found.elastic + found.contact - e * e) <
            1e-12 * e * e);
}

RC_GTEST_PROP(MatchingSolids, are_admissible_and_nearer_with_every_step,
              (Random random)) {
  const Halves halves = random_halves(*real(0, 2), random);
  const SurfaceSolution solution = halves.stack.problem.solve();
  const SolidEstimate first = estimate(halves.stack.problem, solution, {0, 0}),
                      found = estimate(halves.stack.problem, solution, {7, 0});
  require_sound(found);
  RC_ASSERT(found.history.size() == 8u);
  RC_ASSERT(std::abs(found.history[0] - first.e) < 1e-6 * first.e);
  for (int k = 1; k < 8; ++k)
    RC_ASSERT(found.history[k] < found.history[k - 1]);
}

TEST(MatchingSolids, have_their_tractions_relaxed) {
  Random random(1);
  const Halves halves({2, 2, 2}, 0.7, {4e-4, 2e-4, -1.5e-3}, random);
  const SolidEstimate found = estimate(halves.stack.problem);
  const SurfaceTractions first =
      tractions_by_face(halves.stack.problem.surface, found.tractions);
  EXPECT_GT((found.face_tractions - first).cwiseAbs().maxCoeff(),
            0.01 * first.cwiseAbs().maxCoeff());
}

/// The e^2 that nothing lowers further.
double least_square(const SolidProblem& problem,
                    const SurfaceSolution& solution) {
  const SolidTopology topology = topology_of(problem.mesh);
  const SolvedSolid body = solved_solid(problem, solution);
  const ElasticSystem system = problem.system();
  const Matrix6Xd stress =
      stresses(problem.mesh, body.hooke, body.displacement);
  const FirstSurfaceTractions first = first_tractions(
      {topology, problem.surface, system, body}, stress,
      largest_stress_terms(problem.mesh, body.hooke, body.displacement));
  const FaceSetting setting{
      topology,
      body.hooke,
      first.boundary,
      body.body_loads,
      stress,
      contact_faces(problem.mesh, problem.faces, problem.surface, body.law,
                    body.displacement)};
  FaceDescent descent(setting, first.moments);
  double square = descent.first_square() + descent.first_contact_part(),
         before = 2 * square;
  while (before - square > 1e-5 * square) {
    before = square;
    for (int step = 0; step < 30; ++step) {
      square -= descent.step();
      if (step % 3 == 2) square -= descent.contact_pass();
    }
  }
  return square;
}

/// Pressed and pushed a little, so that no resultant depends on the stiffness.
void put_on_ground(SolidProblem& problem, int top, int ground) {
  problem.load(top, {0.5, 0.2, -10});
  problem.move(ground, [](const Vector3d&) { return Vector3d::Zero(); });
}

/// Where all sticks under pressure two bodies are one, and their error is that of one.
TEST(MatchingSolids, that_stick_have_the_error_of_one_body) {
  Random random(1);
  const CutSolid cut({1, 2, 1}, false, 0.12, random);
  SolidStack stack(cut.pieces(random), 1e3);
  SolidProblem& two = stack.problem;
  SolidProblem one(cut.whole, 0, {high_x});  // far from what it faces
  one.law.gap = VectorXd::Ones(one.surface.node_count());
  put_on_ground(one, high_z, low_z);
  put_on_ground(two, stack.label(0, high_z), stack.label(1, low_z));

  const SurfaceSolution together = two.solve(), glued = one.solve();
  EXPECT_LT(together.force.row(0).maxCoeff(), 0);
  const SolidEstimate of_two = estimate(two, together),
                      of_one = estimate(one, glued);
  EXPECT_NEAR(of_two.e / of_one.e, 1, 0.02);  // 16 steps from other tractions
  EXPECT_NEAR(least_square(two, together) / least_square(one, glued), 1, 1e-3);
}

TEST(MatchingSolids, have_the_same_digits_on_two_threads) {
  Random random(2);
  const Halves halves({2, 2, 2}, 0.5, {1e-3, 5e-4, -1.5e-3}, random);
  const SurfaceSolution solution = halves.stack.problem.solve();
  const SolidEstimate one = estimate(halves.stack.problem, solution);
  omp_set_num_threads(2);
  const SolidEstimate two = estimate(halves.stack.problem, solution);
  omp_set_num_threads(1);
  EXPECT_EQ(one.history, two.history);
  EXPECT_EQ(one.moments, two.moments);
  EXPECT_EQ(one.local, two.local);
  EXPECT_EQ(one.face_tractions, two.face_tractions);
}

/// Tractions linear between the nodes give on faces that match what they give on polygons.
RC_GTEST_PROP(MatchingSolids, have_the_contact_part_of_facing_ones,
              (Random random)) {
  SolidStack stack = random_halves(*real(0, 2), random).stack;
  const auto& [mesh, faces, surface, law, A, b, neumann] = stack.problem;
  SurfaceLaw other = law;
  other.gap = random_vector(surface.node_count(), random);
  other.previous = random_matrix(2, surface.node_count(), random);
  const VectorXd u = random_vector(b.size(), random);
  const Matrix3Xd r = random_matrix(3, surface.node_count(), random);
  const std::vector<ContactFace> contact =
      contact_faces(mesh, faces, surface, other, u);
  RC_ASSERT(static_cast<int>(contact.size()) == surface.face_count());
  const VectorXd found = contact_error(contact, tractions_by_face(surface, r)),
                 expected =
                     facing_contact_error(mesh, faces, surface, other, r, u);
  RC_ASSERT((found - expected).norm() < 1e-13 * expected.norm());
}

/// Of three bodies two match; and loads where bodies touch.
RC_GTEST_PROP(MatchingSolids, beside_others_are_admissible, (Random random)) {
  std::vector<SolidMesh> bodies =
      CutSolid({1, 2, 1}, false, 0.12, random).pieces(random);
  bodies.push_back(
      random_brick(random_cells(1, 4, random), {0, 0, -2}, {4, 2, 1}, random));
  SolidStack stack(bodies, *real(0.3, 1));
  Halves::press(stack.problem, stack.label(0, high_z), stack.label(2, low_z),
                {4e-4, -2e-4, -2e-3});
  const bool is_loaded = random() % 2;
  if (is_loaded) stack.problem.load(stack.label(0, low_z), {0.5, 0, -1});
  if (random() % 2) stack.problem.load(stack.label(1, high_z), {0, 0.3, 0.2});
  const SurfaceSolution solution = stack.problem.solve();
  const SolidEstimate found = estimate(stack.problem, solution);
  RC_ASSERT(found.reason == "");
  RC_ASSERT(found.equilibrium.largest() < 1e-10);
  RC_ASSERT(found.cone < 1e-13);
  RC_ASSERT(std::abs(found.history.back() - found.e) < 1e-12 * found.e);
  const SurfaceTractions first =
      tractions_by_face(stack.problem.surface, found.tractions);
  const bool relaxed =
      (found.face_tractions - first).cwiseAbs().maxCoeff() > 1e-6;
  RC_ASSERT(relaxed == !is_loaded);
}

}  // namespace
}  // namespace ffcontact
