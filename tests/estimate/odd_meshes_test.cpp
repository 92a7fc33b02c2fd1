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
  constexpr int rings = 36, sectors = 6;
  Mesh mesh;
  const auto id = [](int k, int a) { return k * (sectors + 1) + a; };
  mesh.vertices.resize(2, (rings + 1) * (sectors + 1));
  for (int k = 0; k <= rings; ++k)
    for (int a = 0; a <= sectors; ++a) {
      const double r = std::pow(1e-4, 1 - k / double(rings)),
                   angle = a * std::acos(0) / sectors;
      mesh.vertices.col(id(k, a)) << (a == sectors ? 0 : r * std::cos(angle)),
          r * std::sin(angle);
    }
  mesh.cells.resize(3, 2 * rings * sectors);
  for (int k = 0; k < rings; ++k)
    for (int a = 0; a < sectors; ++a) {
      const int t = 2 * (k * sectors + a);
      mesh.cells.col(t) << id(k, a), id(k + 1, a), id(k + 1, a + 1);
      mesh.cells.col(t + 1) << id(k, a), id(k + 1, a + 1), id(k, a + 1);
    }
  mesh.boundary.resize(2, 2 * (rings + sectors));
  mesh.boundary_label.resize(2 * (rings + sectors));
  int next = 0;
  const auto add = [&](int a, int b, Side side) {
    mesh.boundary.col(next) << a, b;
    mesh.boundary_label[next++] = side;
  };
  for (int k = 0; k < rings; ++k)
    add(id(k, 0), id(k + 1, 0), bottom),
        add(id(k + 1, sectors), id(k, sectors), top);
  for (int a = 0; a < sectors; ++a)
    add(id(rings, a), id(rings, a + 1), right),
        add(id(0, a + 1), id(0, a), left);
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

std::string in_figures(const Estimate& estimate) {
  std::ostringstream text;
  text << "equilibrium " << estimate.equilibrium.largest() << ", cone "
       << estimate.cone;
  return text.str();
}

void keeps_what_is_promised(const std::string& name, const Mesh& mesh,
                            double push = 3) {
  for (Multiplier multiplier : {Multiplier::force, Multiplier::pressure}) {
    const Problem problem = pressed(mesh, multiplier, push);
    const ContactSolution solution = solved(problem);
    ASSERT_TRUE(solution.accepted({}))
        << name << ": " << in_words(solution.status) << ", violation "
        << solution.complementarity << ", residual " << solution.residual;
    ASSERT_GT((solution.pressure.row(0).array() < 0).count(), 1) << name;
    const Estimate estimate = estimated(problem, solution, sweeps(3));
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
