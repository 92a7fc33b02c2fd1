// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/common_refinement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/bodies.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/turning.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Two bodies in contact and their refinement.
struct Refined {
  Bodies two;
  CommonRefinement fine;

  explicit Refined(const std::vector<Mesh>& meshes)
      : two(bodies(meshes, {material(1, 0.3), material(1, 0.3)},
                   {{0, bottom, 1, top}})),
        fine(common_refinement(two.problem.mesh, two.problem.edges,
                               two.problem.line)) {}
  const Mesh& old() const { return two.problem.mesh; }
};

Refined refined_rows(std::mt19937& random) {
  const int upper = 1 + static_cast<int>(random() % 6),
            lower = 1 + static_cast<int>(random() % 6);
  const Mesh above = shifted(with_random_rows(upper, 2, 6, 2, random), {0, 3});
  return Refined(
      {renumbered(above, random).mesh,
       renumbered(with_random_rows(lower, 2, 6, 3, random), random).mesh});
}

RC_GTEST_PROP(CommonRefinement, cuts_triangles_into_parts_of_the_same_area,
              (Random random)) {
  const Refined refined = refined_rows(random);
  require_valid(refined.fine.mesh);
  VectorXd area = VectorXd::Zero(refined.old().cell_count());
  for (int t = 0; t < refined.fine.mesh.cell_count(); ++t)
    area[refined.fine.parent[t]] += signed_area(refined.fine.mesh, t);
  for (int t = 0; t < area.size(); ++t) {
    RC_ASSERT(std::abs(area[t] - signed_area(refined.old(), t)) < 1e-13);
    RC_ASSERT(refined.fine.parent[t] == t);
  }
}

RC_GTEST_PROP(CommonRefinement, has_traces_that_match_point_by_point,
              (Random random)) {
  const CommonRefinement fine = refined_rows(random).fine;
  const ContactLine& line = fine.line;
  RC_ASSERT(line.matches() &&
            static_cast<int>(line.pieces.size()) == line.edge_count());
  for (int e = 0; e < line.edge_count(); ++e) {
    const auto ends = fine.edges.vertices.col(line.edge[e]),
               facing = fine.edges.vertices.col(line.opposite_edge[e]);
    for (int end = 0; end < 2; ++end) {
      RC_ASSERT(ends[end] == line.vertex[line.edge_node(end, e)]);
      RC_ASSERT((fine.mesh.vertices.col(ends[end]) -
                 fine.mesh.vertices.col(facing[1 - end]))
                    .norm() < 3e-3);
      RC_ASSERT(line.opposite.coeff(line.edge_node(end, e), facing[1 - end]) ==
                1);
    }
    RC_ASSERT(
        std::abs(line.length[e] -
                 edge_vector(fine.mesh, fine.edges, line.edge[e]).norm()) <
        1e-13);
  }
}

/// A body on two others that touch each other at x = 2, which is a vertex of it or not.
TEST(CommonRefinement, has_two_nodes_in_front_of_a_joint) {
  for (int cells : {4, 5})
    for (double joint : {0.0, M_PI * 1e-5}) {
      Mesh lower = joined(rectangle(3, 2, 2, 2),
                          shifted(rectangle(4, 2, 2, 2), {2 + joint, 0}));
      lower.boundary_label.tail(12).array() -= 10;
      const CommonRefinement fine =
          Refined({shifted(rectangle(cells, 1, 3, 1), {0.5, 2}), lower}).fine;
      int at_joint = 0;
      for (int i = 0; i < fine.line.node_count(); ++i)
        if (std::abs(fine.mesh.vertices(0, fine.line.vertex[i]) - 2) < 1e-4)
          ++at_joint;
      EXPECT_EQ(at_joint, 2);
      for (int e = 0; e < fine.line.edge_count(); ++e)
        for (int end = 0; end < 2; ++end) {
          const int node = fine.line.edge_node(end, e),
                    facing = fine.edges.vertices(1 - end,
                                                 fine.line.opposite_edge[e]);
          EXPECT_EQ(fine.line.opposite.coeff(node, facing), 1);
          EXPECT_EQ(fine.line.opposite.row(node).nonZeros(), 1);
          EXPECT_NEAR(fine.node_weights.row(node).sum(), 1, 1e-12);
        }
    }
}

RC_GTEST_PROP(CommonRefinement, weights_say_where_vertices_and_nodes_are,
              (Random random)) {
  const Refined refined = refined_rows(random);
  const CommonRefinement& fine = refined.fine;
  const ContactLine& old_line = refined.two.problem.line;
  const Matrix2Xd x =
      (fine.vertex_weights * refined.old().vertices.transpose()).transpose();
  RC_ASSERT((x - fine.mesh.vertices).cwiseAbs().maxCoeff() < 1e-14);
  RC_ASSERT(fine.mesh.vertices.leftCols(refined.old().vertices.cols()) ==
            refined.old().vertices);
  RC_ASSERT((fine.node_weights * old_line.abscissa - fine.line.abscissa)
                .cwiseAbs()
                .maxCoeff() < 1e-14);
  RC_ASSERT(fine.line.vertex.head(old_line.node_count()) == old_line.vertex);
  for (int i = 0; i < fine.line.node_count(); ++i) {
    RC_ASSERT(std::abs(fine.mesh.vertices(0, fine.line.vertex[i]) -
                       fine.line.abscissa[i]) < 1e-13);
    RC_ASSERT(fine.line.normal.col(i) == Vector2d(0, -1));
  }
}

RC_GTEST_PROP(CommonRefinement, has_directions_between_those_of_the_old_nodes,
              (Random random)) {
  Bodies two = refined_rows(random).two;
  ContactLine& old = two.problem.line;
  old = turned_at_random(old, 0.01, random);
  const CommonRefinement fine =
      common_refinement(two.problem.mesh, two.problem.edges, old);
  for (int i = 0; i < fine.line.node_count(); ++i) {
    Vector2d n = Vector2d::Zero();
    for (int j = 0; j < old.node_count(); ++j)
      n += fine.node_weights.coeff(i, j) * old.normal.col(j);
    RC_ASSERT((fine.line.normal.col(i) - n.normalized()).norm() < 1e-15);
  }
}

RC_GTEST_PROP(CommonRefinement, edges_know_the_edges_they_are_parts_of,
              (Random random)) {
  const Refined refined = refined_rows(random);
  const CommonRefinement& fine = refined.fine;
  const Edges& old_edges = refined.two.problem.edges;
  VectorXd length = VectorXd::Zero(old_edges.count());
  for (int e = 0; e < fine.edges.count(); ++e) {
    const int old = fine.parent_edge[e];
    if (old < 0) {
      RC_ASSERT(!fine.edges.on_boundary(e));
      continue;
    }
    length[old] += edge_vector(fine.mesh, fine.edges, e).norm();
    for (int v : fine.edges.vertices.col(e)) {
      const double s = fine.place(old_edges, v, old);
      const Vector2d at =
          refined.old().vertices.col(old_edges.vertices(0, old)) +
          s * edge_vector(refined.old(), old_edges, old);
      RC_ASSERT((at - fine.mesh.vertices.col(v)).norm() < 1e-13);
    }
  }
  for (int e = 0; e < old_edges.count(); ++e)
    RC_ASSERT(
        std::abs(length[e] - edge_vector(refined.old(), old_edges, e).norm()) <
        1e-13);
  for (int b = 0; b < fine.mesh.boundary.cols(); ++b) {
    RC_ASSERT(fine.mesh.boundary_label[b] ==
              refined.old().boundary_label[fine.parent_boundary[b]]);
    if (b > 0)
      RC_ASSERT(fine.parent_boundary[b] >= fine.parent_boundary[b - 1]);
  }
}

TEST(CommonRefinement, leaves_a_line_that_faces_no_body_as_it_is) {
  Refined refined(
      {shifted(rectangle(3, 1, 6, 2), {0, 3}), rectangle(2, 1, 6, 3)});
  Problem& problem = refined.two.problem;
  const ContactLine free =
      contact_line(problem.mesh, problem.edges, {refined.two.label(1, bottom)});
  const ContactLine both = joined_contact<2>({free, problem.line});
  const CommonRefinement fine =
      common_refinement(problem.mesh, problem.edges, both);
  EXPECT_EQ(fine.line.edge_count(), 2 + refined.fine.line.edge_count());
  for (int e = 0; e < 2; ++e) {
    EXPECT_EQ(fine.line.opposite_edge[e], -1);
    EXPECT_EQ(fine.edges.vertices.col(fine.line.edge[e]),
              problem.edges.vertices.col(free.edge[e]));
    EXPECT_EQ(fine.line.length[e], 3);
  }
}

TEST(CommonRefinement, lets_vertices_meet_that_all_but_do) {
  Mesh lower = rectangle(3, 1, 6, 3);
  for (int v = 0; v < lower.vertex_count(); ++v)
    if (lower.vertices(1, v) == 3 && lower.vertices(0, v) == 2)
      lower.vertices(0, v) += 1e-5;
  const CommonRefinement fine =
      Refined({shifted(rectangle(3, 1, 6, 2), {0, 3}), lower}).fine;
  EXPECT_FALSE(fine.exact);
  EXPECT_EQ(fine.line.edge_count(), 3);
  EXPECT_EQ(fine.mesh.vertex_count(), 16);
  EXPECT_TRUE(
      Refined({shifted(rectangle(3, 1, 6, 2), {0, 3}), rectangle(4, 1, 6, 3)})
          .fine.exact);
}

/// The sliver between vertices that all but meet is none beside the short edge that
/// stands next to it.
TEST(CommonRefinement, lets_vertices_meet_beside_a_short_edge) {
  for (const bool mirrored : {false, true}) {
    const auto along = [&](double x) { return mirrored ? 6 - x : x; };
    Mesh upper = shifted(rectangle(3, 1, 6, 2), {0, 3}),
         lower = rectangle(2, 1, 6, 3);
    for (double& x : upper.vertices.row(0))
      x = x == along(2) ? along(2.9) : x == along(4) ? along(3) : x;
    for (double& x : lower.vertices.row(0)) x = x == 3 ? along(3 + 1.5e-4) : x;
    const CommonRefinement fine = Refined({upper, lower}).fine;
    EXPECT_EQ(fine.line.edge_count(), 3);
    EXPECT_EQ(fine.mesh.vertex_count(), 8 + 6 + 1);
  }
}

TEST(CommonRefinement, refuses_rays_that_cross) {
  Mesh hollow = shifted(rectangle(2, 1, 2, 1), {0, 1});
  for (int v = 0; v < hollow.vertex_count(); ++v)
    if (hollow.vertices(0, v) == 1 && hollow.vertices(1, v) == 1)
      hollow.vertices(1, v) = 1.3;
  const std::string sentence = refusal([&] {
    Refined({hollow, shifted(rectangle(8, 1, 6, 1), {-2, -1})});
  });
  EXPECT_TRUE(
      says(sentence,
           "two contact edges face the same part of the opposite body near ("))
      << sentence;
  EXPECT_TRUE(says(sentence, "normal=[nx, ny]"));
}

}  // namespace
}  // namespace ffcontact
