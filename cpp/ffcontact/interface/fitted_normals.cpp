// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/fitted_normals.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

/// Normals of faces that differ by less are those of one plane.
constexpr double one_plane = 1e-6;
/// Nodes beside one that determine what is fitted.
constexpr std::size_t enough_nodes = 14;
/// Terms of a plane and one that bends it.
constexpr int least_terms = 3;

/// Nodes and faces beside each node.
struct Beside {
  const SheetOfNodes& sheet;
  std::vector<std::set<int>> nodes;
  std::vector<std::vector<int>> faces;

  explicit Beside(const SheetOfNodes& all)
      : sheet(all), nodes(all.node_count()), faces(all.node_count()) {
    for (int m = 0; m < sheet.face_node.cols(); ++m)
      for (const int i : sheet.face_node.col(m)) {
        faces[i].push_back(m);
        for (const int j : sheet.face_node.col(m))
          if (j != i) nodes[i].insert(j);
      }
  }

  /// Two faces far, and farther where these are few.
  std::vector<int> around(int node) const {
    constexpr int least_rings = 2, most_rings = 4;
    std::set<int> found = nodes[node];
    for (int ring = 1; ring < most_rings; ++ring) {
      if (ring >= least_rings && found.size() > enough_nodes) break;
      for (const int j : std::vector<int>(found.begin(), found.end()))
        found.insert(nodes[j].begin(), nodes[j].end());
    }
    found.erase(node);
    return {found.begin(), found.end()};
  }

  bool on_rim(int node) const {
    return faces[node].size() < nodes[node].size();
  }

  /// How far the faces beside a node turn from its normal, on a rim also those beside its
  /// neighbours.
  double turn(int node) const {
    return on_rim(node) ? turn_around(node) : turn_of(faces[node], node);
  }
  double turn_around(int node) const {
    double largest = 0;
    for (const int j : nodes[node])
      largest = std::max(largest, turn_of(faces[j], node));
    return largest;
  }

 private:
  double turn_of(const std::vector<int>& some, int node) const {
    double largest = 0;
    for (const int m : some)
      largest = std::max(
          largest, (sheet.face_normal.col(m) - sheet.normal.col(node)).norm());
    return largest;
  }
};

/// Those of a quadric, then those of third order.
constexpr Index terms_of_quadric = 8;
using Terms = Eigen::RowVector<double, 12>;
Terms terms_at(const Vector3d& p) {
  const double x = p.x(), y = p.y(), z = p.z();
  return (Terms() << x, y, x * x, x * y, y * y, x * z, y * z, z * z, x * x * x,
          x * x * y, x * y * y, y * y * y)
      .finished();
}

/// The columns that are more than rounding, and that those before leave enough of; as many as
/// the rows determine.
std::vector<int> independent_columns(const MatrixXd& A) {
  constexpr double enough = 0.01, rounding = 1e-5;
  constexpr Index spare_rows = 2;
  MatrixXd Q(A.rows(), 0);
  std::vector<int> kept;
  for (int j = 0; j < A.cols() && Q.cols() + spare_rows < A.rows(); ++j) {
    VectorXd rest = A.col(j);
    for (int pass = 0; pass < 2; ++pass)
      rest -= Q * (Q.transpose() * rest).eval();
    if (!(rest.norm() >
          std::max(enough * A.col(j).norm(), rounding * A.col(0).norm())))
      continue;
    Q.conservativeResize(Eigen::NoChange, Q.cols() + 1);
    Q.rightCols<1>() = rest.normalized();
    kept.push_back(j);
  }
  return kept;
}

/// Slopes of the heights z of points (x, y, z) at the origin.
Vector2d slopes_of(const Matrix3Xd& points, bool on_rim) {
  const double size = points.colwise().norm().mean();
  MatrixXd A(points.cols(), Terms::ColsAtCompileTime);
  VectorXd z(points.cols());
  for (Index k = 0; k < points.cols(); ++k) {
    const Vector3d p = points.col(k) / size;
    const double weight = 1 / p.norm();
    A.row(k) = weight * terms_at(p);
    z[k] = weight * p.z();
  }
  if (on_rim) A.conservativeResize(Eigen::NoChange, terms_of_quadric);
  const std::vector<int> kept = independent_columns(A);
  Vector2d slopes = Vector2d::Zero();
  if (count_of(kept) < least_terms || kept[1] != 1) return slopes;
  const VectorXd fitted = A(Eigen::all, kept).eval().householderQr().solve(z);
  return fitted.head<2>();
}

Vector3d fitted_normal(const SheetOfNodes& sheet, int node,
                       const std::vector<int>& around, bool on_rim) {
  Matrix3d frame;  // two tangents and n
  frame.col(2) = sheet.normal.col(node);
  frame.col(0) = frame.col(2).unitOrthogonal();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  const Matrix3Xd along =
      sheet.place(Eigen::all, around).colwise() - sheet.place.col(node);
  const Vector2d slopes = slopes_of(frame.transpose() * along, on_rim);
  return (frame.col(2) - frame.leftCols<2>() * slopes).normalized();
}

}  // namespace

Matrix3Xd fitted_normals(const SheetOfNodes& sheet) {
  const Beside beside(sheet);
  Matrix3Xd normals = sheet.normal;
  for (int i = 0; i < sheet.node_count(); ++i) {
    if (beside.turn(i) < one_plane) continue;
    const Vector3d n =
        fitted_normal(sheet, i, beside.around(i), beside.on_rim(i));
    if ((n - sheet.normal.col(i)).norm() <= beside.turn_around(i))
      normals.col(i) = n;
  }
  return normals;
}

}  // namespace ffcontact
