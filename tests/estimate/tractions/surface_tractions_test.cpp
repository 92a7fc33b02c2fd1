// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/surface_tractions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "ffcontact/elastic/rigid_motions.hpp"
#include "ffcontact/estimate/error/surface_error.hpp"
#include "ffcontact/estimate/tractions/cone_projection.hpp"
#include "support/friction_cones.hpp"
#include "support/solid_problems.hpp"

namespace ffcontact {
namespace {

using namespace test;

bool is_in(const FrictionCone& cone, const Vector3d& r, double slack) {
  return r[0] <= slack && r.tail<2>().norm() <= cone.bound(r[0]) + slack;
}

RC_GTEST_PROP(ConeProjection, is_the_nearest_point, (Random random)) {
  const FrictionCone cone = any_cone(random);
  const Vector3d r = 2 * random_vector(3, random);
  const Vector3d nearest = cone_projection(cone, r).point;
  RC_ASSERT(is_in(cone, nearest, 1e-15));
  // no point of the convex cone lies beyond the plane through it
  for (int trial = 0; trial < 50; ++trial) {
    const Vector3d other = 3 * random_vector(3, random);
    if (is_in(cone, other, 0))
      RC_ASSERT((other - nearest).dot(r - nearest) < 1e-12);
  }
}

RC_GTEST_PROP(ConeProjection, slope_is_its_derivative, (Random random)) {
  const FrictionCone cone = any_cone(random);
  const Vector3d r = 2 * random_vector(3, random), d = random_vector(3, random);
  constexpr double h = 1e-6;
  const Vector3d plus = cone_projection(cone, r + h * d).point,
                 minus = cone_projection(cone, r - h * d).point,
                 at = cone_projection(cone, r).point;
  RC_PRE((plus + minus - 2 * at).norm() < 1e-9);  // no kink in between
  const Vector3d slope = cone_projection(cone, r).slope * d;
  RC_ASSERT((slope - (plus - minus) / (2 * h)).norm() < 1e-4);
}

/// A body held by contact alone, contact forces on it, and what they do along its motions.
struct Pressed {
  SolidProblem problem;
  Matrix3Xd lumped;
  MatrixXd motions;
  VectorXd resultants;

  explicit Pressed(Random& random) : problem(irregular_solid(random), 0.6) {
    const int nodes = problem.surface.node_count();
    Matrix3Xd force = 0.2 * random_matrix(3, nodes, random);
    force.row(0).array() -= 0.8;
    for (int i = 0; i < nodes; ++i) force.col(i) *= problem.surface.area[i];
    lumped = lumped_tractions(problem.law, problem.surface, force);
    motions = free_rigid_motions(problem.mesh,
                                 std::vector<char>(problem.b.size(), 0));
    resultants = motions.transpose() *
                 nodal_load(problem.surface, force, problem.b.size());
  }

  std::optional<Matrix3Xd> nearest(const Flags& carries = {}) const {
    return nearest_in_cone(problem.mesh, problem.faces, problem.surface,
                           problem.law, lumped, motions, resultants, carries);
  }
  double off(const Matrix3Xd& r) const {
    return (resultants_of(problem.mesh, problem.faces, problem.surface, r,
                          motions) -
            resultants)
        .norm();
  }
};

RC_GTEST_PROP(SurfaceTractions, have_the_resultants_of_the_forces,
              (Random random)) {
  // lumped tractions have the force, not the moment: those nearest to them have both
  const Pressed pressed(random);
  const auto r = pressed.nearest();
  RC_ASSERT(r.has_value());
  RC_ASSERT(cone_violation(pressed.problem.law, *r) < 1e-15);
  RC_ASSERT(pressed.off(*r) < 1e-11);
}

RC_GTEST_PROP(SurfaceTractions, stay_where_nodes_do_not_carry,
              (Random random)) {
  const Pressed pressed(random);
  Flags carries(pressed.lumped.cols(), 1);
  carries[random() % carries.size()] = 0;
  const auto r = pressed.nearest(carries);
  RC_ASSERT(r.has_value());
  RC_ASSERT(pressed.off(*r) < 1e-11);
  for (Index i = 0; i < r->cols(); ++i)
    RC_ASSERT((r->col(i) == pressed.lumped.col(i)) == !carries[i]);
}

TEST(SurfaceTractions, are_found_where_few_nodes_press) {
  // tractions in the cone that are tiny at most nodes, from far off: full steps of Newton
  // miss all of these, and some of any 300 are missed all the same
  int found = 0;
  for (unsigned seed : {102u, 173u, 361u, 440u, 486u, 578u}) {
    Random random(seed);
    const SolidProblem problem(irregular_solid(random), 0.6);
    const int nodes = problem.surface.node_count();
    Matrix3Xd inside = random_matrix(3, nodes, random);
    for (auto r : inside.colwise()) {
      r[0] = -std::pow(r[0], 12);
      r.tail<2>() *= -0.6 * r[0] / std::sqrt(2.0);
    }
    ASSERT_EQ(cone_violation(problem.law, inside), 0);
    const MatrixXd motions = free_rigid_motions(
        problem.mesh, std::vector<char>(problem.b.size(), 0));
    const auto resultants = [&](const Matrix3Xd& r) {
      return resultants_of(problem.mesh, problem.faces, problem.surface, r,
                           motions);
    };
    const VectorXd wanted = resultants(inside);
    const auto r = nearest_in_cone(
        problem.mesh, problem.faces, problem.surface, problem.law,
        2 * random_matrix(3, nodes, random), motions, wanted);
    if (!r) continue;
    ++found;
    EXPECT_LT((resultants(*r) - wanted).norm(), 1e-11) << seed;
    EXPECT_LT(cone_violation(problem.law, *r), 1e-15) << seed;
  }
  EXPECT_GE(found, 4);
}

TEST(SurfaceTractions, have_cones_in_units_of_tractions) {
  std::mt19937 random(2);
  SolidProblem problem(irregular_solid(random), 0.6);
  const int nodes = problem.surface.node_count();
  problem.law.slip_bound = VectorXd::Constant(nodes, 2);
  problem.law.shear_limit = VectorXd::Constant(nodes, 3);
  for (const FrictionCone& cone : traction_cones(problem.law)) {
    EXPECT_DOUBLE_EQ(cone.cohesion, 2);
    EXPECT_DOUBLE_EQ(cone.limit, 3);
  }
}

TEST(SurfaceTractions, go_on_where_held_nodes_touch) {
  SolidProblem problem(brick({3, 3, 1}, {3, 3, 1}), 0.2);
  problem.move(low_x, [](const Vector3d&) { return Vector3d::Zero(); });
  const int nodes = problem.surface.node_count();
  const VectorXd u = VectorXd::Zero(problem.b.size());
  Matrix3Xd r(3, nodes), expected(3, nodes);
  for (int i = 0; i < nodes; ++i) {
    const bool held = problem.mesh.vertices(0, problem.surface.vertex[i]) == 0;
    r.col(i) = held ? Vector3d::Zero() : Vector3d(-2, 0.4, 0);
    expected.col(i) = Vector3d(-2, 0.4, 0);
  }
  const auto continued = [&] {
    return continued_tractions(problem.law, problem.surface, u,
                               problem.system().prescribed, r);
  };
  EXPECT_LT((continued() - expected).norm(), 1e-14);
  problem.law.friction *= 0.5;  // in the cone of the held node
  EXPECT_LT((continued() - expected).norm(), 1);
  EXPECT_LT(cone_violation(problem.law, continued()), 0.3);
  problem.law.gap = VectorXd::Ones(nodes);
  EXPECT_EQ(continued(), r);
}

TEST(SurfaceTractions, none_pull) {
  std::mt19937 random(2);
  SolidProblem problem(irregular_solid(random), 0.6);
  const MatrixXd motions =
      free_rigid_motions(problem.mesh, std::vector<char>(problem.b.size(), 0));
  VectorXd lift = VectorXd::Zero(problem.b.size());
  for (int i = 0; i < problem.surface.node_count(); ++i)
    lift[3 * problem.surface.vertex[i] + 2] = -1;
  EXPECT_FALSE(nearest_in_cone(problem.mesh, problem.faces, problem.surface,
                               problem.law,
                               Matrix3Xd::Zero(3, problem.surface.node_count()),
                               motions, motions.transpose() * lift));
}

/// The contact part of e^2 for tractions at the nodes.
VectorXd parts_of(const SolidProblem& problem, const Matrix3Xd& r,
                  const VectorXd& u) {
  SurfaceTractions on_faces(9, problem.surface.face_count());
  for (int m = 0; m < problem.surface.face_count(); ++m)
    on_faces.col(m) =
        r(Eigen::all, problem.surface.face_node.col(m)).reshaped();
  return contact_error(contact_faces(problem.mesh, problem.faces,
                                     problem.surface, problem.law, u),
                       on_faces);
}

TEST(SurfaceError, of_linear_fields) {
  // (0, 1)^2: r = (-1 - x, 0.5, 0), w = (-y, 0, -3), mu = 2, gap 1 at u_n = 1 - y:
  // 2 int 2 (1 + x) 3 + (1 + x) y = 2 (9 + 3/4)
  SolidProblem problem(brick({1, 1, 1}, {1, 1, 1}), 2);
  const ContactSurface& surface = problem.surface;
  problem.law.gap = VectorXd::Ones(4);
  Matrix3Xd r(3, 4);
  VectorXd u = VectorXd::Zero(24);
  for (int i = 0; i < 4; ++i) {
    const Vector3d x = problem.mesh.vertices.col(surface.vertex[i]);
    r.col(i) << -1 - x.x(), 0.5, 0;
    u.segment<3>(3 * surface.vertex[i]) << 0, -3, -(1 - x.y());
  }
  const VectorXd parts = parts_of(problem, r, u);
  EXPECT_EQ(parts.size(), 2);
  EXPECT_NEAR(parts.sum(), 19.5, 1e-13);

  // |w_t| of a slip that changes its sign, by its Bernstein polynomial: a bound
  problem.law = {};
  problem.law.friction = VectorXd::Zero(4);
  problem.law.slip_bound = VectorXd::Ones(4);
  u.setZero();
  for (int i = 0; i < 4; ++i)
    u[3 * surface.vertex[i]] =
        problem.mesh.vertices(0, surface.vertex[i]) - 0.5;
  const double bound = parts_of(problem, Matrix3Xd::Zero(3, 4), u).sum();
  EXPECT_NEAR(bound, 2.0 / 3, 1e-14);  // the integral is 2 / 4
}

RC_GTEST_PROP(ContactFaces, moments_and_tractions_are_the_same,
              (Random random)) {
  SolidProblem problem(irregular_solid(random), 0.6);
  const std::vector<ContactFacet<3>> contact =
      contact_faces(problem.mesh, problem.faces, problem.surface, problem.law,
                    VectorXd::Zero(problem.b.size()));
  SurfaceTractions given = 0.1 * random_matrix(9, contact.size(), random);
  for (int i : {0, 3, 6}) given.row(i).array() -= 1;
  FaceMoments moments = FaceMoments::Zero(9, problem.faces.count());
  put_moments(contact, given, moments);
  RC_ASSERT((tractions_of(contact, moments) - given).norm() < 1e-13);
  // n is -z, t1 and t2 are x and y: the resultant is that of the moments
  Vector3d force = Vector3d::Zero();
  for (std::size_t m = 0; m < contact.size(); ++m)
    force +=
        contact[m].measure / 3 * given.col(m).reshaped(3, 3).rowwise().sum();
  const Vector3d sum = moments.reshaped(3, moments.size() / 3).rowwise().sum();
  RC_ASSERT((Vector3d(-sum.z(), sum.x(), sum.y()) - force).norm() < 1e-13);
}

TEST(ContactFaces, cut_off_rounding_alone) {
  SolidProblem problem(brick({1, 1, 1}, {1, 1, 1}), 0.5);
  const std::vector<ContactFacet<3>> contact =
      contact_faces(problem.mesh, problem.faces, problem.surface, problem.law,
                    VectorXd::Zero(problem.b.size()));
  for (double outside : {1e-14, 1e-6}) {
    SurfaceTractions given = SurfaceTractions::Zero(9, contact.size());
    given.col(0).head<3>() << -2, 1 + outside, 0;
    FaceMoments moments = FaceMoments::Zero(9, problem.faces.count());
    put_moments(contact, given, moments);
    const double left = cone_violation(contact, tractions_of(contact, moments));
    EXPECT_NEAR(left, outside < 1e-12 ? 0 : outside, 1e-15);
  }
}

TEST(SurfaceError, admissible_displacement_keeps_clear) {
  std::mt19937 random(2);
  SolidProblem problem(irregular_solid(random), 0.6);
  const VectorXd u = random_vector(problem.b.size(), random);
  std::vector<char> prescribed(u.size(), 0);
  const int held = problem.surface.vertex[3];
  prescribed[3 * held + 2] = 1;
  const VectorXd lowered = admissible_displacement(
      problem.faces, problem.surface, problem.law, u, prescribed);
  for (int dof = 0; dof < u.size(); ++dof) {
    const bool on_surface = dof % 3 == 2 &&
                            problem.mesh.vertices(2, dof / 3) == 0 &&
                            dof / 3 != held;
    const double expected = on_surface ? std::max(0.0, u[dof]) : u[dof];
    EXPECT_NEAR(lowered[dof], expected, 1e-15);
  }
  const DeepestNode deepest =
      deepest_node(problem.faces, problem.surface, problem.law, u);
  EXPECT_EQ(deepest.depth, -u[3 * problem.surface.vertex[deepest.node] + 2]);
}

}  // namespace
}  // namespace ffcontact
