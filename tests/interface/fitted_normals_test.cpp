// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/fitted_normals.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A place on a surface and the normal there by two parameters in (0, 1).
struct Place {
  Vector3d x, n;
};
using Surface = std::function<Place(double, double)>;

Place on_sphere(double s, double t) {
  const double a = s - 0.5, b = t - 0.5;
  const Vector3d n(std::sin(a) * std::cos(b), std::sin(b),
                   -std::cos(a) * std::cos(b));
  return {10 * n, n};
}
Place on_cylinder(double s, double t) {
  const double a = 1.5 * (s - 0.5);
  const Vector3d n(std::sin(a), 0, -std::cos(a));
  return {10 * n + Vector3d(0, 8 * t, 0), n};
}
/// z = x^2/20 - x^2 y/400 + y^2/60, seen from below.
Place on_saddle(double s, double t) {
  const double x = 10 * (s - 0.4), y = 10 * (t - 0.6);
  return {
      {x, y, x * x / 20 - x * x * y / 400 + y * y / 60},
      Vector3d(x / 10 - x * y / 200, -x * x / 400 + y / 30, -1).normalized()};
}

/// k x k cells in two triangles each whose vertices are at random within a fifth of a cell,
/// with the means of the faces' normals by their areas.
SheetOfNodes sheet_on(const Surface& surface, int k, int rows, Random& random) {
  SheetOfNodes sheet;
  sheet.place.resize(3, (k + 1) * (rows + 1));
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= k; ++i) {
      const Vector2d shift = 0.2 * random_vector(2, random);
      const auto at = [](double place, int cells, double by) {
        const bool inside = place > 0 && place < cells;
        return (place + (inside ? by : 0)) / cells;
      };
      sheet.place.col(i + (k + 1) * j) =
          surface(at(i, k, shift[0]), at(j, rows, shift[1])).x;
    }
  sheet.face_node.resize(3, 2 * k * rows);
  for (int j = 0, m = 0; j < rows; ++j)
    for (int i = 0; i < k; ++i) {
      const int a = i + (k + 1) * j, b = a + 1, c = a + k + 1, d = c + 1;
      sheet.face_node.col(m++) << a, c, b;
      sheet.face_node.col(m++) << b, c, d;
    }
  sheet.face_normal.resize(3, sheet.face_node.cols());
  sheet.normal = Matrix3Xd::Zero(3, sheet.place.cols());
  for (Index m = 0; m < sheet.face_node.cols(); ++m) {
    const Matrix3d x = sheet.place(Eigen::all, sheet.face_node.col(m));
    const Vector3d along = x.col(1) - x.col(0),
                   vector = along.cross(x.col(2) - x.col(0));
    sheet.face_normal.col(m) = vector.normalized();
    for (const int i : sheet.face_node.col(m)) sheet.normal.col(i) += vector;
  }
  sheet.normal.colwise().normalize();
  return sheet;
}

/// The largest angle between normals and those of the nearest places, by Newton's method.
double largest_off(const Surface& surface, const SheetOfNodes& sheet,
                   const Matrix3Xd& normals) {
  double largest = 0;
  for (int i = 0; i < sheet.node_count(); ++i) {
    double s = 0.5, t = 0.5;
    for (int step = 0; step < 30; ++step) {
      constexpr double h = 1e-6;
      const Vector3d x = surface(s, t).x;
      Matrix<double, 3, 2> J;
      J << (surface(s + h, t).x - x) / h, (surface(s, t + h).x - x) / h;
      const Vector2d change = (J.transpose() * J).inverse() * J.transpose() *
                              (sheet.place.col(i) - x);
      s += change[0];
      t += change[1];
    }
    largest = std::max(largest, (normals.col(i) - surface(s, t).n).norm());
  }
  return largest;
}

TEST(FittedNormals, are_exact_on_quadrics) {
  Random random(3);
  for (const Surface& surface : {Surface(on_sphere), Surface(on_cylinder)}) {
    const SheetOfNodes sheet = sheet_on(surface, 8, 8, random);
    EXPECT_GT(largest_off(surface, sheet, sheet.normal), 0.05);
    EXPECT_LT(largest_off(surface, sheet, fitted_normals(sheet)), 1e-9);
  }
}

TEST(FittedNormals, are_accurate_to_higher_order) {
  Random random(3);
  double coarse = 0, fine = 0;
  for (const int k : {8, 16}) {
    const SheetOfNodes sheet = sheet_on(on_saddle, k, k, random);
    const double mean = largest_off(on_saddle, sheet, sheet.normal),
                 fitted = largest_off(on_saddle, sheet, fitted_normals(sheet));
    EXPECT_LT(fitted, 0.3 * mean);
    (k == 8 ? coarse : fine) = fitted;
  }
  EXPECT_LT(fine, 0.3 * coarse);
}

/// One and two rows of a strip say nothing of what is quadratic along it.
TEST(FittedNormals, of_a_strip_of_a_cylinder) {
  Random random(3);
  for (const int rows : {1, 2}) {
    const SheetOfNodes sheet = sheet_on(on_cylinder, 12, rows, random);
    EXPECT_LT(largest_off(on_cylinder, sheet, fitted_normals(sheet)),
              0.2 * largest_off(on_cylinder, sheet, sheet.normal));
  }
}

/// Where a plane goes on as a cylinder its vertices keep its normal.
TEST(FittedNormals, of_planes_stay) {
  Random random(3);
  const Surface blend = [](double s, double t) -> Place {
    const double a = std::max(0.0, s - 0.5);
    const Vector3d n(std::sin(a), 0, -std::cos(a));
    return {
        Vector3d(10 * std::min(s, 0.5) + 10 * n.x(), 8 * t, 10 * n.z() + 10),
        n};
  };
  const SheetOfNodes sheet = sheet_on(blend, 12, 6, random);
  const Matrix3Xd normals = fitted_normals(sheet);
  int flat = 0;
  for (int i = 0; i < sheet.node_count(); ++i) {
    if (sheet.place(0, i) > 4) continue;
    const Vector3d turn = normals.col(i) - sheet.normal.col(i);
    EXPECT_LT(turn.norm(), 1e-3);  // on the rim not less
    if (turn.isZero(0)) ++flat;
  }
  EXPECT_GT(flat, 20);
}

TEST(FittedNormals, of_few_nodes_stay) {
  Random random(3);
  const SheetOfNodes sheet = sheet_on(on_cylinder, 1, 1, random);
  EXPECT_EQ(fitted_normals(sheet), sheet.normal);
}

}  // namespace
}  // namespace ffcontact
