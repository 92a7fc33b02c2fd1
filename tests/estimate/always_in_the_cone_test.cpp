// SPDX-License-Identifier: GPL-3.0-or-later
// Every contact line, law and multiplier has an admissible pair: tractions in the cone,
// stresses in equilibrium.
#include "support/cases.hpp"
#include "support/estimates.hpp"
#include "support/refusals.hpp"
#include "support/turning.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// An irregular rectangle bent so that its bottom is a polygon on a circle of radius 12
/// that touches y = 0 in the middle.
Mesh bent(Random& random) {
  Mesh mesh = irregular(*rc::gen::inRange(3, 10), *rc::gen::inRange(2, 5), 6, 4,
                        random);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const double x = mesh.vertices(0, v) - 3, y = mesh.vertices(1, v);
    mesh.vertices(1, v) = y + (1 - y / 4) * (12 - std::sqrt(144 - x * x));
  }
  return mesh;
}

/// The bottom with one given direction, up to 17 degrees away from the vertical, with its
/// edges' normals, or with directions at random that turn along the edges.
ContactLine random_line(const Mesh& mesh, Random& random) {
  const Edges edges = edges_of(mesh);
  const int kind = *rc::gen::inRange(0, 5);
  if (kind == 0) return contact_line(mesh, edges, {bottom});
  const ContactLine line = smooth_contact_line(mesh, edges, {bottom});
  if (kind < 3) return turned_at_random(line, *real(0, 0.4), random);
  const double angle = *real(-0.3, 0.3);
  return along_directions(mesh, edges, line,
                          Vector2d(std::sin(angle), -std::cos(angle))
                              .replicate(1, line.node_count()));
}

void set_law(Problem& problem, const std::string& law) {
  set_friction(problem, law == "frictionless" ? 0 : *real(0.05, 0.8));
  if (law == "thin cone")
    set_friction(problem, *rc::gen::element(1e-6, 1e-4, 4e-3));
  if (law == "tresca")
    problem.law.slip_bound = everywhere(problem.line, *real(0, 3));
  if (law == "friction in part")
    for (int i = 0; i < problem.line.node_count(); i += 2)
      problem.law.friction[i] = 0;
}

Problem random_problem(const std::string& law) {
  Random random = *rc::gen::arbitrary<Random>();
  const Mesh mesh = bent(random);
  Problem problem = body(mesh, material(1000, *real(0, 0.45)));
  problem.line = random_line(mesh, random);
  add_traction(problem, left, *vector_in(1, 1));
  add_traction(problem, right, *vector_in(1, 1));
  if (*rc::gen::arbitrary<bool>()) {
    clamp(problem, top,
          [motion = *vector_in(0.05, 0.02)](const Vector2d&) -> Vector2d {
            return motion - Vector2d(0, 0.04);
          });
  } else {
    prescribe(problem, right, 0);  // only contact holds it vertically
    add_traction(problem, top, *vector_in(1, 1) - Vector2d(0, 4));
  }
  set_law(problem, law);
  problem.law.multiplier =
      *rc::gen::element(Multiplier::force, Multiplier::pressure);
  problem.law.gap.resize(problem.line.node_count());
  for (int i = 0; i < problem.line.node_count(); ++i)
    problem.law.gap[i] =
        mesh.vertices(1, problem.line.vertex[i]) * *rc::gen::element(0, 1);
  return problem;
}

/// r_hat is in the cone about n(s), and u_hat is clear of the foundation, at 100 points an
/// edge.
void obeys_the_law_between_the_nodes(const Problem& problem,
                                     const Estimate<2>& estimate) {
  const ContactLine& line = problem.line;
  const ContactLaw<2>& law = problem.law;
  const double most = largest_traction(estimate.tractions),
               deepest = 1e-13 * estimate.displacement.cwiseAbs().maxCoeff();
  for (int e = 0; e < line.edge_count(); ++e)
    for (int k = 0; k <= 100; ++k) {
      const double s = k / 100.0;
      const Vector2d n = frame_at(line, e, s).col(0).normalized(),
                     r = traction_at(line, estimate.tractions, e, s);
      const auto along = [&](const VectorXd& values) {
        return between(values[line.edge_node(0, e)],
                       values[line.edge_node(1, e)], s);
      };
      const double bound = law.tresca() ? along(law.slip_bound)
                                        : along(law.friction) * -r.dot(n);
      RC_ASSERT(r.dot(n) <= 1e-12 * most);
      RC_ASSERT(std::abs(n.x() * r.y() - n.y() * r.x()) <=
                bound + 1e-12 * most);
      RC_ASSERT(motion_at(line, law.gap, estimate.displacement, e, s)[0] <=
                deepest);
    }
}

void is_admissible(const std::string& law) {
  const Problem problem = random_problem(law);
  const ContactSolution<2> solution = solved(problem);
  RC_PRE(solution.accepted({}));
  RC_PRE((solution.pressure.row(0).array() < 0).count() > 1);
  const Tractions tractions =
      *rc::gen::element(Tractions::free, Tractions::fixed);
  const Estimate<2> estimate =
      estimated(problem, solution, sweeps(*rc::gen::inRange(0, 5), tractions));
  RC_LOG() << "cone " << estimate.cone << ", equilibrium "
           << estimate.equilibrium.largest();
  RC_ASSERT(cone_defect(problem.line, problem.law, estimate.tractions) <=
            1e-12);
  RC_ASSERT(estimate.equilibrium.largest() <= 1e-10);
  RC_ASSERT(estimate.unmended.empty());
  RC_ASSERT(estimate.admissible);
  obeys_the_law_between_the_nodes(problem, estimate);
}

RC_GTEST_PROP(AlwaysInTheCone, without_friction, ()) {
  is_admissible("frictionless");
}
RC_GTEST_PROP(AlwaysInTheCone, with_coulombs_law, ()) {
  is_admissible("coulomb");
}
RC_GTEST_PROP(AlwaysInTheCone, in_a_thin_cone, ()) {
  is_admissible("thin cone");
}
RC_GTEST_PROP(AlwaysInTheCone, with_trescas_law, ()) {
  is_admissible("tresca");
}
RC_GTEST_PROP(AlwaysInTheCone, with_friction_at_every_other_node, ()) {
  is_admissible("friction in part");
}

}  // namespace
}  // namespace ffcontact
