// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/packed.hpp"
#include "ffcontact/interface/line_ends.hpp"
//
#include "freefem/body_values.hpp"
#include "freefem/plane_values.hpp"

namespace ffcontact::plugin {

namespace {

BoundaryPlace<2> on_boundary(const BodyPart<2>& part, const EdgePlace& at) {
  return on_boundary(part, at.edge, {1 - at.place, at.place});
}

}  // namespace

VectorXd at_nodes(Stack stack, Expression expression, const BodyPart<2>& part,
                  const ContactLine& line, const StatedPlaces& places,
                  double otherwise) {
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
      at.push_back(
          on_boundary(part, end == 0 ? places[e].front() : places[e].back()));
    }
  const VectorXd found = at_boundary(stack, expression, part, at);
  for (int i = 0; i < count_of(node); ++i) values[node[i]] = found[i];
  return values;
}

MatrixXd along_edges(Stack stack, Expression expression,
                     const BodyPart<2>& part, const StatedPlaces& places) {
  std::vector<BoundaryPlace<2>> at;
  for (const std::vector<EdgePlace>& of_edge : places)
    for (const EdgePlace& place : of_edge)
      at.push_back(on_boundary(part, place));
  return at_boundary(stack, expression, part, at)
      .reshaped(samples_of_an_edge, count_of(places));
}

}  // namespace ffcontact::plugin
