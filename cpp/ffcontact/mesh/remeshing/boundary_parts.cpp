// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/remeshing/boundary_parts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/mesh/line_parts.hpp"
#include "ffcontact/mesh/straight_runs.hpp"
#include "ffcontact/mesh/turns.hpp"

namespace ffcontact {

namespace {

constexpr double degree = M_PI / 180;
/// What bends at less is straightened afterwards without harm.
constexpr double shallow = 3 * degree;

/// The labelled edges at each vertex, by their columns.
using EdgesAtVertex = std::map<int, std::vector<int>>;

EdgesAtVertex edges_at_vertices(const Mesh& mesh) {
  EdgesAtVertex at;
  for (int b = 0; b < mesh.boundary.cols(); ++b)
    for (int v : mesh.boundary.col(b)) at[v].push_back(b);
  return at;
}

/// Labelled edges one after the other, from one end or branch to the next, or around.
struct Chain {
  std::vector<int> vertices, columns;
  bool is_loop = false;  ///< without an end or a branch
};

/// The other edge at a vertex, nothing where it is an end or a branch.
std::optional<int> next_column(const EdgesAtVertex& at, int vertex,
                               int column) {
  const std::vector<int>& columns = entry_of(at, vertex, "edge at a vertex");
  if (columns.size() != 2) return std::nullopt;
  return columns[0] + columns[1] - column;
}

Chain chain_from(const Mesh& mesh, const EdgesAtVertex& at, int vertex,
                 std::optional<int> column, std::set<int>& used) {
  Chain chain{{vertex}, {}, false};
  while (column && used.insert(*column).second) {
    chain.columns.push_back(*column);
    vertex = mesh.boundary.col(*column).sum() - vertex;
    chain.vertices.push_back(vertex);
    column = next_column(at, vertex, *column);
  }
  return chain;
}

Matrix2Xd points_of(const Mesh& mesh, const std::vector<int>& vertices) {
  return mesh.vertices(Eigen::all, vertices);
}

void rotate_to(Index first, std::vector<int>& values) {
  std::rotate(values.begin(), values.begin() + first, values.end());
}

void start_at(int first, Chain& chain) {
  chain.vertices.pop_back();
  rotate_to(first, chain.vertices);
  rotate_to(first, chain.columns);
  chain.vertices.push_back(chain.vertices.front());
}

/// Those that begin at an end or a branch.
std::vector<Chain> open_chains(const Mesh& mesh, const EdgesAtVertex& at,
                               std::set<int>& used) {
  std::vector<Chain> chains;
  for (const auto& [vertex, columns] : at) {
    if (columns.size() == 2) continue;
    for (int column : columns)
      if (!used.count(column))
        chains.push_back(chain_from(mesh, at, vertex, column, used));
  }
  return chains;
}

std::vector<Chain> chains_of(const Mesh& mesh) {
  const EdgesAtVertex at = edges_at_vertices(mesh);
  std::set<int> used;
  std::vector<Chain> chains = open_chains(mesh, at, used);
  for (int b = 0; b < mesh.boundary.cols(); ++b) {
    if (used.count(b)) continue;
    chains.push_back(chain_from(mesh, at, mesh.boundary(0, b), b, used));
    chains.back().is_loop = true;
  }
  return chains;
}

/// Direction in which a part leaves its first (or, backwards, its last) vertex.
Vector2d leaving(const Mesh& mesh, const BoundaryPart& part, bool backwards) {
  const std::size_t n = part.vertices.size();
  const int from = part.vertices[backwards ? n - 1 : 0],
            to = part.vertices[backwards ? n - 2 : 1];
  return mesh.vertices.col(to) - mesh.vertices.col(from);
}

double largest_turn(const SmoothCurve<2>& curve) {
  const Turns<2> turns(curve.points);
  double largest = 0;
  for (Index k = 1; k < turns.edges(); ++k)
    largest = std::max(largest, turns.turn(k));
  return largest;
}

/// Inside curves.
double largest_turn(const std::vector<BoundaryPart>& parts) {
  double largest = 0;
  for (const BoundaryPart& part : parts)
    if (part.curve) largest = std::max(largest, largest_turn(*part.curve));
  return largest;
}

/// Values at places from `first` to `last`.
std::vector<int> slice(const std::vector<int>& values, int first, int last) {
  return {values.begin() + first, values.begin() + last + 1};
}

/// Appends the parts of one label each that a line or curve of a chain has.
void add_parts(const Mesh& mesh, const Chain& chain, const LinePart& line,
               const std::optional<SmoothCurve<2>>& curve,
               std::vector<BoundaryPart>& parts) {
  const auto label = [&](int k) {
    return mesh.boundary_label[chain.columns[k]];
  };
  for (int first = line.first, last = first; first < line.last; first = last) {
    while (last < line.last && label(last) == label(first)) ++last;
    parts.push_back({slice(chain.vertices, first, last),
                     slice(chain.columns, first, last - 1), curve,
                     label(first)});
  }
}

/// Appends the parts of a chain.
void add_parts(const Mesh& mesh, Chain chain, double corner, double size,
               std::vector<BoundaryPart>& parts) {
  Matrix2Xd points = points_of(mesh, chain.vertices);
  const double tolerance =
      straight_tolerance(coordinate_precision(points, size), size);
  if (chain.is_loop) {
    start_at(loop_start(points, tolerance, corner), chain);
    points = points_of(mesh, chain.vertices);
  }
  const std::vector<LinePart> lines = line_parts(points, tolerance, corner);
  for (std::size_t k = 0; k < lines.size(); ++k)
    add_parts(mesh, chain, lines[k],
              lines[k].straight ? std::nullopt
                                : std::optional(curve_of(points, lines, k)),
              parts);
}

/// How a part leaves one of its ends.
struct PartEnd {
  Vector2d leaving;
  bool straight;
};

std::map<int, std::vector<PartEnd>> ends_of(
    const Mesh& mesh, const std::vector<BoundaryPart>& parts) {
  std::map<int, std::vector<PartEnd>> ends;
  for (const BoundaryPart& part : parts)
    for (const bool backwards : {false, true}) {
      const int end = backwards ? part.vertices.back() : part.vertices.front();
      ends[end].push_back({leaving(mesh, part, backwards), part.straight()});
    }
  return ends;
}

/// The angle between two parts that meet; nothing if it may be straightened, or is that
/// of a curve as well.
/// @param turn  the largest inside curves
std::optional<double> angle_of_corner(const std::vector<PartEnd>& at,
                                      double turn) {
  if (at.size() != 2) return std::nullopt;
  const double angle = angle_between(at[0].leaving, -at[1].leaving);
  const bool between_lines = at[0].straight && at[1].straight;
  const bool is_corner =
      angle > shallow && (between_lines || angle > 1.5 * turn);
  return is_corner ? std::optional(angle) : std::nullopt;
}

}  // namespace

std::vector<BoundaryPart> boundary_parts(const Mesh& mesh, double corner) {
  const double size = extent(mesh.vertices);
  std::vector<BoundaryPart> parts;
  for (Chain& chain : chains_of(mesh))
    add_parts(mesh, std::move(chain), corner, size, parts);
  return parts;
}

double smallest_corner(const Mesh& mesh, const std::vector<BoundaryPart>& parts,
                       double corner) {
  const double turn = std::max(largest_turn(parts), shallow / 6);
  double smallest = corner;
  for (const auto& [vertex, at] : ends_of(mesh, parts))
    if (const auto angle = angle_of_corner(at, turn))
      smallest = std::min(smallest, *angle);
  return smallest > turn ? std::sqrt(smallest * turn) : corner;
}

int part_label(const Mesh& mesh, int part) {
  const int highest =
      mesh.boundary_label.size() > 0 ? mesh.boundary_label.maxCoeff() : 0;
  return std::max(0, highest) + 1 + part;
}

VectorXi labelled_by_parts(const Mesh& mesh,
                           const std::vector<BoundaryPart>& parts) {
  VectorXi labels = mesh.boundary_label;
  int label = part_label(mesh, 0);
  for (const BoundaryPart& part : parts) {
    labels(part.columns).setConstant(label);
    ++label;
  }
  return labels;
}

}  // namespace ffcontact
