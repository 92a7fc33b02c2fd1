// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/cases.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The rectangle bent so that its bottom is a polygon on a circle of radius 20 that
/// touches y = 0 in the middle.
Mesh bent(int nx, int ny) {
  Mesh mesh = rectangle(nx, ny, 6, 4);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const double x = mesh.vertices(0, v) - 3, y = mesh.vertices(1, v);
    mesh.vertices(1, v) = y + (1 - y / 4) * (20 - std::sqrt(400 - x * x));
  }
  return mesh;
}

Problem on_a_plane(Multiplier multiplier, const ContactLine& line,
                   const Mesh& mesh) {
  Problem problem = body(mesh, material(1000, 0.3));
  problem.line = line;
  clamp(problem, top, [](const Vector2d&) { return Vector2d(0.1, -0.1); });
  set_friction(problem, 0.2);
  problem.law.multiplier = multiplier;
  problem.law.gap.resize(line.node_count());
  for (int i = 0; i < line.node_count(); ++i)
    problem.law.gap[i] = mesh.vertices(1, line.vertex[i]);
  return problem;
}

ContactLine downwards(const Mesh& mesh) {
  const Edges edges = edges_of(mesh);
  const ContactLine line = smooth_contact_line(mesh, edges, {bottom});
  return along_directions(mesh, edges, line,
                          Vector2d(0, -2).replicate(1, line.node_count()));
}

TEST(SmoothContactLine, has_one_node_a_vertex_and_mean_normals) {
  const Mesh mesh = bent(6, 2);
  const Edges edges = edges_of(mesh);
  EXPECT_EQ(contact_line(mesh, edges, {bottom}).node_count(), 12);
  const ContactLine line = smooth_contact_line(mesh, edges, {bottom});
  EXPECT_EQ(line.node_count(), 7);
  EXPECT_LT((line.normal.col(3) - Vector2d(0, -1)).norm(), 1e-14);
  EXPECT_LT(line.normal(0, 0), line.normal(0, 1));
}

TEST(SmoothContactLine, of_a_closed_loop_shares_its_first_node) {
  const Mesh mesh = rectangle(2, 2, 1, 1);
  EXPECT_EQ(
      smooth_contact_line(mesh, edges_of(mesh), {bottom, right, top, left})
          .node_count(),
      8);
}

TEST(AlongDirections, on_a_straight_line_the_answer_is_the_same_to_the_bit) {
  Problem problem = example_1(Multiplier::pressure, 4);
  const ContactSolution<2> by_edges = solved(problem);
  problem.line = downwards(problem.mesh);
  EXPECT_EQ(solved(problem).displacement, by_edges.displacement);
}

class GivenDirections : public testing::TestWithParam<Multiplier> {};
INSTANTIATE_TEST_SUITE_P(Multipliers, GivenDirections,
                         testing::Values(Multiplier::force,
                                         Multiplier::pressure));

TEST_P(GivenDirections,
       a_bent_block_on_a_plane_slides_where_its_own_normals_lock_it) {
  const Mesh mesh = bent(12, 4);
  const Problem problem = on_a_plane(GetParam(), downwards(mesh), mesh);
  const ContactSolution<2> solution = solved(problem);
  EXPECT_TRUE(solution.accepted({})) << in_words(solution.status);
  const auto sliding = std::count(solution.state.begin(), solution.state.end(),
                                  ContactState::slip_forward);
  EXPECT_GT(sliding, 2);
  EXPECT_GT(std::count(solution.state.begin(), solution.state.end(),
                       ContactState::open),
            0);
}

/// With directions that turn from node to node forces are exact loads of the vector
/// pressure: turning the frames of both nodes of a body that sticks everywhere changes
/// nothing.
TEST_P(GivenDirections, turning_the_frames_does_not_change_a_body_that_sticks) {
  const Mesh mesh = bent(8, 3);
  const Edges edges = edges_of(mesh);
  Problem problem =
      on_a_plane(GetParam(), smooth_contact_line(mesh, edges, {bottom}), mesh);
  problem.law.gap.resize(0);
  clamp(problem, top, [](const Vector2d&) { return Vector2d(0, -0.1); });
  set_friction(problem, 100);
  const ContactSolution<2> by_normals = solved(problem);
  problem.line = downwards(mesh);
  const ContactSolution<2> by_one_direction = solved(problem);
  ASSERT_EQ(std::count(by_normals.state.begin(), by_normals.state.end(),
                       ContactState::stick),
            9);
  ASSERT_EQ(std::count(by_one_direction.state.begin(),
                       by_one_direction.state.end(), ContactState::stick),
            9);
  EXPECT_LT(relative_difference(by_normals.displacement,
                                by_one_direction.displacement),
            1e-12);
  const ContactLine normals = smooth_contact_line(mesh, edges, {bottom});
  for (int i = 0; i < 9; ++i) {
    const Vector2d a = by_normals.pressure(0, i) * normals.normal.col(i) +
                       by_normals.pressure(1, i) * normals.tangent(i);
    const Vector2d b(by_one_direction.pressure(1, i),
                     -by_one_direction.pressure(0, i));
    EXPECT_LT((a - b).norm(),
              1e-9 * by_one_direction.pressure.cwiseAbs().maxCoeff());
  }
}

TEST(AlongDirections, refuses_directions_into_the_body_or_of_another_line) {
  const Mesh mesh = rectangle(2, 2, 1, 1);
  const Edges edges = edges_of(mesh);
  const ContactLine line = smooth_contact_line(mesh, edges, {bottom});
  const auto refusal_of = [&](const Matrix2Xd& direction) {
    return refusal([&] { along_directions(mesh, edges, line, direction); });
  };
  EXPECT_TRUE(says(refusal_of(Vector2d(1, 0).replicate(1, 3)),
                   "does not point out of the body"));
  EXPECT_TRUE(says(refusal_of(Vector2d(0, 0).replicate(1, 3)),
                   "at vertex 0 (0, 0) does not point"));
  EXPECT_TRUE(says(refusal_of(Vector2d(0, -1).replicate(1, 2)),
                   "contact directions has 2 values where 3 are needed"));
}

}  // namespace
}  // namespace ffcontact
