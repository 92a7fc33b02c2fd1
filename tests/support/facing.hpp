// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/bodies.hpp"
#include "support/random.hpp"

/// Two bodies, paired.
namespace ffcontact::test {

/// An upper body on a lower one, the upper one's lower side facing the other's upper
/// side.
struct Facing {
  JoinedMesh joined;
  Edges edges;
  ContactLine line;
  FacingTraces traces;

  explicit Facing(const Mesh& upper, const Mesh& lower, bool smooth = false)
      : joined(joined_mesh<2>({upper, lower})), edges(edges_of(joined.mesh)) {
    const std::vector<int> label{joined.label(0, bottom)};
    line = smooth ? smooth_contact_line(joined.mesh, edges, label)
                  : contact_line(joined.mesh, edges, label);
    traces = facing_traces(joined.mesh, edges, line, {joined.label(1, top)});
    line = facing_line(joined.mesh, edges, std::move(line), traces);
  }
  Vector2d on(int edge, double s) const {
    return joined.mesh.vertices.col(edges.vertices(0, edge)) +
           s * edge_vector(joined.mesh, edges, edge);
  }
  Vector2d direction(int e, double s) const {
    return (1 - s) * line.normal.col(line.edge_node(0, e)) +
           s * line.normal.col(line.edge_node(1, e));
  }
};

/// Lower sides from (1, 3) to (5, 3), on an upper side from (0, 3) to (6, 3).
inline Facing random_rows(std::mt19937& random) {
  const int upper = 1 + static_cast<int>(random() % 7),
            lower = 1 + static_cast<int>(random() % 7);
  return Facing(shifted(with_random_rows(upper, 2, 4, 2, random), {1, 3}),
                with_random_rows(lower, 2, 6, 3, random));
}

}  // namespace ffcontact::test
