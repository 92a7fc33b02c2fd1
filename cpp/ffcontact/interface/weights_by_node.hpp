// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <set>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/packed.hpp"

namespace ffcontact {

/// Weights of vertices, one row per contact node.
using WeightsByNode = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Calls visit(vertex, weight) for the entries of `opposite` of a contact line or surface
/// at a node.
template <class Nodes, class Visit>
void visit_opposite(const Nodes& nodes, int node, Visit&& visit) {
  if (!nodes.against_a_body()) return;
  for (WeightsByNode::InnerIterator part(nodes.opposite, node); part; ++part)
    visit(static_cast<int>(part.col()), part.value());
}

/// Some of the rows, if there are any.
inline WeightsByNode rows_of(const WeightsByNode& weights,
                             const std::vector<int>& rows) {
  if (weights.rows() == 0) return weights;
  Triplets entries;
  for (int k = 0; k < count_of(rows); ++k)
    for (WeightsByNode::InnerIterator part(weights, rows[k]); part; ++part)
      entries.emplace_back(k, static_cast<int>(part.col()), part.value());
  return packed<WeightsByNode>(count_of(rows), weights.cols(), entries);
}

/// The vertices in `opposite`, each once: those of opposite bodies, and own ones that a
/// node lies between.
template <class Nodes>
std::vector<int> opposite_vertices(const Nodes& nodes) {
  std::set<int> vertices;
  for (int i = 0; i < nodes.node_count(); ++i)
    visit_opposite(nodes, i,
                   [&](int vertex, double) { vertices.insert(vertex); });
  return {vertices.begin(), vertices.end()};
}

/// The vertices of the nodes, and those in `opposite`; some may come twice.
template <class Nodes>
std::vector<int> contact_vertices(const Nodes& nodes) {
  std::vector<int> vertices(nodes.vertex.begin(), nodes.vertex.end());
  const std::vector<int> opposite = opposite_vertices(nodes);
  vertices.insert(vertices.end(), opposite.begin(), opposite.end());
  return vertices;
}

}  // namespace ffcontact
