// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/energy/short_edge_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ffcontact/base/unions.hpp"

namespace ffcontact {

namespace {

constexpr double least_strength = 2;

double cotangent(const Vector2d& a, const Vector2d& b) {
  return a.dot(b) / std::abs(a[0] * b[1] - a[1] * b[0]);
}

/// Of the angle at a corner.
double cotangent(const CellCorners<2>& corners, int k) {
  const Vector2d apex = corners.col(k);
  return cotangent(corners.col((k + 1) % 3) - apex,
                   corners.col((k + 2) % 3) - apex);
}

/// k of each edge.
VectorXd strengths(const FacetTopology<2>& topology) {
  VectorXd k = VectorXd::Zero(topology.facets.count());
  for (int t = 0; t < topology.mesh.cell_count(); ++t)
    for (int i = 0; i < 3; ++i)
      k[topology.facets.of_cell(i, t)] += cotangent(topology.corners(t), i) / 2;
  return k;
}

/// Vertices of a share all of whose cells are its own.
Flags vertices_inside(const FacetTopology<2>& topology,
                      const FacetShare& share) {
  Flags inside = share.ridge;
  for (int t = 0; t < topology.mesh.cell_count(); ++t)
    if (!share.cell[t])
      for (int f : topology.facets.of_cell.col(t))
        for (int v : topology.ridges.of_facet.col(f)) inside[v] = 0;
  return inside;
}

constexpr int none = -1;

/// Lines that grow together, edge by edge.
class GrowingLines {
 public:
  explicit GrowingLines(const FacetTopology<2>& topology)
      : topology_(topology),
        beside_(Matrix2Xi::Constant(2, topology.ridges.count(), none)),
        line_(topology.ridges.count()),
        size_(topology.ridges.count(), 1) {}

  /// Joins the lines of the ends of an edge where these end there, and no other vertices
  /// of the lines have cells in common.
  void join(int edge) {
    int a = topology_.ridges.of_facet(0, edge),
        b = topology_.ridges.of_facet(1, edge);
    if (in_one_line(a, b) || !is_end(a) || !is_end(b)) return;
    if (size(a) > size(b)) std::swap(a, b);
    if (!are_apart(a, b)) return;
    const int together = size(a) + size(b);
    link(a, b);
    link(b, a);
    line_.join(a, b);
    size(a) = together;
  }

  /// Those of the vertices of a share.
  RidgeLines lines(const FacetShare& share) const {
    RidgeLines lines;
    Flags listed(share.ridge.size(), 0);
    for (int v = 0; v < count_of(listed); ++v) {
      if (!share.ridge[v] || listed[v] || !is_end(v)) continue;
      all_of_line(v, [&](int member) {
        lines.ridge.push_back(member);
        listed[member] = 1;
        return true;
      });
      lines.end_line();
    }
    return lines;
  }

 private:
  int& size(int v) { return size_[line_.root(v)]; }
  bool in_one_line(int a, int b) { return line_.root(a) == line_.root(b); }
  bool is_end(int v) const { return beside_(1, v) == none; }
  void link(int v, int other) {
    beside_(beside_(0, v) == none ? 0 : 1, v) = other;
  }
  /// What comes after v in its line, or none.
  int after(int v, int before) const {
    return beside_(beside_(0, v) == before ? 1 : 0, v);
  }
  /// From an end to the other one, or to the first member for which it does not hold.
  template <class Holds>
  bool all_of_line(int v, const Holds& holds) const {
    for (int before = none; v != none;) {
      if (!holds(v)) return false;
      const int next = after(v, before);
      before = v;
      v = next;
    }
    return true;
  }
  /// But for a and b themselves, has no vertex of a's line a neighbour in that of b?
  bool are_apart(int a, int b) {
    return all_of_line(a, [&](int v) {
      bool apart = true;
      for (int edge : topology_.ridges.facets_of(v))
        for (int other : topology_.ridges.of_facet.col(edge))
          apart = apart && (!in_one_line(other, b) || (v == a && other == b));
      return apart;
    });
  }

  const FacetTopology<2> topology_;
  Matrix2Xi beside_;       ///< what comes before and after in the line
  Unions line_;            ///< of each vertex
  std::vector<int> size_;  ///< of each line, by its root
};

/// Edges that lines may go along, the strongest first.
std::vector<int> strong_edges(const FacetTopology<2>& topology,
                              const FacetShare& share) {
  const VectorXd k = strengths(topology);
  const Flags inside = vertices_inside(topology, share);
  std::vector<int> edges;
  for (int e = 0; e < topology.facets.count(); ++e) {
    const auto ends = topology.ridges.of_facet.col(e);
    if (k[e] >= least_strength && inside[ends[0]] && inside[ends[1]])
      edges.push_back(e);
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [&](int e, int f) { return k[e] > k[f]; });
  return edges;
}

}  // namespace

RidgeLines short_edge_lines(const FacetTopology<2>& topology,
                            const FacetShare& share) {
  const std::vector<int> edges = strong_edges(topology, share);
  if (edges.empty()) return single_ridges(share);
  GrowingLines growing(topology);
  for (int e : edges) growing.join(e);
  return growing.lines(share);
}

}  // namespace ffcontact
