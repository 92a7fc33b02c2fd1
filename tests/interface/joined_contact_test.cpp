// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/joined_contact.hpp"

#include <gtest/gtest.h>

#include "support/facing.hpp"
#include "support/solid_stacks.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(JoinedContact, of_lines_is_these_lines_one_after_the_other,
              (Random random)) {
  const Facing two = random_rows(random);
  const ContactLine alone =
      contact_line(two.joined.mesh, two.edges, {two.joined.label(0, top)});
  const ContactLine both = joined_contact<2>({alone, two.line});
  const int p = alone.node_count(), m = alone.edge_count();
  RC_ASSERT(both.node_count() == p + two.line.node_count() &&
            both.edge_count() == m + two.line.edge_count());
  RC_ASSERT(both.vertex.tail(two.line.node_count()) == two.line.vertex);
  RC_ASSERT(both.normal.leftCols(p) == alone.normal &&
            both.normal.rightCols(two.line.node_count()) == two.line.normal);
  RC_ASSERT(both.edge_node.rightCols(two.line.edge_count()) ==
            (two.line.edge_node.array() + p).matrix());
  RC_ASSERT(both.edge.tail(two.line.edge_count()) == two.line.edge);
  RC_ASSERT(both.length.tail(two.line.edge_count()) == two.line.length);
  RC_ASSERT(both.abscissa.tail(two.line.node_count()) == two.line.abscissa);
  RC_ASSERT((both.opposite_edge.head(m).array() == -1).all());
  RC_ASSERT(both.opposite_edge.tail(two.line.edge_count()) ==
            two.line.opposite_edge);
  RC_ASSERT(both.pieces.size() == two.line.pieces.size());
  for (std::size_t k = 0; k < both.pieces.size(); ++k) {
    RC_ASSERT(both.pieces[k].contact_edge ==
              two.line.pieces[k].contact_edge + m);
    RC_ASSERT(both.pieces[k].opposite_edge == two.line.pieces[k].opposite_edge);
  }
  const MatrixXd opposite = both.opposite;
  RC_ASSERT(opposite.topRows(p).isZero(0) &&
            opposite.bottomRows(two.line.node_count()) ==
                MatrixXd(two.line.opposite));
}

TEST(JoinedContact, of_surfaces_is_these_surfaces_one_after_the_other) {
  SolidMesh lower = brick({3, 2, 1}, {3, 2, 1});
  lower.vertices.row(2).array() -= 1;
  const SolidStack stack({brick({2, 2, 1}, {3, 2, 1}), lower}, 0);
  const SolidProblem& problem = stack.problem;
  const ContactSurface alone = contact_surface(problem.mesh, problem.faces,
                                               {stack.label(0, high_z)}),
                       &other = problem.surface,
                       both = joined_contact<3>({alone, other});
  const int p = alone.node_count(), m = alone.face_count(),
            nodes = other.node_count(), faces = other.face_count();
  ASSERT_GT(p, 0);
  EXPECT_EQ(both.vertex.head(p), alone.vertex);
  EXPECT_EQ(both.vertex.tail(nodes), other.vertex);
  EXPECT_EQ(both.normal.rightCols(nodes), other.normal);
  EXPECT_EQ(both.area.tail(nodes), other.area);
  EXPECT_EQ(both.face.tail(faces), other.face);
  EXPECT_EQ(both.face_node.leftCols(m), alone.face_node);
  EXPECT_EQ(both.face_node.rightCols(faces),
            (other.face_node.array() < 0)
                .select(other.face_node, other.face_node.array() + p));
  MatrixXd mass = MatrixXd::Zero(p + nodes, p + nodes);
  mass.topLeftCorner(p, p) = alone.mass;
  mass.bottomRightCorner(nodes, nodes) = other.mass;
  EXPECT_EQ(MatrixXd(both.mass), mass);
  const MatrixXd opposite = both.opposite;
  EXPECT_TRUE(opposite.topRows(p).isZero(0));
  EXPECT_EQ(opposite.bottomRows(nodes), MatrixXd(other.opposite));
  ASSERT_EQ(both.polygons.size(), other.polygons.size());
  for (std::size_t k = 0; k < both.polygons.size(); ++k)
    EXPECT_EQ(both.polygons[k].contact_face,
              other.polygons[k].contact_face + m);
}

}  // namespace
}  // namespace ffcontact
