// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/joined_lines.hpp"

#include <gtest/gtest.h>

#include "support/facing.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(JoinedLines, are_the_lines_one_after_the_other, (Random random)) {
  const Facing two = random_rows(random);
  const ContactLine alone =
      contact_line(two.joined.mesh, two.edges, {two.joined.label(0, top)});
  const ContactLine both = joined_lines({alone, two.line});
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

}  // namespace
}  // namespace ffcontact
