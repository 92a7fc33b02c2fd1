// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/condensed/vertex_motions.hpp"

#include <cmath>
#include <utility>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

namespace {

/// A free direction of a contact vertex is taken as tangential when its normal component
/// is below this.
constexpr double tangential = 1e-3;

VertexMotion motion_at_node(const ContactLine& line, int node,
                            const Flags& prescribed) {
  VertexMotion motion;
  motion.directions = free_axes<2>(line.vertex[node], prescribed);
  if (motion.directions.cols() == 2) {
    motion.rows = {2 * node, 2 * node + 1};
    motion.directions = line.frame(node);
  } else if (motion.directions.cols() == 1) {
    const double normal = line.normal.col(node).dot(motion.directions.col(0));
    motion.rows = {2 * node + (std::abs(normal) < tangential ? 1 : 0)};
  }
  return motion;
}

/// Numbers its components.
void add(int vertex, VertexMotion motion, VertexMotions& all) {
  motion.column = all.component_count;
  all.component_count += static_cast<int>(motion.directions.cols());
  all.rows.insert(all.rows.end(), motion.rows.begin(), motion.rows.end());
  all.of_vertex.emplace(vertex, std::move(motion));
}

const VertexMotion& motion_of(const VertexMotions& motions, int vertex) {
  return entry_of(motions.of_vertex, vertex, "motion of a vertex");
}

/// The part that a vertex has in the trace at a node.
void add_trace(const ContactLine& line, const Flags& held, int node,
               const VertexMotion& motion, double factor, Triplets& entries) {
  const Matrix2d frame = line.frame(node);
  for (Index k = 0; k < motion.directions.cols(); ++k)
    for (int c = 0; c < 2; ++c) {
      const double component = frame.col(c).dot(motion.directions.col(k));
      if (!held[2 * node + c])
        entries.emplace_back(2 * node + c, motion.column + k,
                             factor * component);
    }
}

}  // namespace

VertexMotions vertex_motions(const ContactLine& line, const Flags& prescribed) {
  VertexMotions motions;
  for (int i = 0; i < line.node_count(); ++i)
    if (!motions.of_vertex.count(line.vertex[i]))
      add(line.vertex[i], motion_at_node(line, i, prescribed), motions);
  for (const int v : opposite_vertices(line))
    if (!motions.of_vertex.count(v))
      add(v, {0, {}, free_axes<2>(v, prescribed)}, motions);
  return motions;
}

SparseMatrix trace_operator(const ContactLine& line, const Flags& held,
                            const VertexMotions& motions) {
  Triplets entries;
  for (int i = 0; i < line.node_count(); ++i) {
    const auto add_part = [&](int vertex, double factor) {
      const VertexMotion& motion = motion_of(motions, vertex);
      add_trace(line, held, i, motion, factor, entries);
    };
    add_part(line.vertex[i], 1);
    visit_opposite(
        line, i, [&](int vertex, double weight) { add_part(vertex, -weight); });
  }
  return packed(2 * line.node_count(), motions.component_count, entries);
}

SparseMatrix kept_operator(const VertexMotions& motions,
                           const std::vector<int>& kept) {
  Triplets entries;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const VertexMotion& motion = motion_of(motions, kept[k] / 2);
    for (Index j = 0; j < motion.directions.cols(); ++j)
      entries.emplace_back(static_cast<int>(k), motion.column + j,
                           motion.directions(kept[k] % 2, j));
  }
  return packed(count_of(kept), motions.component_count, entries);
}

}  // namespace ffcontact
