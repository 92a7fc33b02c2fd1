// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <functional>

#include "ffcontact/bounds/quantity_bounds.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "support/quantities.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/solid_bodies.hpp"
#include "support/solid_estimates.hpp"
#include "support/solid_springs.hpp"

namespace ffcontact {
namespace {

using namespace test;

using Chosen = std::function<bool(const Vector3d& centroid)>;

/// int p . v + M : C eps(v) over cells that are chosen.
Quantity<3> in_cells(const SolidMesh& mesh, const HookeTensors<3>& hooke,
                     const Vector3d& p, const VectorOf<6>& M,
                     const Chosen& chosen) {
  Quantity<3> quantity = no_quantity<3>(mesh);
  CellStresses<3> q = CellStresses<3>::Zero(6, mesh.cells.cols());
  for (int t = 0; t < mesh.cell_count(); ++t) {
    if (!chosen(centroid_of(mesh, t))) continue;
    quantity.body_loads.col(t) =
        (signed_volume(mesh, t) / 4 * p).replicate<4, 1>();
    q.col(t) = hooke[t] * M;
  }
  quantity.stress = LinearStresses<3>(q);
  return quantity;
}

/// A problem as contactsolve leaves it.
struct SolidWithAnswer {
  SolidProblem problem;
  Topology<3> topology = topology_of(problem.mesh);
  ElasticSystem system = problem.system();
  SolvedBody<3> body = solved_solid(problem, problem.solve());

  explicit SolidWithAnswer(SolidProblem any,
                           const BoundarySprings<3>& springs = {})
      : problem(std::move(any)) {
    body.springs = springs;
  }

  QuantityBounds bounds(const Quantity<3>& quantity,
                        const BoundSettings& settings = {}) const {
    const SolvedProblem<3> solved{topology, problem.surface, system, body};
    return quantity_bounds<3>(
        solved, estimate_error<3>(topology, problem.surface, system, body),
        quantity, settings);
  }
};

VectorXd on_all_nodes(const SolidProblem& problem, double value) {
  return VectorXd::Constant(problem.surface.node_count(), value);
}

const Vector3d block_size(80, 40, 40);

SolidProblem tresca_block(int cells, double slip_bound) {
  SolidProblem problem = block_problem(
      brick({2 * cells, cells, cells}, block_size), BlockCase::press, 0);
  if (slip_bound > 0)
    problem.law.slip_bound = on_all_nodes(problem, slip_bound);
  return problem;
}

/// The solution is linear, and so is the response to the quantity.
TEST(BoundsOfSolids, have_what_the_mesh_knows_exactly_between_them) {
  SolidProblem problem(brick({3, 2, 2}, {3, 2, 2}));
  problem.guide(low_x, 0);
  problem.guide(low_y, 1);
  problem.load(high_z, {0, 0, -5});
  const QuantityBounds found = SolidWithAnswer(problem).bounds(
      on_label<3>(problem.mesh, high_z, {0, 0, 1}));
  const double exact = -5 * 2.0 / 13e3 * 6;
  EXPECT_LE(found.lower, exact);
  EXPECT_GE(found.upper, exact);
  EXPECT_LT(found.width(), 1e-10 * std::abs(exact));
}

/// Widths in % of the midpoint, each with the interval of the finer mesh inside but for
/// the steps that are searched.
TEST(BoundsOfSolids, get_narrower_with_the_mesh) {
  for (const double slip_bound : {0.0, 2.0}) {
    const auto found = [&](int cells) {
      const SolidWithAnswer solved(tresca_block(cells, slip_bound));
      return solved.bounds(
          on_label<3>(solved.problem.mesh, high_x, {1.0 / 1600, 0, 0}));
    };
    const QuantityBounds coarse = found(2), fine = found(4);
    EXPECT_GT(fine.upper, coarse.lower);
    EXPECT_LT(fine.lower, coarse.upper);
    EXPECT_LT(fine.width(), 0.6 * coarse.width());
  }
}

TEST(BoundsOfSolids, are_apart_by_what_the_cells_contribute) {
  const SolidWithAnswer solved(tresca_block(2, 2));
  const QuantityBounds found = solved.bounds(
      in_cells(solved.problem.mesh, solved.body.hooke, {1, -2, 0.5},
               (VectorOf<6>() << 0, 0, 1, 0, 0.3, 0).finished(),
               [](const Vector3d& x) { return x.x() < 40; }));
  ASSERT_TRUE(found.found());
  EXPECT_NEAR(found.local.sum(), found.width(), 1e-10 * found.width());
  EXPECT_GE(found.local.minCoeff(), -1e-12 * found.width());
}

/// The lower side of one of two bricks faces the upper side of the other.
SolidStack two_bricks(const Vector3i& above, const Vector3i& below,
                      double slip_bound) {
  SolidMesh upper = brick(above, {2, 1, 1});
  upper.vertices.row(2).array() += 1;
  SolidStack stack({upper, brick(below, {2, 1, 1})}, 0);
  SolidProblem& problem = stack.problem;
  if (slip_bound > 0)
    problem.law.slip_bound = on_all_nodes(problem, slip_bound);
  problem.move(stack.label(1, low_z),
               [](const Vector3d&) { return Vector3d::Zero(); });
  problem.move(stack.label(0, high_z), [](const Vector3d& x) {
    return Vector3d(2e-3, 0, -1e-3 - 2e-4 * x.x());
  });
  problem.load(stack.label(1, high_x), {3, 0, 0});
  return stack;
}

/// On meshes that are nested.
void expect_narrower(const SolidStack& coarse, const SolidStack& fine,
                     double times) {
  const auto found = [](const SolidStack& stack) {
    return SolidWithAnswer(stack.problem)
        .bounds(on_label<3>(stack.problem.mesh, stack.label(0, high_x),
                            {1, 0, 0.5}));
  };
  const QuantityBounds wide = found(coarse), narrow = found(fine);
  EXPECT_EQ(wide.reason, "");
  EXPECT_EQ(narrow.reason, "");
  EXPECT_NEAR(narrow.local.sum(), narrow.width(), 1e-10 * narrow.width());
  EXPECT_GT(narrow.upper, wide.lower);
  EXPECT_LT(narrow.lower, wide.upper);
  EXPECT_LT(narrow.width(), times * wide.width());
}

TEST(BoundsOfSolids, are_of_bodies_that_face_each_other) {
  const Vector3i cells(4, 2, 2);
  for (const double bound : {0.0, 2.0})
    expect_narrower(two_bricks(cells, cells, bound),
                    two_bricks(2 * cells, 2 * cells, bound), 0.6);
}

TEST(BoundsOfSolids, are_of_bodies_whose_meshes_do_not_match) {
  const Vector3i above(4, 2, 2), below(5, 3, 2);
  for (const double bound : {0.0, 2.0})
    expect_narrower(two_bricks(above, below, bound),
                    two_bricks(2 * above, 2 * below, bound), 0.7);
}

/// A random block, law and quantity on meshes of Kuhn's bricks, which are nested.
class RandomProblem {
 public:
  explicit RandomProblem(Random& random)
      : map_(Matrix3d::Identity() + 0.3 * random_matrix(3, 3, random)),
        shift_(1e-3 * random_vector(3, random)),
        on_x_(5 * random_vector(3, random)),
        on_y_(5 * random_vector(3, random)),
        law_(1e-4 * random_matrix(3, 3, random)),
        slip_bound_(*rc::gen::inRange(0, 3) * *real(0, 2)),
        turn_(*rc::gen::inRange(0, 2) * 0.1 * random_vector(2, random)),
        spring_{*rc::gen::inRange(0, 2) * random_stiffness(3, 1e3, random),
                1e-3 * random_vector(3, random)},
        kind_(static_cast<int>(random() % 3)),
        w_(random_vector(3, random)),
        M_(random_vector(6, random)) {
    map_.row(2).head<2>().setZero();
    shift_.z() = -std::abs(shift_.z());
  }

  SolidWithAnswer on(int cells) const {
    SolidMesh mesh = brick({2 * cells, cells, cells}, {2, 1, 1});
    mesh.vertices = (map_ * mesh.vertices).eval();
    SolidProblem problem(mesh);
    problem.move(high_z, [&](const Vector3d&) { return shift_; });
    problem.load(high_x, on_x_);
    problem.load(high_y, on_y_);
    ContactLaw<3>& law = problem.law;
    if (slip_bound_ > 0) law.slip_bound = on_all_nodes(problem, slip_bound_);
    Matrix3Xd place = mesh.vertices(Eigen::all, problem.surface.vertex);
    place.row(2).setOnes();
    law.gap = (law_.row(0) * place).transpose();
    law.previous = law_.bottomRows<2>() * place;
    turn(problem);
    BoundarySprings<3> springs;
    if (!spring_.K.isZero(0)) {
      put_springs(
          mesh, low_x, [&](const Vector3d&) { return spring_; }, springs);
      assemble(springs, problem);
    }
    return SolidWithAnswer(problem, springs);
  }

  Quantity<3> quantity(const SolidWithAnswer& solved) const {
    const SolidMesh& mesh = solved.problem.mesh;
    if (kind_ == 0) return on_label<3>(mesh, high_x, w_);
    if (kind_ == 1) return on_label<3>(mesh, low_z, w_);
    return in_cells(mesh, solved.body.hooke, w_, M_, [&](const Vector3d& x) {
      return Vector3d(map_.inverse() * x).x() < 1;
    });
  }

 private:
  /// The normals over the surface, with the same gap.
  void turn(SolidProblem& problem) const {
    if (turn_.isZero(0)) return;
    ContactSurface& surface = problem.surface;
    for (int i = 0; i < surface.node_count(); ++i) {
      const auto x = problem.mesh.vertices.col(surface.vertex[i]);
      const Vector3d along(turn_.x() * x.x(), turn_.y() * x.y(), 0);
      const double length = std::hypot(1, along.norm());
      surface.normal.col(i) = (surface.normal.col(i) + along) / length;
      problem.law.gap[i] /= length;
      problem.law.previous.col(i).setZero();
    }
  }

  Matrix3d map_;
  Vector3d shift_, on_x_, on_y_;
  Matrix3d law_;  ///< gap and load step before by 1, x and y
  double slip_bound_;
  Vector2d turn_;  ///< of the normals [1/mm]
  SolidSpring spring_;
  int kind_;
  Vector3d w_;
  VectorOf<6> M_;
};

RC_GTEST_PROP(BoundsOfSolids, of_nested_meshes_meet, (Random random)) {
  const RandomProblem problem(random);
  const SolidWithAnswer coarse = problem.on(1), fine = problem.on(2);
  require_that_they_narrow(coarse.bounds(problem.quantity(coarse)),
                           fine.bounds(problem.quantity(fine)));
}

std::string refused(const SolidProblem& problem) {
  const SolidWithAnswer solved(problem);
  return refusal([&] {
    solved.bounds(on_label<3>(problem.mesh, high_x, {1, 0, 0}));
  });
}

TEST(BoundsOfSolids, are_refused_with_coulombs_law) {
  EXPECT_NE(refused(block_problem(brick({4, 2, 2}, block_size),
                                  BlockCase::press, 0.5))
                .find("Tresca's law alone"),
            std::string::npos);
}

}  // namespace
}  // namespace ffcontact
