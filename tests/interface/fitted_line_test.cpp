// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/fitted_line.hpp"

#include <gtest/gtest.h>

#include "ffcontact/interface/pairing/facing_traces.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"
#include "support/arcs.hpp"

namespace ffcontact {
namespace {

using namespace test;

std::optional<CurvedEdge> fitted(const Mesh& first, const Mesh& second,
                                 int opposite) {
  const JoinedMesh joined = joined_mesh<2>({first, second});
  const Edges edges = edges_of(joined.mesh);
  const ContactLine line = curved_contact_line(joined.mesh, edges, {bottom});
  return edge_of_fitted_line(
      joined.mesh, edges, line,
      facing_traces(joined.mesh, edges, line, {joined.label(1, opposite)})
          .pieces);
}

Mesh bore(double radius, int edges) {
  return hollow_body(even_angles(-0.7, 0.7, edges), radius);
}

TEST(FittedLine, is_a_pin_in_its_bore_and_no_pin_on_a_plane) {
  const Mesh pin = arc_body(even_angles(-0.5, 0.5, 10), 10);
  const auto found = fitted(pin, bore(10.05, 9), bottom);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->sagitta, 10 * 0.1 * 0.1 / 8, 1e-4);
  Mesh plane = rectangle(9, 1, 20, 1);
  plane.vertices.colwise() -= Vector2d(10, 11.05);
  EXPECT_FALSE(fitted(pin, plane, top));
  // a groove of 2.5 times its radius
  Mesh groove = bore(25, 9);
  groove.vertices.row(1).array() += 14.95;
  EXPECT_FALSE(fitted(pin, groove, bottom));
}

TEST(FittedLine, is_none_where_edges_face_each_other_one_by_one) {
  const Mesh pin = arc_body(even_angles(-0.5, 0.5, 10), 10);
  const Mesh same = hollow_body(even_angles(-0.5, 0.5, 10), 10);
  EXPECT_FALSE(fitted(pin, same, bottom));
}

}  // namespace
}  // namespace ffcontact
