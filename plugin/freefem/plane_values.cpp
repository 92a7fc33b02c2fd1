// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/packed.hpp"
#include "ffcontact/interface/line_ends.hpp"
//
#include "freefem/body_values.hpp"
#include "freefem/plane_values.hpp"

namespace ffcontact::plugin {

namespace {

VectorXd values_of(Stack stack, Expression expression, const BodyPart& part,
                   const std::vector<BoundaryPlace<2>>& places) {
  return part.elsewhere ? part.elsewhere->values(expression, part.body, places)
                        : at_boundary(stack, expression, part, places);
}

/// A place on an edge of the joined mesh as one of the body that the edge is of.
BoundaryPlace<2> on_boundary(const BodyPart& part, const Edges& edges,
                             const EdgePlace& at) {
  const int column = edges.boundary_index[at.edge];
  Vector2d weights(1 - at.place, at.place);
  if (part.mesh.boundary(0, column) != edges.vertices(0, at.edge))
    weights.reverseInPlace();
  return {column - part.first_boundary, weights};
}

}  // namespace

VectorXd at_nodes(Stack stack, Expression expression, const BodyPart& part,
                  const Edges& edges, const ContactLine& line,
                  const StatedPlaces& places, double otherwise) {
  VectorXd values = VectorXd::Constant(line.node_count(), otherwise);
  if (!expression) return values;
  std::vector<int> node;
  std::vector<BoundaryPlace<2>> at;
  for (
      int e = line.edge_count() - 1; e >= 0;
      --e)  // backwards: a node between two edges ends with the value of the first
    for (int end = 1; end >= 0; --end) {
      if (!ends_at_its_node(line, end, e)) continue;
      node.push_back(line.edge_node(end, e));
      at.push_back(on_boundary(
          part, edges, end == 0 ? places[e].front() : places[e].back()));
    }
  const VectorXd found = values_of(stack, expression, part, at);
  for (int i = 0; i < count_of(node); ++i) values[node[i]] = found[i];
  return values;
}

MatrixXd along_edges(Stack stack, Expression expression, const BodyPart& part,
                     const Edges& edges, const StatedPlaces& places) {
  std::vector<BoundaryPlace<2>> at;
  for (const std::vector<EdgePlace>& of_edge : places)
    for (const EdgePlace& place : of_edge)
      at.push_back(on_boundary(part, edges, place));
  return values_of(stack, expression, part, at)
      .reshaped(samples_of_an_edge, count_of(places));
}

}  // namespace ffcontact::plugin
