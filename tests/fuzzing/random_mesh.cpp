// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact::fuzz {

namespace {

double twice_area(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const Vector2d u = b - a, v = c - a;
  return u.x() * v.y() - u.y() * v.x();
}

using Pair = std::pair<int, int>;
Pair sorted(int a, int b) { return std::minmax(a, b); }

/// Triangles and opposite local vertices of each edge.
std::map<Pair, std::vector<Pair>> sides_of(const Mesh& mesh) {
  std::map<Pair, std::vector<Pair>> sides;
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k)
      sides[sorted(mesh.cells((k + 1) % 3, t), mesh.cells((k + 2) % 3, t))]
          .emplace_back(t, k);
  return sides;
}

int find_root(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

/// Parts that are joined by common edges, among all triangles or those around one vertex.
int part_count(const Mesh& mesh, const std::vector<int>& triangles,
               int around) {
  std::vector<int> parent(triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  std::map<Pair, int> first;
  int parts = static_cast<int>(triangles.size());
  for (int i = 0; i < static_cast<int>(triangles.size()); ++i)
    for (int k = 0; k < 3; ++k) {
      const Pair side = sorted(mesh.cells(k, triangles[i]),
                               mesh.cells((k + 1) % 3, triangles[i]));
      if (around >= 0 && side.first != around && side.second != around)
        continue;
      const auto [place, is_new] = first.emplace(side, i);
      if (is_new) continue;
      const int a = find_root(parent, i), b = find_root(parent, place->second);
      if (a != b) --parts;
      parent[a] = b;
    }
  return parts;
}

bool hangs_together(const Mesh& mesh, const std::vector<int>& triangles) {
  if (triangles.empty() || part_count(mesh, triangles, -1) > 1) return false;
  std::map<int, std::vector<int>> fans;
  for (int t : triangles)
    for (int v : mesh.cells.col(t)) fans[v].push_back(t);
  return std::all_of(fans.begin(), fans.end(), [&](const auto& fan) {
    return part_count(mesh, fan.second, fan.first) == 1;
  });
}

void set_boundary(Mesh& mesh, const std::vector<Vector3i>& edges) {
  const auto n = static_cast<Index>(edges.size());
  mesh.boundary.resize(2, n);
  mesh.boundary_label.resize(n);
  for (Index e = 0; e < n; ++e) {
    mesh.boundary.col(e) = edges[e].head<2>();
    mesh.boundary_label[e] = edges[e][2];
  }
}

Index label_count(const Mesh& mesh, int label) {
  return (mesh.boundary_label.array() == label).count();
}

bool keeps_labels(const Mesh& rest, const Mesh& mesh,
                  const std::vector<int>& kept, const std::vector<int>& whole) {
  return std::all_of(kept.begin(), kept.end(),
                     [&](int label) { return label_count(rest, label) > 0; }) &&
         std::all_of(whole.begin(), whole.end(), [&](int label) {
           return label_count(rest, label) == label_count(mesh, label);
         });
}

}  // namespace

Mesh grid(const std::vector<double>& columns, const std::vector<double>& rows,
          Dice& dice) {
  const int nx = static_cast<int>(columns.size()) - 1,
            ny = static_cast<int>(rows.size()) - 1;
  const auto id = [nx](int i, int j) { return j * (nx + 1) + i; };
  Mesh mesh;
  mesh.vertices.resize(2, (nx + 1) * (ny + 1));
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i)
      mesh.vertices.col(id(i, j)) << columns[i], rows[j];
  mesh.cells.resize(3, 2 * nx * ny);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = id(i, j), b = id(i + 1, j), c = id(i + 1, j + 1),
                d = id(i, j + 1), t = 2 * (j * nx + i);
      if (dice.chance(0.5))
        mesh.cells.middleCols<2>(t) << a, a, b, c, c, d;
      else
        mesh.cells.middleCols<2>(t) << a, b, b, c, d, d;
    }
  std::vector<Vector3i> edges;
  for (int i = 0; i < nx; ++i)
    edges.emplace_back(id(i, 0), id(i + 1, 0), bottom);
  for (int j = 0; j < ny; ++j)
    edges.emplace_back(id(nx, j), id(nx, j + 1), right);
  for (int i = nx; i > 0; --i)
    edges.emplace_back(id(i, ny), id(i - 1, ny), top);
  for (int j = ny; j > 0; --j) edges.emplace_back(id(0, j), id(0, j - 1), left);
  set_boundary(mesh, edges);
  return mesh;
}

void crack(Mesh& mesh, int columns, int row, int first, int last) {
  const auto id = [&](int i) { return row * (columns + 1) + i; };
  const Index old = mesh.vertices.cols(), edges = mesh.boundary.cols();
  std::vector<int> above(old);  // what vertices are called there
  std::iota(above.begin(), above.end(), 0);
  std::vector<int> cut;
  for (int i = first; i <= last; ++i)
    if ((i > first || i == 0) && (i < last || i == columns)) {
      above[id(i)] = static_cast<int>(old) + static_cast<int>(cut.size());
      cut.push_back(id(i));
    }
  mesh.vertices.conservativeResize(2, old + static_cast<Index>(cut.size()));
  for (std::size_t k = 0; k < cut.size(); ++k)
    mesh.vertices.col(old + static_cast<Index>(k)) = mesh.vertices.col(cut[k]);
  const double height = mesh.vertices(1, id(0));
  const auto rename = [&](auto&& vertices) {
    double middle = 0;
    for (const int v : vertices) middle += mesh.vertices(1, v);
    if (middle > height * static_cast<double>(vertices.size()))
      for (int& v : vertices) v = above[v];
  };
  for (auto cell : mesh.cells.colwise()) rename(cell);
  for (auto edge : mesh.boundary.colwise()) rename(edge);
  mesh.boundary.conservativeResize(2, edges + 2 * (last - first));
  mesh.boundary_label.conservativeResize(edges + 2 * (last - first));
  for (int i = first; i < last; ++i) {
    const Index e = edges + 2 * (i - first);
    mesh.boundary.col(e) << id(i + 1), id(i);
    mesh.boundary.col(e + 1) << above[id(i)], above[id(i + 1)];
    mesh.boundary_label.segment<2>(e) << below_crack, above_crack;
  }
}

std::vector<double> places(int cells, double length, double grading,
                           Dice& dice) {
  std::vector<double> result{0};
  for (int i = 0; i < cells; ++i)
    result.push_back(result.back() + dice.decades(1, grading));
  const double scale = length / result.back();
  for (double& x : result) x *= scale;
  result.back() = length;
  return result;
}

void move_inner_vertices(Mesh& mesh, double fraction, Dice& dice) {
  std::vector<double> room(mesh.vertices.cols(),
                           std::numeric_limits<double>::infinity());
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.cells(k, t), b = mesh.cells((k + 1) % 3, t);
      const double length =
          (mesh.vertices.col(a) - mesh.vertices.col(b)).norm();
      room[a] = std::min(room[a], length);
      room[b] = std::min(room[b], length);
    }
  for (int v : mesh.boundary.reshaped()) room[v] = 0;
  const Matrix2Xd before = mesh.vertices;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    mesh.vertices.col(v) +=
        fraction * room[v] * Vector2d(dice.real(-1, 1), dice.real(-1, 1));
  // a triangle was turned over
  if (!std::isfinite(worst_aspect(mesh))) mesh.vertices = before;
}

void flip_edges(Mesh& mesh, int tries, Dice& dice) {
  for (; tries > 0; --tries) {
    const auto sides = sides_of(mesh);
    auto side = sides.begin();
    std::advance(side, dice.integer(0, static_cast<int>(sides.size()) - 1));
    if (side->second.size() < 2) continue;
    const auto [t, k] = side->second[0];
    const auto [s, l] = side->second[1];
    const int a = mesh.cells((k + 1) % 3, t), b = mesh.cells((k + 2) % 3, t),
              c = mesh.cells(k, t), d = mesh.cells(l, s);
    const auto point = [&](int v) { return Vector2d(mesh.vertices.col(v)); };
    const double whole = twice_area(point(a), point(b), point(c)) +
                         twice_area(point(b), point(a), point(d));
    if (std::min(twice_area(point(c), point(a), point(d)),
                 twice_area(point(d), point(b), point(c))) < 0.05 * whole)
      continue;
    mesh.cells.col(t) << c, a, d;
    mesh.cells.col(s) << d, b, c;
  }
}

bool remove_triangles(Mesh& mesh, const std::vector<char>& removed,
                      std::vector<int>* kept_triangles) {
  std::vector<int> kept;
  for (int t = 0; t < mesh.cell_count(); ++t)
    if (!removed[t]) kept.push_back(t);
  if (!hangs_together(mesh, kept)) return false;
  std::map<Pair, int> label;
  for (int e = 0; e < mesh.boundary.cols(); ++e)
    label[sorted(mesh.boundary(0, e), mesh.boundary(1, e))] =
        mesh.boundary_label[e];
  Mesh rest;
  std::map<int, int> number;
  rest.cells.resize(3, static_cast<Index>(kept.size()));
  for (std::size_t t = 0; t < kept.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int v = mesh.cells(k, kept[t]);
      rest.cells(k, static_cast<Index>(t)) =
          number.emplace(v, static_cast<int>(number.size())).first->second;
    }
  rest.vertices.resize(2, static_cast<Index>(number.size()));
  for (const auto& [before, after] : number)
    rest.vertices.col(after) = mesh.vertices.col(before);
  std::map<int, int> old_number;
  for (const auto& [before, after] : number) old_number[after] = before;
  std::vector<Vector3i> edges;
  for (const auto& [side, triangles] : sides_of(rest)) {
    if (triangles.size() > 1) continue;
    const auto [t, k] = triangles.front();
    const int a = rest.cells((k + 1) % 3, t), b = rest.cells((k + 2) % 3, t);
    const auto found = label.find(sorted(old_number[a], old_number[b]));
    edges.emplace_back(a, b,
                       found == label.end() ? int{bitten} : found->second);
  }
  set_boundary(rest, edges);
  mesh = std::move(rest);
  if (kept_triangles) *kept_triangles = kept;
  return true;
}

void bite(Mesh& mesh, int tries, const std::vector<int>& kept,
          const std::vector<int>& whole, Dice& dice) {
  for (; tries > 0; --tries) {
    Mesh rest = mesh;
    std::vector<char> removed(mesh.cells.cols(), 0);
    removed[dice.integer(0, mesh.cell_count() - 1)] = 1;
    if (remove_triangles(rest, removed) &&
        keeps_labels(rest, mesh, kept, whole))
      mesh = std::move(rest);
  }
}

void split_triangles(Mesh& mesh, int tries, Dice& dice) {
  for (; tries > 0; --tries) {
    const int t = dice.integer(0, mesh.cell_count() - 1),
              v = mesh.vertex_count();
    Vector3d weights(dice.real(0.2, 1), dice.real(0.2, 1), dice.real(0.2, 1));
    weights /= weights.sum();
    const Vector3i old = mesh.cells.col(t);
    mesh.vertices.conservativeResize(Eigen::NoChange, v + 1);
    mesh.vertices.col(v) = weights[0] * mesh.vertices.col(old[0]) +
                           weights[1] * mesh.vertices.col(old[1]) +
                           weights[2] * mesh.vertices.col(old[2]);
    mesh.cells.conservativeResize(Eigen::NoChange, mesh.cells.cols() + 2);
    mesh.cells.col(t) << old[0], old[1], v;
    mesh.cells.rightCols<2>() << old[1], old[2], old[2], old[0], v, v;
  }
}

void renumber(Mesh& mesh, Dice& dice) {
  std::vector<int> vertex(mesh.vertices.cols()), triangle(mesh.cells.cols());
  std::iota(vertex.begin(), vertex.end(), 0);
  std::iota(triangle.begin(), triangle.end(), 0);
  dice.shuffle(vertex);
  dice.shuffle(triangle);
  const Mesh old = mesh;
  for (int v = 0; v < old.vertex_count(); ++v)
    mesh.vertices.col(vertex[v]) = old.vertices.col(v);
  for (int t = 0; t < old.cell_count(); ++t) {
    const int turn = dice.integer(0, 2);
    for (int k = 0; k < 3; ++k)
      mesh.cells((k + turn) % 3, triangle[t]) = vertex[old.cells(k, t)];
  }
  for (int e = 0; e < old.boundary.cols(); ++e) {
    const int turn = dice.integer(0, 1);
    for (int k = 0; k < 2; ++k)
      mesh.boundary((k + turn) % 2, e) = vertex[old.boundary(k, e)];
  }
}

double worst_aspect(const Mesh& mesh) {
  double worst = 0;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const Vector2d a = mesh.corner(t, 0), b = mesh.corner(t, 1),
                   c = mesh.corner(t, 2);
    const double area = twice_area(a, b, c);
    const double longest = std::max(
        {(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    worst = std::max(worst, area > 0 ? longest / area
                                     : std::numeric_limits<double>::infinity());
  }
  return worst;
}

}  // namespace ffcontact::fuzz
