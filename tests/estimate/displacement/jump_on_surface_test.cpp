// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/displacement/jump_on_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/estimate/displacement/bonded_displacement.hpp"
#include "support/bonded_solids.hpp"
#include "support/solid_estimates.hpp"
#include "support/uniform.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Displacements of the lower body at random, which the upper one follows.
class Followed {
 public:
  explicit Followed(Random random)
      : two_(bonded_bricks({5, 4, 1}, {3, 4, 1})),
        topology_(topology_of(two_.problem.mesh)),
        u_(VectorXd::Zero(3 * topology_.mesh.vertex_count())) {
    const Uniform drawn{-1, 1};
    for (double& component :
         u_.tail(u_.size() - 3 * two_.joined.first_vertex[1]))
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
  EXPECT_GT(jump.norm, 1);
  EXPECT_NEAR(jump.norm, std::sqrt(sum), 0.02 * jump.norm);
}

/// The upper body on a lower one that goes on beyond it and moves at random.
struct OnLarger {
  SolidStack two =
      bonded_stack({brick({2, 2, 1}, {3, 2, 1}),
                    brick_at({5, 4, 1}, {5, 4, 1}, {-1.3, -1.2, -1})});
  Topology<3> topology = topology_of(two.problem.mesh);
  SolvedBody<3> body = solved_solid(two.problem, {});

  explicit OnLarger(Random random) {
    const Uniform drawn{-1, 1};
    body.displacement = VectorXd::Zero(3 * topology.mesh.vertex_count());
    for (double& u : body.displacement.tail(body.displacement.size() -
                                            3 * two.joined.first_vertex[1]))
      u = drawn(random);
  }
  /// What is left of the jump of a u_hat for these supports, with others.
  double left(const Flags& of_u_hat, const Flags& prescribed) const {
    ElasticSystem system = two.problem.system();
    system.prescribed = of_u_hat;
    const VectorXd u =
        bonded_displacement({topology, two.problem.surface, system, body});
    return bonded_jump(topology, two.problem.surface, body.hooke, prescribed, u)
        .left.depth;
  }
};

/// u_x of a side of the upper body.
Flags held_along_x(const OnLarger& on, int side) {
  Flags prescribed(on.body.displacement.size(), 0);
  for (const int v : vertices_on(on.topology.mesh, on.two.label(0, side)))
    prescribed[3 * v] = 1;
  return prescribed;
}

TEST(BondedJump, is_left_where_supports_hold_what_should_follow) {
  const OnLarger on(Random(5));
  const Flags none(on.body.displacement.size(), 0),
      low = held_along_x(on, low_x), high = held_along_x(on, high_z);
  EXPECT_LT(on.left(none, none), 1e-14);
  EXPECT_LT(on.left(none, high), 1e-14);  // which has no edge in common
  EXPECT_GT(on.left(low, none), 0.1);     // at vertices
  EXPECT_GT(on.left(none, low), 0.1);     // between them
}

/// Under a roof, whose faces look into different directions, between which the lower body
/// bends.
TEST(BondedJump, is_left_where_faces_do_not_agree_along_their_edge) {
  for (const double slope : {0.0, 0.2}) {
    SolidMesh roof = brick({2, 2, 1}, {3, 2, 1});
    for (auto x : roof.vertices.colwise())
      x.z() += slope * (1.5 - std::abs(x.x() - 1.5));
    const SolidStack two =
        bonded_stack({roof, brick_at({7, 5, 1}, {5, 4, 1}, {-1.3, -1.2, -1})});
    const Topology<3> topology = topology_of(two.problem.mesh);
    SolvedBody<3> body = solved_solid(two.problem, {});
    body.displacement =
        nodal_values(topology.mesh, [&](const Vector3d& x) -> Vector3d {
          return x.y() * x.y() * Vector3d(0, 0, x.z() > 0 ? 0 : x.x() * x.x());
        });
    const ElasticSystem system = two.problem.system();
    const BondedJump jump = bonded_jump(
        topology, two.problem.surface, body.hooke, system.prescribed,
        bonded_displacement({topology, two.problem.surface, system, body}));
    EXPECT_EQ(jump.left.depth > 1e-12, slope > 0) << jump.left.depth;
  }
}

/// A body that follows one below, and another one beside it that follows it: where it moves
/// between its vertices the latter cannot know.
double left_of_a_row(const SolidField& below) {
  const JoinedSolids joined =
      joined_mesh<3>({brick({2, 2, 1}, {3, 2, 1}),
                      brick_at({5, 4, 1}, {5, 4, 1}, {-1.3, -1.2, -1}),
                      brick_at({1, 5, 4}, {1, 2, 1}, {3, 0, 0})});
  const Topology<3> topology = topology_of(joined.mesh);
  const auto pair = [&](int body, int side, int opposite, int other) {
    return facing(joined.mesh, topology.facets, joined.label(body, side),
                  joined.label(opposite, other))
        .surface;
  };
  const ContactSurface surface =
      joined_contact<3>({pair(0, low_z, 1, high_z), pair(2, low_x, 0, high_x)});
  SolidProblem problem(joined.mesh, 0, {joined.label(0, low_z)});
  SolvedBody<3> body = solved_solid(problem, {});
  body.displacement = nodal_values(joined.mesh, below);
  const ElasticSystem system = problem.system();
  return bonded_jump(topology, surface, body.hooke, system.prescribed,
                     bonded_displacement({topology, surface, system, body}))
      .left.depth;
}

TEST(BondedJump, is_left_where_what_is_followed_follows) {
  EXPECT_LT(left_of_a_row(linear_solid_field), 1e-14);
  EXPECT_GT(left_of_a_row([](const Vector3d& x) {
              return Vector3d(0, 0, x.z() <= 0 ? x.y() * x.y() : 0);
            }),
            0.01);
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
