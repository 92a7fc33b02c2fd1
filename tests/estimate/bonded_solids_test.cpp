// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/bonded_solids.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/estimate/displacement/bonded_displacement.hpp"
#include "ffcontact/estimate/displacement/following_faces.hpp"
#include "ffcontact/estimate/error/jump_on_surface.hpp"
#include "support/nested_solids.hpp"
#include "support/solid_estimates.hpp"
#include "support/uniform.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A linear displacement has no error, whatever the meshes between the bodies.
RC_GTEST_PROP(BondedSolidEstimate, linear_displacements_have_no_error,
              (Random random)) {
  SolidStack two = random_bonded_bricks(random);
  prescribe_uniform_stress(two);
  const Estimate<3> found = estimate(two.problem);
  RC_ASSERT(found.reason == "");
  RC_ASSERT(found.relative < 1e-9);
  RC_ASSERT(found.contact == 0);
  RC_ASSERT(found.oscillation < 1e-8);
}

RC_GTEST_PROP(BondedSolidEstimate, is_admissible, (Random random)) {
  SolidStack stack =
      random_stack(2 + static_cast<int>(random() % 2), 0, random);
  bond(stack.problem);
  pull(stack);
  const Estimate<3> found = estimate(stack.problem);
  RC_ASSERT(found.reason == "");
  RC_ASSERT(found.equilibrium.largest() < 1e-10);
  RC_ASSERT(found.cone == 0);
  RC_ASSERT(found.penetration < 1e-13);
  RC_ASSERT(found.contact == 0);
}

/// Bricks 12 x 12 x 6 and 12 x 12 x 8 of cubes 1 x 1 x 1 and larger, one on the other.
const Vector3i upper_fine(12, 12, 6), lower_fine(12, 12, 8);

SolidStack stack_of(int upper, int lower) {
  SolidStack two = bonded_stack(
      {brick(upper_fine / upper, upper_fine.cast<double>()),
       brick_at(lower_fine / lower, lower_fine.cast<double>(), {0, 0, -8})});
  pull(two);
  return two;
}

/// |u - u_h| of both bodies, where u is the solution on cells of size 1.
double error_of(const VectorXd& coarse, int upper, int lower) {
  const SolidStack fine = stack_of(1, 1);
  const SurfaceSolution reference = fine.problem.solve();
  const Index of_upper = 3 * (upper_fine.array() / upper + 1).prod();
  const VectorXd first = on_finer_brick(coarse.head(of_upper),
                                        upper_fine / upper, upper),
                 second = on_finer_brick(coarse.tail(coarse.size() - of_upper),
                                         lower_fine / lower, lower);
  VectorXd difference(first.size() + second.size());
  difference << first, second;
  difference -= reference.displacement;
  const RowMatrix K =
      stiffness(fine.problem.mesh, solved_solid(fine.problem, reference).hooke);
  return std::sqrt(difference.dot(K * difference));
}

TEST(BondedSolidEstimate, bounds_the_error_closely) {
  for (const auto& [upper, lower] : {std::pair(3, 2), std::pair(2, 4)}) {
    const SolidStack two = stack_of(upper, lower);
    const SurfaceSolution solution = two.problem.solve();
    const Estimate<3> found = estimate(two.problem, solution);
    ASSERT_EQ(found.reason, "");
    const double error = error_of(solution.displacement, upper, lower);
    EXPECT_GT(found.e + found.oscillation, error);
    EXPECT_LT(found.e, 1.4 * error);
    EXPECT_LT(found.oscillation, 0.5 * found.e);
  }
}

/// Where meshes match r_hat is relaxed, as tractions inside of one body are.
TEST(BondedSolidEstimate, of_meshes_that_match_is_that_of_one_mesh) {
  SolidStack two = bonded_bricks({3, 2, 2}, {3, 2, 2});
  pull(two);
  SolidProblem one(brick_at({3, 2, 4}, {3, 2, 2}, {0, 0, -1}));
  bond(one);
  one.load(high_z, {3, 1, 7});
  RelaxationSettings many;
  many.steps = 200;
  const Estimate<3> parts = estimate(two.problem, many),
                    whole = estimate(one, many);
  EXPECT_EQ(parts.reason, "");
  EXPECT_EQ(whole.reason, "");
  EXPECT_NEAR(parts.e, whole.e, 5e-3 * whole.e);
  EXPECT_LT(parts.oscillation, 1e-10 * parts.e);
}

/// Displacements of the lower body at random, which the upper one follows.
class Followed {
 public:
  explicit Followed(Random random)
      : two_(bonded_bricks({2, 2, 1}, {3, 4, 1})),
        topology_(topology_of(two_.problem.mesh)),
        u_(VectorXd::Zero(3 * topology_.mesh.vertex_count())) {
    const Uniform drawn{-1, 1};
    for (double& component : u_.tail(u_.size() - 3 * 18))
      component = drawn(random);
    SolvedBody<3> body = solved_solid(two_.problem, {});
    body.displacement = u_;
    const ElasticSystem system = two_.problem.system();
    u_ = bonded_displacement({topology_, two_.problem.surface, system, body});
  }
  const Topology<3>& topology() const { return topology_; }
  const VectorXd& displacement() const { return u_; }

  BondedJump jump() const {
    return bonded_jump(topology_, two_.problem.surface,
                       solved_solid(two_.problem, {}).hooke,
                       two_.problem.system().prescribed, u_);
  }

  /// u at a place on a side of a body.
  Vector3d on_side(int body, int side, const Vector3d& x) const {
    const SolidMesh& mesh = topology_.mesh;
    for (Index f = 0; f < mesh.boundary.cols(); ++f) {
      if (mesh.boundary_label[f] != two_.label(body, side)) continue;
      const Vector3i v = mesh.boundary.col(f);
      Matrix3d places = mesh.vertices(Eigen::all, v);
      places.row(2).setOnes();
      const Vector3d at = places.inverse() * Vector3d(x.x(), x.y(), 1);
      if (at.minCoeff() >= -1e-12) return vectors_at<3>(u_, v) * at;
    }
    return Vector3d::Constant(NAN);
  }
  Vector3d h(const Vector3d& x) const {
    return on_side(1, high_z, x) - on_side(0, low_z, x);
  }

 private:
  SolidStack two_;
  Topology<3> topology_;
  VectorXd u_;
};

/// w at a place of a cell of the upper body, which has its vertices below at z = 0 and the
/// others at z = 1: h where the ray from what is across meets z = 0.
Vector3d w_at(const Followed& followed, int cell, const Vector3d& x) {
  const SolidMesh& mesh = followed.topology().mesh;
  Vector3d below = Vector3d::Zero();
  Eigen::Matrix4d places;
  places << corners_of(mesh, cell), Eigen::RowVector4d::Ones();
  const Vector4d share = places.inverse() * x.homogeneous();
  double at_bottom = 0;
  for (int k = 0; k < 4; ++k)
    if (mesh.corner(cell, k).z() == 0) {
      below += share[k] * mesh.corner(cell, k);
      at_bottom += share[k];
    }
  return at_bottom * followed.h(below / at_bottom);
}

/// int C eps(w) : eps(w) by places at random, and differences around them.
double sampled_energy(const Followed& followed, int cell, Random random) {
  constexpr int samples = 400;
  constexpr double step = 1e-5;
  const SolidMesh& mesh = followed.topology().mesh;
  const VoigtMatrix<3> C = isotropic<3>(13e3 * 0.2 / 0.72, 13e3 / 2.4);
  const Uniform drawn{0, 1};
  double sum = 0;
  for (int k = 0; k < samples; ++k) {
    Vector4d share(drawn(random), drawn(random), drawn(random), drawn(random));
    share = -share.array().log();
    const Vector3d x = corners_of(mesh, cell) *
                       (0.01 / 4 + 0.99 * share.array() / share.sum()).matrix();
    Matrix3d gradient;
    for (int c = 0; c < 3; ++c)
      gradient.col(c) = (w_at(followed, cell, x + step * Vector3d::Unit(c)) -
                         w_at(followed, cell, x - step * Vector3d::Unit(c))) /
                        (2 * step);
    VoigtVector<3> strain;
    strain << gradient.diagonal(), gradient(1, 2) + gradient(2, 1),
        gradient(0, 2) + gradient(2, 0), gradient(0, 1) + gradient(1, 0);
    sum += strain.dot(C * strain);
  }
  return signed_volume(mesh, cell) * sum / samples;
}

TEST(BondedJump, has_the_norm_of_w) {
  const Followed followed(Random(7));
  const SolidMesh& mesh = followed.topology().mesh;
  double sum = 0;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const CellCorners<3> corners = corners_of(mesh, t);
    const auto below = (corners.row(2).array() == 0).count();
    if (corners.row(2).maxCoeff() == 1 && below > 1)
      sum += sampled_energy(followed, t, Random(t));
  }
  const BondedJump jump = followed.jump();
  EXPECT_LT(jump.left.depth, 1e-14);
  EXPECT_NEAR(jump.norm, std::sqrt(sum), 0.02 * jump.norm);
}

/// Of bodies of which neither covers the other, what follows says what is left.
TEST(BondedJump, is_left_where_faces_are_covered_in_part) {
  SolidStack two =
      bonded_stack({brick({3, 2, 1}, {3, 2, 1}),
                    brick_at({3, 3, 1}, {3, 2, 1}, {0.4, 0.5, -1})});
  pull(two);
  const Estimate<3> found = estimate(two.problem);
  EXPECT_FALSE(found.admissible);
  EXPECT_NE(found.reason.find("u jumps between bonded bodies by"),
            std::string::npos)
      << found.reason;
}

/// That which is covered follows, whichever carries the multipliers.
TEST(BondedJump, is_nothing_where_the_smaller_one_follows) {
  SolidStack two =
      bonded_stack({brick({4, 4, 1}, {3, 3, 1}),
                    brick_at({3, 2, 1}, {1.1, 1.3, 1}, {0.7, 0.8, -1})});
  pull(two);
  const Estimate<3> found = estimate(two.problem);
  EXPECT_EQ(found.reason, "");
  EXPECT_LT(found.penetration, 1e-13);
}

}  // namespace
}  // namespace ffcontact
