// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ffcontact/elastic/stress_terms.hpp"
#include "ffcontact/equilibrium/cone/contact_pass.hpp"
#include "ffcontact/estimate/bodies/unstressed.hpp"
#include "ffcontact/estimate/error/facing_error.hpp"
#include "ffcontact/estimate/error/surface_error.hpp"
#include "ffcontact/estimate/tractions/first_tractions.hpp"
#include "ffcontact/estimate/tractions/surface_tractions.hpp"
#include "ffcontact/interface/pairing/matching_faces.hpp"
#include "ffcontact/interface/traction_parts.hpp"
#include "support/cut_solids.hpp"
#include "support/same_digits.hpp"
#include "support/solid_estimates.hpp"
#include "support/solid_stacks.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A side moved down a little more at one end, another one held.
void press(SolidProblem& problem, int top, int ground, const Vector3d& shift) {
  problem.move(top, [&](const Vector3d& x) {
    return Vector3d(shift + 1e-4 * Vector3d(0, 0, x.x()));
  });
  problem.move(ground, [](const Vector3d&) { return Vector3d::Zero(); });
}

/// The halves of a solid, one a little above the other, pressed together.
SolidStack halves(const Vector3i& half_cells, double friction, double apart,
                  const Vector3d& shift, std::mt19937& random) {
  std::vector<SolidMesh> pieces =
      CutSolid(half_cells, false, 0.12, random).pieces(random);
  pieces[1].vertices.row(2).array() -= apart;
  SolidStack stack(pieces, friction);
  press(stack.problem, stack.label(0, high_z), stack.label(1, low_z), shift);
  return stack;
}

SolidStack random_halves(double friction, Random& random) {
  const Vector3d by = random_vector(3, random);
  const Vector3i cells(1 + random() % 2, 1 + random() % 2, 1 + random() % 2);
  SolidStack stack =
      halves(cells, friction, random() % 2 ? 1e-4 : 0,
             {1e-3 * by.x(), 1e-3 * by.y(), -1.6e-3 + 1e-3 * by.z()}, random);
  for (int body = 0; body < 2; ++body)
    if (random() % 3 == 0) stack.guide(body);
  return stack;
}

/// Three bodies around an edge, all of whose faces match: one on two others that touch.
struct ThreeAround {
  JoinedSolids joined;
  SolidProblem problem;

  explicit ThreeAround(double friction, std::mt19937& random)
      : joined(joined_mesh(
            CutSolid({1, 2, 1}, true, 0.12, random).pieces(random))),
        problem(joined.mesh, friction, {joined.label(0, low_z)}) {
    const auto pair = [&](int body, int side, int other, int other_side) {
      return facing(problem.mesh, problem.faces, joined.label(body, side),
                    joined.label(other, other_side))
          .surface;
    };
    problem.surface =
        joined_contact<3>({pair(0, low_z, 1, high_z), pair(0, low_z, 2, high_z),
                           pair(1, cut_label, 2, cut_label)});
    problem.law.friction =
        VectorXd::Constant(problem.surface.node_count(), friction);
    press(problem, joined.label(0, high_z), joined.label(1, low_z),
          {5e-4, 0, -1.5e-3});
    problem.move(joined.label(2, low_z),
                 [](const Vector3d&) { return Vector3d::Zero(); });
    problem.load(joined.label(2, high_x), {-3, 0.5, 0});
  }
};

bool all_match(const SolidProblem& problem) {
  const std::vector<MatchingFace> matches =
      matching_faces(problem.mesh, problem.faces, problem.surface);
  return std::all_of(matches.begin(), matches.end(),
                     [](const MatchingFace& match) { return match.face >= 0; });
}

void require_sound(const Estimate<3>& found) {
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
  const SolidProblem problem = random_halves(*real(0, 2), random).problem;
  RC_ASSERT(all_match(problem));
  const ContactSolution<3> solution = problem.solve();
  const Estimate<3> first = estimate(problem, solution, {0, 0}),
                    found = estimate(problem, solution, {7, 0});
  require_sound(found);
  RC_ASSERT(found.history.size() == 8u);
  RC_ASSERT(std::abs(found.history[0] - first.e) < 1e-6 * first.e);
  for (int k = 1; k < 8; ++k)
    RC_ASSERT(found.history[k] < found.history[k - 1]);
}

RC_GTEST_PROP(MatchingSolids, three_around_an_edge_are_admissible,
              (Random random)) {
  const SolidProblem problem = ThreeAround(*real(0, 1), random).problem;
  RC_ASSERT(all_match(problem));
  const ContactSolution<3> solution = problem.solve();
  RC_PRE(solution.status == ContactStatus::converged);
  const Estimate<3> found = estimate(problem, solution, {4, 0});
  RC_LOG() << found.reason << std::endl;
  RC_ASSERT(found.admissible);
  // where faces of one sheet meet at an angle directions turn over them
  if (!turns(problem.surface)) require_sound(found);
  RC_ASSERT(found.oscillation < 0.2 * found.e);
}

TEST(MatchingSolids, have_their_tractions_relaxed) {
  Random random(1);
  const SolidProblem problem =
      halves({2, 2, 2}, 0.7, 0, {4e-4, 2e-4, -1.5e-3}, random).problem;
  const Estimate<3> found = estimate(problem);
  const SurfaceTractions first =
      tractions_by_face(problem.surface, found.tractions);
  EXPECT_GT((found.face_tractions - first).cwiseAbs().maxCoeff(),
            0.01 * first.cwiseAbs().maxCoeff());
}

/// The e^2 that nothing lowers further.
double least_square(const SolidProblem& problem,
                    const ContactSolution<3>& solution) {
  const Topology<3> topology = topology_of(problem.mesh);
  const SolvedBody<3> body = solved_solid(problem, solution);
  const ElasticSystem system = problem.system();
  const LinearStresses<3> stress(
      stresses(problem.mesh, body.hooke, body.displacement));
  const SolvedProblem<3> solved{topology, problem.surface, system, body};
  MatchedBodies<3> bodies(solved);
  FirstTractions<3> first = first_tractions<3>(
      solved, bodies, stress_terms_of(solved), {}, body.displacement);
  const FaceTractions boundary = bodies.boundary_with(first.contact.densities);
  const FacetSetting<3> setting{
      {topology, body.hooke, boundary, body.body_loads, stress},
      contact_faces(problem.mesh, problem.faces, problem.surface, body.law,
                    body.displacement)};
  const FacetShare whole = whole_share<3>(topology);
  const NoExchange<3> none;
  FacetDescent<3> descent(setting.body, first.moments, whole, none);
  ContactPass<3> contact(setting, descent.forms(), first.moments);
  const double first_square = descent.begin();
  double square = first_square + contact.contact_part(), before = 2 * square;
  while (before - square > 1e-5 * square) {
    before = square;
    for (int step = 0; step < 30; ++step) {
      square -= descent.step();
      if (step % 3 == 2)
        square -= contact.pass(1e-8 * first_square, descent.corrections(),
                               descent.residual());
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

  const ContactSolution<3> together = two.solve(), glued = one.solve();
  EXPECT_LT(together.force.row(0).maxCoeff(), 0);
  const Estimate<3> of_two = estimate(two, together),
                    of_one = estimate(one, glued);
  EXPECT_NEAR(of_two.e / of_one.e, 1, 0.02);  // 16 steps from other tractions
  EXPECT_NEAR(least_square(two, together) / least_square(one, glued), 1, 1e-3);
}

TEST(MatchingSolids, have_the_same_digits_on_two_threads) {
  Random random(2);
  for (const SolidProblem& problem :
       {halves({2, 2, 2}, 0.5, 0, {1e-3, 5e-4, -1.5e-3}, random).problem,
        ThreeAround(0.5, random).problem})
    expect_same_digits_on_two_threads(problem);
}

/// Tractions linear between the nodes give on faces that match what they give on polygons,
/// whatever the directions at the nodes.
RC_GTEST_PROP(MatchingSolids, have_the_contact_part_of_facing_ones,
              (Random random)) {
  const SolidProblem problem = random() % 2 ? random_halves(0.5, random).problem
                                            : ThreeAround(0.5, random).problem;
  const SolidMesh& mesh = problem.mesh;
  const ContactSurface& surface = problem.surface;
  ContactLaw<3> law = problem.law;
  law.gap = random_vector(surface.node_count(), random);
  law.previous = random_matrix(2, surface.node_count(), random);
  const VectorXd u = random_vector(problem.b.size(), random);
  const Matrix3Xd r = random_matrix(3, surface.node_count(), random);
  const std::vector<ContactFacet<3>> contact =
      contact_faces(mesh, problem.faces, surface, law, u);
  RC_ASSERT(static_cast<int>(contact.size()) == surface.face_count());
  const SurfaceTractions by_face = tractions_by_face(surface, r);
  const VectorXd found = contact_error(contact, by_face),
                 expected = facing_contact_error(mesh, problem.faces, surface,
                                                 law, {r, by_face}, u);
  RC_ASSERT((found - expected).norm() < 1e-13 * expected.norm());
}

/// Of three bodies two match; and loads where bodies touch.
RC_GTEST_PROP(MatchingSolids, beside_others_are_admissible, (Random random)) {
  std::vector<SolidMesh> bodies =
      CutSolid({1, 2, 1}, false, 0.12, random).pieces(random);
  bodies.push_back(
      random_brick(random_cells(1, 4, random), {0, 0, -2}, {4, 2, 1}, random));
  SolidStack stack(bodies, *real(0.3, 1));
  press(stack.problem, stack.label(0, high_z), stack.label(2, low_z),
        {4e-4, -2e-4, -2e-3});
  if (random() % 2) stack.problem.load(stack.label(0, low_z), {0.5, 0, -1});
  if (random() % 2) stack.problem.load(stack.label(1, high_z), {0, 0.3, 0.2});
  const ContactSolution<3> solution = stack.problem.solve();
  const Estimate<3> found = estimate(stack.problem, solution);
  RC_ASSERT(found.reason == "");
  RC_ASSERT(found.equilibrium.largest() < 1e-10);
  RC_ASSERT(found.cone < 1e-13);
  RC_ASSERT(std::abs(found.history.back() - found.e) < 1e-12 * found.e);
  const SurfaceTractions first =
      tractions_by_face(stack.problem.surface, found.tractions);
  RC_ASSERT((found.face_tractions - first).cwiseAbs().maxCoeff() > 1e-6);
}

}  // namespace
}  // namespace ffcontact
