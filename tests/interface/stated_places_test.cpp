// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/stated_places.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <set>

#include "ffcontact/base/plane.hpp"
#include "ffcontact/interface/curve_directions.hpp"
#include "ffcontact/linear/norms.hpp"
#include "support/arcs.hpp"
#include "support/facing.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// An arc over a flat body, stated as contact() does, with the lines of both sides.
struct ArcOnFlat {
  JoinedMesh joined;
  Edges edges;
  ContactLine stated, own;
  std::optional<ContactLine> other;

  ArcOnFlat(const std::vector<double>& angles, int cells)
      : joined(joined_mesh<2>(
            {arc_body(angles, 10),
             shifted(rectangle(cells, 2, 60, 5), {-30.0, -18.0})})),
        edges(edges_of(joined.mesh)) {
    const std::vector<int> arc{joined.label(0, bottom)},
        flat{joined.label(1, top)};
    stated = contact_line(joined.mesh, edges, arc,
                          BoundaryCurves(joined.mesh, edges));
    const VectorXd gap = facing_traces(joined.mesh, edges, stated, flat).gap;
    stated = with_one_direction_a_curve(joined.mesh, stated, gap);
    // where directions turn places of a piece do not face each other to the last digit
    if (turns(stated)) stated = contact_line(joined.mesh, edges, arc);
    own = facing_line(joined.mesh, edges, stated,
                      facing_traces(joined.mesh, edges, stated, flat));
    other = exchanged_line(joined.mesh, edges, own, flat);
  }
  Vector2d point(const EdgePlace& at) const {
    return between(
        Vector2d(joined.mesh.vertices.col(edges.vertices(0, at.edge))),
        Vector2d(joined.mesh.vertices.col(edges.vertices(1, at.edge))),
        at.place);
  }
  /// How far places are beside what points of a line face along n, or infinite where one
  /// is not on the stated line at all [mm].
  double beside(const ContactLine& line, bool on_opposite) const {
    const std::set<int> known(stated.edge.begin(), stated.edge.end());
    const StatedPlaces places = stated_places(line, on_opposite);
    double most = 0;
    for (int e = 0; e < line.edge_count(); ++e)
      for (int k = 0; k < samples_of_an_edge; ++k) {
        if (!known.count(places[e][k].edge)) return infinity;
        const double x = between(line.place(0, e), line.place(1, e),
                                 k / (samples_of_an_edge - 1.0));
        const Vector2d r = point(places[e][k]) - point({line.edge[e], x});
        most = std::max(most, std::abs(cross(r, line.edge_normal(e))));
      }
    return most;
  }
};

RC_GTEST_PROP(StatedPlaces, of_arcs_are_on_the_stated_line, ()) {
  const double half = *rc::gen::inRange(5, 179) * M_PI / 180,
               middle = *rc::gen::inRange(-9, 10) * half / 10;
  const int least = 1 + static_cast<int>(4 * half / M_PI),
            n = least + *rc::gen::inRange(0, 130),
            cells = *rc::gen::inRange(1, 110);
  const ArcOnFlat two(even_angles(middle - half, middle + half, n), cells);
  RC_ASSERT(two.beside(two.own, false) < 1e-12);
  const StatedAbscissae at = stated_abscissae(two.edges, two.stated, two.own,
                                              stated_places(two.own, false));
  RC_ASSERT(at.node.minCoeff() >= 0);
  if (!two.other) return;
  RC_ASSERT(two.beside(*two.other, true) < 1e-2);
  const StatedAbscissae of_other = stated_abscissae(
      two.edges, two.stated, *two.other, stated_places(*two.other, true));
  RC_ASSERT(of_other.node.minCoeff() >= 0);
  RC_ASSERT(of_other.node.maxCoeff() <= two.stated.abscissa.maxCoeff() + 1e-12);
}

TEST(StatedPlaces, beyond_a_piece_by_rounding_are_those_of_its_end) {
  ArcOnFlat two(even_angles(-1.3, 1.3, 40), 7);
  ASSERT_TRUE(two.other);
  for (FacingPiece& piece : two.other->pieces) {
    piece.begin += 1e-13;
    piece.end -= 1e-13;
  }
  EXPECT_LT(two.beside(*two.other, true), 1e-2);
}

TEST(StatedPlaces, of_half_a_roller_on_a_plate_are_on_it) {
  for (const double half : {75.0, 85.0, 90.0})
    for (const int n : {40, 80, 120, 160}) {
      const double a = half * M_PI / 180;
      const ArcOnFlat two(even_angles(-a, a, n), 100);
      ASSERT_TRUE(two.other);
      EXPECT_LT(two.beside(*two.other, true), 1e-2) << half << " " << n;
    }
}

}  // namespace
}  // namespace ffcontact
