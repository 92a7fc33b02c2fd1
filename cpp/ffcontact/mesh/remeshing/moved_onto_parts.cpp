// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/remeshing/moved_onto_parts.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/mesh/smooth_curve.hpp"

namespace ffcontact {

namespace {

/// Places of a part for the vertices of a mesh that follows it.
class Places {
 public:
  Places(const Mesh& mesh, const BoundaryPart& part)
      : first_(mesh.vertices.col(part.vertices.front())),
        last_(mesh.vertices.col(part.vertices.back())),
        curve_(part.curve) {}

  Vector2d beside(const Vector2d& x) const {
    return curve_ ? curve_->beside(x) : on_the_chord(x);
  }
  Vector2d nearest_end(const Vector2d& x) const {
    const bool is_first =
        (x - first_).squaredNorm() < (x - last_).squaredNorm();
    return is_first ? first_ : last_;
  }

 private:
  Vector2d on_the_chord(const Vector2d& x) const {
    const Vector2d along = last_ - first_;
    const double share = (x - first_).dot(along) / along.squaredNorm();
    return first_ + std::clamp(share, 0.0, 1.0) * along;
  }

  Vector2d first_, last_;
  std::optional<SmoothCurve<2>> curve_;
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
  const int part_count = count_of(parts);
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

void require_none_turned(const Mesh& before, const Mesh& after) {
  const auto [triangle, kept] = worst_triangle(before, after);
  if (kept > 0) return;
  refuse("the triangle at ", in_words(before.place(before.cells(0, triangle))),
         " turns over when the boundary is put on its curve: the curve has "
         "too few vertices for sizes that small");
}

/// How far vertices move.
struct Moves {
  Matrix2Xd by;
  Flags given;  ///< of the vertices on parts
};

Moves moves_to(const std::map<int, Vector2d>& places, const Mesh& mesh) {
  const Index vertices = mesh.vertices.cols();
  Moves moves{Matrix2Xd::Zero(2, vertices), Flags(vertices, 0)};
  for (const auto& [vertex, place] : places) {
    moves.by.col(vertex) = place - mesh.vertices.col(vertex);
    moves.given[vertex] = 1;
  }
  return moves;
}

/// Moves of the other vertices become the mean of their neighbours' moves.
void spread(const Mesh& mesh, Moves& moves) {
  Matrix2Xd sum = Matrix2Xd::Zero(2, moves.by.cols());
  VectorXd count = VectorXd::Zero(moves.by.cols());
  const auto add = [&](int vertex, int neighbour) {
    sum.col(vertex) += moves.by.col(neighbour);
    count[vertex] += 1;
  };
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.cells(k, t), b = mesh.cells((k + 1) % 3, t);
      add(a, b);
      add(b, a);
    }
  for (Index v = 0; v < moves.by.cols(); ++v)
    if (!moves.given[v]) moves.by.col(v) = sum.col(v) / count[v];
}

}  // namespace

Mesh moved_onto_parts(Mesh fine, const Mesh& mesh,
                      const std::vector<BoundaryPart>& parts) {
  constexpr double enough = 0.3;  // of a triangle's area
  constexpr int most_sweeps = 50;
  Moves moves = moves_to(wanted_places(fine, mesh, parts), fine);
  Mesh moved = fine;
  moved.vertices += moves.by;
  for (int sweep = 0;
       sweep < most_sweeps && worst_triangle(fine, moved).second < enough;
       ++sweep) {
    spread(fine, moves);
    moved.vertices = fine.vertices + moves.by;
  }
  require_none_turned(fine, moved);
  return moved;
}

}  // namespace ffcontact
