// SPDX-License-Identifier: GPL-3.0-or-later
// Solids whose contact normals turn over their faces: the pair obeys the law at every point.
#include <gtest/gtest.h>

#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/estimate/error/face_fields.hpp"
#include "support/solid_estimates.hpp"
#include "support/solid_stacks.hpp"
#include "support/turning.hpp"
#include "support/uniform.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// At this place of a face or a polygon: r in the cone of the coefficient mu, or of a bound
/// that is given, about n, and clear.
void obeys_the_law(const BoundedTraction& r, const FaceMotion& motion,
                   const VectorXd& place, double mu, double given,
                   const Vector2d& largest) {
  const Vector3d n = r.traction.normal * place, along = n.normalized(),
                 m = r.traction.turned * place;
  const double rn = r.traction.pressing * place;
  const Vector3d traction = rn * n + n.cross(m);
  const double pressed = traction.dot(along);
  const double rounding = 1e-11 * largest[0];
  RC_ASSERT(pressed <= rounding);
  RC_ASSERT((traction - pressed * along).norm() <=
            (given > 0 ? given : -mu * pressed) + rounding);
  RC_ASSERT(motion.depth_at(place) <= 1e-12 * largest[1]);
}

/// At 50 places.
void obeys_the_law_everywhere(const BoundedTraction& r,
                              const FaceMotion& motion, double mu, double given,
                              const Vector2d& largest, Random& random) {
  for (int k = 0; k < 50; ++k) {
    const VectorXd weights = random_vector(motion.corners(), random).cwiseAbs();
    obeys_the_law(r, motion, weights / weights.sum(), mu, given, largest);
  }
}

void is_judged(const SolidProblem& problem, double mu, double given,
               Random& random) {
  const ContactSolution<3> solution = problem.solve();
  RC_PRE(solution.status == ContactStatus::converged);
  const Estimate<3> found = estimate(problem, solution, {4, 0});
  RC_LOG() << found.reason << std::endl;
  RC_ASSERT(found.admissible);
  RC_ASSERT(found.contact >= 0);
  RC_ASSERT(found.equilibrium.largest() < 1e-10);
  const ContactSurface& surface = problem.surface;
  const std::vector<FrictionCone> cones = law_cones(problem.law);
  const TractionFields tractions{found.tractions, found.face_tractions};
  const Vector2d largest(found.face_tractions.cwiseAbs().maxCoeff(),
                         found.displacement.cwiseAbs().maxCoeff());
  const auto traction = [&](int m) {
    return traction_on_face(surface, cones, m, tractions);
  };
  if (!surface.against_a_body())
    for (int m = 0; m < surface.face_count(); ++m)
      obeys_the_law_everywhere(
          traction(m),
          motion_on_face(problem.faces, surface, problem.law, m, {},
                         found.displacement),
          mu, given, largest, random);
  for (const FacingPolygon& polygon : surface.polygons)
    obeys_the_law_everywhere(
        traction(polygon.contact_face).between(polygon.own),
        motion_on_polygon(problem.faces, surface, problem.law, polygon,
                          found.displacement),
        mu, given, largest, random);
}

RC_GTEST_PROP(CurvedSolids, on_a_foundation_obey_the_law_everywhere,
              (Random random)) {
  const double mu = *rc::gen::element(0.0, 0.3, 0.8);
  SolidProblem problem(
      random_brick(random_cells(2, 4, random), {0, 0, 0}, {3, 2, 1}, random),
      mu);
  problem.surface = turned_at_random(problem.surface, 0.3, random);
  const Index nodes = problem.surface.node_count();
  problem.law.gap = 1e-3 * random_vector(nodes, random);
  const double given = *rc::gen::element(0.0, 0.0, 5.0);
  if (given > 0) problem.law.slip_bound = VectorXd::Constant(nodes, given);
  const Vector3d shift = 2e-3 * random_vector(3, random) - Vector3d(0, 0, 3e-3);
  problem.move(high_z, [&](const Vector3d&) { return shift; });
  is_judged(problem, mu, given, random);
}

RC_GTEST_PROP(CurvedSolids, against_another_one_obey_the_law_everywhere,
              (Random random)) {
  const double mu = *rc::gen::element(0.0, 0.3);
  SolidProblem problem = random_solids(mu, random).problem;
  problem.surface = turned_at_random(problem.surface, 0.2, random);
  is_judged(problem, mu, 0, random);
}

}  // namespace
}  // namespace ffcontact
