// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <sstream>
#include <utility>

#include "checks.hpp"
#include "ffcontact/base/eigen.hpp"

/// What the checks share: geometry, W and values on the mesh that an answer is given on.
namespace ffcontact::fuzz {

using Corners = Matrix<double, 2, 3>;
using EdgeKey = std::pair<int, int>;
inline EdgeKey key(int a, int b) { return std::minmax(a, b); }

inline double area_of(const Corners& x) {
  const Vector2d u = x.col(1) - x.col(0), v = x.col(2) - x.col(0);
  return (u.x() * v.y() - u.y() * v.x()) / 2;
}

/// Weights of the corners at a point.
inline Vector3d weights_at(const Corners& corners, const Vector2d& x) {
  Vector3d w;
  for (int k = 0; k < 3; ++k) {
    Corners part = corners;
    part.col(k) = x;
    w[k] = area_of(part);
  }
  return w / area_of(corners);
}

template <class... Parts>
Find finding(const char* check, const Parts&... parts) {
  std::ostringstream text;
  text.precision(6);
  ((text << parts), ...);
  return {check, text.str()};
}

/// Finds by rounding and gross ones have other causes.
inline const char* how_far(double defect) {
  return defect <= 1e-6 ? "little: " : "much: ";
}

/// Of a problem that has a solution.
template <class Solution>
Find unsolved(const Solution& solution) {
  return finding("unsolved",
                 how_far(std::max(solution.residual, solution.complementarity)),
                 in_words(solution.status), ", residual ", solution.residual,
                 ", violation ", solution.complementarity);
}

/// The largest of many values and where it was.
struct Largest {
  double value = 0;
  int place = -1;
  void note(double candidate, int where) {
    if (!(candidate <= value)) {  // NaN is the largest
      value = candidate;
      place = where;
    }
  }
};

/// How far forces f at places x are from what pushes a tool: force and, where it turns,
/// moment about its point, relative to all of them.
double missed_push(const RigidTool& tool, const Matrix2Xd& x,
                   const Matrix2Xd& f, double length);

/// The mesh and line of the estimate with the case's data on them.
struct Ground {
  const Mesh& mesh;
  const ContactLine& line;
  std::vector<int> region;
  std::vector<int> parent;  ///< triangle of the case
  /// at the nodes; slip_bound may be empty
  VectorXd friction, slip_bound, gap, previous;
  std::vector<char> prescribed;
};
Ground ground_of(const Assembled& parts, const Estimate<2>& estimate);

/// int psi_i psi_j over edges of given nodes and vertices.
Dense mass_of(const Mesh& mesh, const ContactLine& line);

/// (u_n - gap, u_t - previous) at the nodes.
Matrix2Xd against_foundation(const ContactLine& line, const VectorXd& gap,
                             const VectorXd& previous, const VectorXd& u);

/// C eps(u) of one triangle.
Vector3d stress_of(const Mesh& mesh, int triangle, const Matrix3d& C,
                   const VectorXd& u);

/// Largest displacement, given or found, or by which a load would move its dof alone:
/// what those that vanish are small against.
double displacement_scale(const Assembled& parts, const VectorXd& u);

/// Largest stress of a displacement, and of the loads; not below what rounding of
/// displacements makes of them.
double stress_scale(const Assembled& parts, const Ground& ground,
                    const VectorXd& u);

/// What e^2 may be off by where e is exactly 0: that says that stresses are below 1e-12
/// of the terms they are summed from.
double square_called_zero(const Assembled& parts, const Ground& ground,
                          const Estimate<2>& estimate);

Corners corners_at(const Mesh& mesh, int triangle);
/// Corners of subtriangle k: k+1, k+2, centroid.
Corners subtriangle(const Corners& corners, int k);

}  // namespace ffcontact::fuzz
