// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/boundary_parts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "ffcontact/base/require.hpp"
#include "ffcontact/mesh/smooth_curve.hpp"
#include "ffcontact/mesh/straight_runs.hpp"

namespace ffcontact {

namespace {

constexpr double degree = M_PI / 180;
constexpr int fewest_edges = 3;  ///< of a curve

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
  bool closed() const { return vertices.front() == vertices.back(); }
};

Chain chain_from(const Mesh& mesh, const EdgesAtVertex& at, int vertex,
                 int column, std::set<int>& used) {
  Chain chain{{vertex}, {}};
  while (used.insert(column).second) {
    chain.columns.push_back(column);
    vertex = mesh.boundary.col(column).sum() - vertex;
    chain.vertices.push_back(vertex);
    const std::vector<int>& columns = at.find(vertex)->second;
    if (columns.size() != 2) break;
    column = columns[0] == column ? columns[1] : columns[0];
  }
  return chain;
}

Matrix2Xd points_of(const Mesh& mesh, const std::vector<int>& vertices) {
  return mesh.vertices(Eigen::all, vertices);
}

double turn_at(const Vector2d& before, const Vector2d& at,
               const Vector2d& after) {
  return angle_between(at - before, after - at);
}

/// Where a closed chain of points turns the most.
Index sharpest_point(const Matrix2Xd& x) {
  const Index n = x.cols() - 1;
  Index sharpest = 0;
  double most = 0;
  for (Index k = 0; k < n; ++k) {
    const double turn = turn_at(x.col((k + n - 1) % n), x.col(k), x.col(k + 1));
    if (turn <= most) continue;
    most = turn;
    sharpest = k;
  }
  return sharpest;
}

void rotate_to(Index first, std::vector<int>& values) {
  std::rotate(values.begin(), values.begin() + first, values.end());
}

/// A closed chain starts where it turns the most.
void start_at_corner(const Mesh& mesh, Chain& chain) {
  const Index sharpest = sharpest_point(points_of(mesh, chain.vertices));
  chain.vertices.pop_back();
  rotate_to(sharpest, chain.vertices);
  rotate_to(sharpest, chain.columns);
  chain.vertices.push_back(chain.vertices.front());
}

std::vector<Chain> chains_of(const Mesh& mesh) {
  const EdgesAtVertex at = edges_at_vertices(mesh);
  std::vector<Chain> chains;
  std::set<int> used;
  for (const auto& [vertex, columns] : at)
    if (columns.size() != 2)
      for (int column : columns)
        if (!used.count(column))
          chains.push_back(chain_from(mesh, at, vertex, column, used));
  for (int b = 0; b < mesh.boundary.cols(); ++b)
    if (!used.count(b)) {
      chains.push_back(chain_from(mesh, at, mesh.boundary(0, b), b, used));
      start_at_corner(mesh, chains.back());
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

double largest_turn(const Mesh& mesh, const std::vector<BoundaryPart>& parts) {
  double largest = 0;
  for (const BoundaryPart& part : parts)
    for (std::size_t k = 1; k + 1 < part.curve.size(); ++k) {
      const int* const v = &part.curve[k];
      const double turn =
          turn_at(mesh.vertices.col(v[-1]), mesh.vertices.col(v[0]),
                  mesh.vertices.col(v[1]));
      largest = std::max(largest, turn);
    }
  return largest;
}

/// Places of a part for the vertices of a mesh that follows it.
class Places {
 public:
  Places(const Mesh& mesh, const BoundaryPart& part) : ends_(2, 2) {
    ends_ << mesh.vertices.col(part.vertices.front()),
        mesh.vertices.col(part.vertices.back());
    if (part.straight()) return;
    const Matrix2Xd points = points_of(mesh, part.curve);
    curve_ = smooth_curve(points, part.curve.front() == part.curve.back() &&
                                      closes_smoothly(points));
  }

  Vector2d beside(const Vector2d& x) const {
    if (curve_) return curve_->beside(x);
    const Vector2d first = ends_.col(0), along = ends_.col(1) - first;
    return first +
           std::clamp((x - first).dot(along) / along.squaredNorm(), 0.0, 1.0) *
               along;
  }
  Vector2d nearest_end(const Vector2d& x) const {
    return ends_.col((x - ends_.col(0)).squaredNorm() <
                             (x - ends_.col(1)).squaredNorm()
                         ? 0
                         : 1);
  }

 private:
  Matrix2d ends_;
  std::optional<SmoothCurve> curve_;
};

/// The parts that each vertex is on, by labels that count from `first_label`.
std::map<int, std::set<int>> parts_at_vertices(const Mesh& fine,
                                               int first_label,
                                               int part_count) {
  std::map<int, std::set<int>> parts_at;
  for (int b = 0; b < fine.boundary.cols(); ++b) {
    const int part = fine.boundary_label[b] - first_label;
    if (part < 0 || part >= part_count) continue;
    for (int v : fine.boundary.col(b)) parts_at[v].insert(part);
  }
  return parts_at;
}

/// New places of the vertices on parts, by vertex.
std::map<int, Vector2d> wanted_places(const Mesh& fine, const Mesh& mesh,
                                      const std::vector<BoundaryPart>& parts) {
  std::vector<Places> places;
  for (const BoundaryPart& part : parts) places.emplace_back(mesh, part);
  const int part_count = static_cast<int>(parts.size());
  std::map<int, Vector2d> wanted;
  for (const auto& [vertex, at] :
       parts_at_vertices(fine, part_label(mesh, 0), part_count)) {
    const Vector2d x = fine.vertices.col(vertex);
    const Places& place = places[*at.begin()];
    wanted.emplace(vertex,
                   at.size() > 1 ? place.nearest_end(x) : place.beside(x));
  }
  return wanted;
}

/// The triangle that keeps the smallest part of its area when vertices move, and that
/// part.
std::pair<int, double> worst_triangle(const Mesh& before, const Mesh& after) {
  std::pair<int, double> worst{0, 1};
  for (int t = 0; t < before.cell_count(); ++t) {
    const double kept = signed_area(after, t) / signed_area(before, t);
    if (kept < worst.second) worst = {t, kept};
  }
  return worst;
}

/// Moves of the other vertices become the mean of their neighbours' moves.
void spread(const Mesh& mesh, const std::vector<char>& given,
            Matrix2Xd& moves) {
  Matrix2Xd sum = Matrix2Xd::Zero(2, moves.cols());
  VectorXd count = VectorXd::Zero(moves.cols());
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.cells(k, t), b = mesh.cells((k + 1) % 3, t);
      sum.col(a) += moves.col(b);
      sum.col(b) += moves.col(a);
      count[a] += 1;
      count[b] += 1;
    }
  for (Index v = 0; v < moves.cols(); ++v)
    if (!given[v]) moves.col(v) = sum.col(v) / count[v];
}

/// Appends the parts of one label each that a line or curve of a chain has.
void add_parts(const Mesh& mesh, const Chain& chain, const LinePart& line,
               std::vector<BoundaryPart>& parts) {
  const auto label = [&](int k) {
    return mesh.boundary_label[chain.columns[k]];
  };
  const auto vertices = [&](int first, int last) {
    return std::vector<int>(chain.vertices.begin() + first,
                            chain.vertices.begin() + last + 1);
  };
  for (int first = line.first, last = first; first < line.last; first = last) {
    while (last < line.last && label(last) == label(first)) ++last;
    parts.push_back(
        {vertices(first, last),
         {chain.columns.begin() + first, chain.columns.begin() + last},
         line.straight ? std::vector<int>{} : vertices(line.first, line.last),
         label(first)});
  }
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

void require_none_turned(const Mesh& before, const Mesh& after) {
  const auto [triangle, kept] = worst_triangle(before, after);
  if (kept > 0) return;
  const Vector2d x = before.place(before.cells(0, triangle));
  refuse("the triangle at (", x.x(), ", ", x.y(),
         ") turns over when the boundary is put on its curve: the curve has "
         "too few "
         "vertices for sizes that small");
}

}  // namespace

std::vector<BoundaryPart> boundary_parts(const Mesh& mesh, double corner) {
  const double size = extent(mesh.vertices);
  std::vector<BoundaryPart> parts;
  for (const Chain& chain : chains_of(mesh)) {
    const Matrix2Xd points = points_of(mesh, chain.vertices);
    const double tolerance =
        straight_tolerance(coordinate_precision(points, size), size);
    for (const LinePart& line :
         line_parts(points, tolerance, corner, fewest_edges))
      add_parts(mesh, chain, line, parts);
  }
  return parts;
}

double smallest_corner(const Mesh& mesh, const std::vector<BoundaryPart>& parts,
                       double corner) {
  // what bends at less is straightened afterwards without harm
  constexpr double shallow = 3 * degree;
  const double turn = std::max(largest_turn(mesh, parts), shallow / 6);
  double smallest = corner;
  for (const auto& [vertex, at] : ends_of(mesh, parts)) {
    if (at.size() != 2) continue;
    const double angle = angle_between(at[0].leaving, -at[1].leaving);
    const bool between_lines = at[0].straight && at[1].straight;
    if (angle > shallow && (between_lines || angle > 1.5 * turn))
      smallest = std::min(smallest, angle);
  }
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
  for (std::size_t k = 0; k < parts.size(); ++k)
    for (int column : parts[k].columns)
      labels[column] = part_label(mesh, static_cast<int>(k));
  return labels;
}

Mesh moved_onto_parts(Mesh fine, const Mesh& mesh,
                      const std::vector<BoundaryPart>& parts) {
  constexpr double enough = 0.3;  // of a triangle's area
  constexpr int most_sweeps = 50;
  std::vector<char> given(fine.vertices.cols(), 0);
  Matrix2Xd moves = Matrix2Xd::Zero(2, fine.vertices.cols());
  for (const auto& [vertex, place] : wanted_places(fine, mesh, parts)) {
    moves.col(vertex) = place - fine.vertices.col(vertex);
    given[vertex] = 1;
  }
  Mesh moved = fine;
  moved.vertices += moves;
  for (int sweep = 0;
       sweep < most_sweeps && worst_triangle(fine, moved).second < enough;
       ++sweep) {
    spread(fine, given, moves);
    moved.vertices = fine.vertices + moves;
  }
  require_none_turned(fine, moved);
  return moved;
}

}  // namespace ffcontact
