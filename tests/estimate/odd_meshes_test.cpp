// SPDX-License-Identifier: GPL-3.0-or-later
// Thin, graded and badly shaped triangles: what is promised of the admissible pair holds
// on them as well.
#include <sstream>

#include "support/cases.hpp"
#include "support/estimates.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A body that is pressed and pushed, with friction.
Problem pressed(const Mesh& mesh, Multiplier multiplier, double push) {
  Problem problem = body(mesh, material(1000, 0.3));
  add_traction(problem, left, {push, 0});
  clamp(problem, top, [](const Vector2d&) { return Vector2d(0.001, -0.003); });
  set_friction(problem, 0.3);
  problem.law.multiplier = multiplier;
  return problem;
}

/// Cells of aspect 50 along the contact line, or across it.
Mesh thin(bool along) {
  return along ? rectangle(4, 100, 2, 1) : rectangle(100, 2, 2, 2);
}

/// A quarter of a ring whose cells grow with the radius from 1e-4 to 1; its lower side is
/// the contact line.
Mesh graded() {
  Mesh mesh = rectangle(36, 6, 1, 1);
  for (auto x : mesh.vertices.colwise()) {
    const double r = std::pow(1e-4, 1 - x.x()), angle = x.y() * std::acos(0);
    x << (x.y() == 1 ? 0 : r * std::cos(angle)), r * std::sin(angle);
  }
  return mesh;
}

/// Every other inner vertex is moved down on the edge below it, up to an angle of 1
/// degree.
Mesh badly_shaped() {
  Mesh mesh = rectangle(8, 8, 2, 1);
  for (int j = 1; j < 8; j += 2)
    for (int i = 1; i < 8; i += 2)
      mesh.vertices(1, 9 * j + i) -= 0.125 - 0.0055;
  return mesh;
}

double smallest_angle(const Mesh& mesh) {
  double smallest = 180;
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vector2d a = mesh.corner(t, (k + 1) % 3) - mesh.corner(t, k),
                     b = mesh.corner(t, (k + 2) % 3) - mesh.corner(t, k);
      smallest = std::min(
          smallest, std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) * 180 /
                        static_cast<double>(EIGEN_PI));
    }
  return smallest;
}

std::string in_figures(const Estimate<2>& estimate) {
  std::ostringstream text;
  text << "equilibrium " << estimate.equilibrium.largest() << ", cone "
       << estimate.cone;
  return text.str();
}

void keeps_what_is_promised(const std::string& name, const Mesh& mesh,
                            double push = 3) {
  for (Multiplier multiplier : {Multiplier::force, Multiplier::pressure}) {
    const Problem problem = pressed(mesh, multiplier, push);
    const ContactSolution<2> solution = solved(problem);
    ASSERT_TRUE(solution.accepted({}))
        << name << ": " << in_words(solution.status) << ", violation "
        << solution.complementarity << ", residual " << solution.residual;
    ASSERT_GT((solution.pressure.row(0).array() < 0).count(), 1) << name;
    const Estimate<2> estimate = estimated(problem, solution, sweeps(3));
    testing::Test::RecordProperty(
        name + (multiplier == Multiplier::force ? "_force" : "_pressure"),
        in_figures(estimate));
    EXPECT_LE(estimate.equilibrium.largest(), 1e-10)
        << name << ", angle " << smallest_angle(mesh);
    EXPECT_LE(estimate.cone, 1e-12) << name;
    EXPECT_TRUE(estimate.admissible) << name << ": " << estimate.reason;
    EXPECT_LT(estimate.e, estimate.history.front()) << name;
  }
}

TEST(OddMeshes, thin_triangles_along_the_contact_line) {
  keeps_what_is_promised("along", thin(true));
}
TEST(OddMeshes, thin_triangles_across_the_contact_line) {
  keeps_what_is_promised("across", thin(false));
}
TEST(OddMeshes, sizes_that_differ_by_ten_thousand) {
  keeps_what_is_promised("graded", graded(), 0);
}

TEST(OddMeshes, angles_of_one_degree) {
  EXPECT_NEAR(smallest_angle(badly_shaped()), 1, 0.5);
  keeps_what_is_promised("badly shaped", badly_shaped());
}

}  // namespace
}  // namespace ffcontact
