// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/rectangle.hpp"
#include "ffcontact/mesh/topology.hpp"
#include "support/uniform.hpp"

/// Meshes that the tests share.
namespace ffcontact::test {

/// Labels of a rectangle's sides, those of FreeFEM's square().
enum Side : int { bottom = 1, right = 2, top = 3, left = 4 };

inline Mesh rectangle(int nx, int ny, double width, double height) {
  return ffcontact::rectangle({nx, ny}, {width, height});
}

/// A rectangle whose vertices are moved at random, by less than `fraction` of the cell in
/// each direction; those on a side stay on it. The triangles stay positive for fraction <
/// 1/4.
inline Mesh moved(Mesh mesh, double cell, double fraction,
                  std::mt19937& random) {
  const Uniform shift{-fraction * cell, fraction * cell};
  const Vector2d low = mesh.vertices.rowwise().minCoeff(),
                 high = mesh.vertices.rowwise().maxCoeff();
  for (int v = 0; v < mesh.vertex_count(); ++v)
    for (int c = 0; c < 2; ++c) {
      const double by = shift(random), x = mesh.vertices(c, v);
      if (x > low[c] && x < high[c]) mesh.vertices(c, v) += by;
    }
  return mesh;
}

struct Renumbered {
  Mesh mesh;
  std::vector<int> vertex;  ///< new number of each old vertex
};

/// The same body with vertices, triangles, local vertices and labelled edges in random
/// order, edges in random direction.
inline Renumbered renumbered(const Mesh& mesh, std::mt19937& random) {
  const auto shuffled = [&random](Index n) {
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    shuffle(order, random);
    return order;
  };
  Renumbered result{mesh, shuffled(mesh.vertices.cols())};
  for (int v = 0; v < mesh.vertex_count(); ++v)
    result.mesh.vertices.col(result.vertex[v]) = mesh.vertices.col(v);
  const std::vector<int> triangle = shuffled(mesh.cells.cols()),
                         boundary = shuffled(mesh.boundary.cols());
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const int turn = static_cast<int>(random() % 3);
    for (int k = 0; k < 3; ++k)
      result.mesh.cells((k + turn) % 3, triangle[t]) =
          result.vertex[mesh.cells(k, t)];
  }
  for (Index e = 0; e < mesh.boundary.cols(); ++e) {
    const int turn = static_cast<int>(random() % 2);
    for (int k = 0; k < 2; ++k)
      result.mesh.boundary((k + turn) % 2, boundary[e]) =
          result.vertex[mesh.boundary(k, e)];
    result.mesh.boundary_label[boundary[e]] = mesh.boundary_label[e];
  }
  return result;
}

/// Longest-edge bisection of the marked triangles, closed to a conforming mesh.
class Bisection {
 public:
  Bisection(const Mesh& mesh, const std::vector<int>& marked)
      : old_(mesh), new_(mesh) {
    for (int t : marked) halve_longest(t);
    for (bool closed = false; !closed;) {
      closed = true;
      for (int t = 0; t < old_.cell_count(); ++t)
        if (is_touched(t) && halve_longest(t)) closed = false;
    }
  }

  Mesh mesh() {
    std::vector<Vector3i> triangles;
    for (int t = 0; t < old_.cell_count(); ++t) split(t, triangles);
    new_.cells.resize(3, static_cast<Index>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t)
      new_.cells.col(static_cast<Index>(t)) = triangles[t];
    split_boundary();
    return std::move(new_);
  }

 private:
  static std::pair<int, int> key(int a, int b) { return std::minmax(a, b); }
  int middle(int a, int b) const {
    const auto found = middle_.find(key(a, b));
    return found == middle_.end() ? -1 : found->second;
  }

  /// Local vertex opposite to the longest edge.
  int apex(int t) const {
    int best = 0;
    for (int k = 1; k < 3; ++k)
      if (side_length(t, k) > side_length(t, best) * (1 + 1e-12)) best = k;
    return best;
  }
  double side_length(int t, int k) const {
    return (old_.corner(t, (k + 1) % 3) - old_.corner(t, (k + 2) % 3)).norm();
  }

  bool is_touched(int t) const {
    for (int k = 0; k < 3; ++k)
      if (middle(old_.cells(k, t), old_.cells((k + 1) % 3, t)) >= 0)
        return true;
    return false;
  }

  /// False when it has been halved before.
  bool halve_longest(int t) {
    const int k = apex(t), a = old_.cells((k + 1) % 3, t),
              b = old_.cells((k + 2) % 3, t);
    const int number = new_.vertex_count();
    if (!middle_.emplace(key(a, b), number).second) return false;
    new_.vertices.conservativeResize(Eigen::NoChange, number + 1);
    new_.vertices.col(number) =
        0.5 * (old_.vertices.col(a) + old_.vertices.col(b));
    return true;
  }

  void split(int t, std::vector<Vector3i>& triangles) const {
    const int k = apex(t), a = old_.cells(k, t), b = old_.cells((k + 1) % 3, t),
              c = old_.cells((k + 2) % 3, t);
    const int m = middle(b, c);
    if (m < 0) {
      triangles.emplace_back(a, b, c);
      return;
    }
    // the triangle (start, end, m), halved again at its old side
    const auto add_half = [&](int start, int end) {
      const int p = middle(start, end);
      if (p < 0) {
        triangles.emplace_back(start, end, m);
      } else {
        triangles.emplace_back(start, p, m);
        triangles.emplace_back(p, end, m);
      }
    };
    add_half(a, b);
    add_half(c, a);
  }

  void split_boundary() {
    std::vector<Vector3i> pieces;  // two vertices and the label
    for (Index e = 0; e < old_.boundary.cols(); ++e) {
      const int a = old_.boundary(0, e), b = old_.boundary(1, e),
                m = middle(a, b), label = old_.boundary_label[e];
      pieces.emplace_back(a, m < 0 ? b : m, label);
      if (m >= 0) pieces.emplace_back(m, b, label);
    }
    const auto n = static_cast<Index>(pieces.size());
    new_.boundary.resize(2, n);
    new_.boundary_label.resize(n);
    for (Index e = 0; e < n; ++e) {
      new_.boundary.col(e) = pieces[e].head<2>();
      new_.boundary_label[e] = pieces[e][2];
    }
  }

  const Mesh& old_;
  Mesh new_;
  std::map<std::pair<int, int>, int> middle_;  ///< of each halved edge
};

inline Mesh refined(const Mesh& mesh, const std::vector<int>& marked) {
  return Bisection(mesh, marked).mesh();
}

/// The triangles that have a corner within a distance of a point.
inline std::vector<int> triangles_near(const Mesh& mesh, const Vector2d& point,
                                       double distance) {
  std::vector<int> near;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    double closest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k)
      closest = std::min(closest, (mesh.corner(t, k) - point).norm());
    if (closest <= distance) near.push_back(t);
  }
  return near;
}

/// One triangle, counter-clockwise, its sides a b, b c and c a labelled in this order.
inline Mesh triangle(const Vector2d& a, const Vector2d& b, const Vector2d& c,
                     const std::array<int, 3>& labels) {
  Mesh mesh;
  mesh.vertices.resize(2, 3);
  mesh.vertices << a, b, c;
  mesh.cells.resize(3, 1);
  mesh.cells << 0, 1, 2;
  mesh.boundary.resize(2, 3);
  mesh.boundary << 0, 1, 2, 1, 2, 0;
  mesh.boundary_label.resize(3);
  mesh.boundary_label << labels[0], labels[1], labels[2];
  return mesh;
}

inline Mesh rotated(Mesh mesh, double angle) {
  mesh.vertices = Eigen::Rotation2Dd(angle).toRotationMatrix() * mesh.vertices;
  return mesh;
}

/// The mirror image x -> -x, with triangles turned back to counter-clockwise.
inline Mesh mirrored(Mesh mesh) {
  mesh.vertices.row(0) *= -1;
  mesh.cells.row(1).swap(mesh.cells.row(2));
  return mesh;
}

/// Two meshes as one body of two parts; labels of the second are raised by ten.
template <int dim>
SimplexMesh<dim> joined(const SimplexMesh<dim>& a, const SimplexMesh<dim>& b) {
  SimplexMesh<dim> both;
  both.vertices.resize(dim, a.vertices.cols() + b.vertices.cols());
  both.vertices << a.vertices, b.vertices;
  both.cells.resize(dim + 1, a.cells.cols() + b.cells.cols());
  both.cells << a.cells, b.cells.array() + a.vertex_count();
  both.boundary.resize(dim, a.boundary.cols() + b.boundary.cols());
  both.boundary << a.boundary, b.boundary.array() + a.vertex_count();
  both.boundary_label.resize(both.boundary.cols());
  both.boundary_label << a.boundary_label, b.boundary_label.array() + 10;
  return both;
}

/// Moved, locally refined around a random point and renumbered.
inline Mesh irregular(int nx, int ny, double width, double height,
                      std::mt19937& random) {
  const double cell = std::min(width / nx, height / ny);
  Mesh mesh = moved(rectangle(nx, ny, width, height), cell, 0.2, random);
  const Uniform part{0, 1};
  for (int level = 0; level < 2; ++level) {
    const Vector2d point(width * part(random), height * part(random));
    mesh = refined(mesh, triangles_near(mesh, point, 0.5 * cell));
  }
  return renumbered(mesh, random).mesh;
}

inline Mesh single_triangle(const CellCorners<2>& corners) {
  Mesh mesh;
  mesh.vertices = corners;
  mesh.cells = (Matrix3Xi(3, 1) << 0, 1, 2).finished();
  mesh.boundary = (Matrix2Xi(2, 3) << 1, 2, 0, 2, 0, 1).finished();
  mesh.boundary_label.setConstant(3, 1);
  return mesh;
}

}  // namespace ffcontact::test
