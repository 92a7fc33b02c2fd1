// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "ffcontact/base/plane.hpp"
#include "ffcontact/contact/law/contact_densities.hpp"
#include "ffcontact/interface/contact_surface.hpp"
#include "support/random.hpp"

/// Contact lines whose directions turn along their edges, and what is between the nodes.
namespace ffcontact::test {

/// Each direction turned by up to this angle.
inline ContactLine turned_at_random(ContactLine line, double most,
                                    Random& random) {
  const VectorXd angle = most * random_vector(line.node_count(), random);
  for (int i = 0; i < line.node_count(); ++i)
    line.normal.col(i) =
        Eigen::Rotation2Dd(angle[i]).toRotationMatrix() * line.normal.col(i);
  return line;
}

/// Each normal of a surface turned by up to this angle.
inline ContactSurface turned_at_random(ContactSurface surface, double most,
                                       Random& random) {
  for (int i = 0; i < surface.node_count(); ++i) {
    const Vector3d axis = random_vector(3, random);
    const double angle = most * random_vector(1, random)[0];
    surface.normal.col(i) =
        Eigen::AngleAxisd(angle, axis.normalized()) * surface.normal.col(i);
  }
  return surface;
}

/// Points of a triangle and their weights: Radon's seven, exact for polynomials of degree 5.
struct TrianglePoint {
  Vector3d at;
  double weight;
};
inline std::vector<TrianglePoint> points_of_triangle() {
  const double root = std::sqrt(15.0);
  std::vector<TrianglePoint> points{{Vector3d::Constant(1.0 / 3), 9.0 / 40}};
  for (const double sign : {-1.0, 1.0})
    for (int k = 0; k < 3; ++k) {
      Vector3d at = Vector3d::Constant((6 + sign * root) / 21);
      at[k] = (9 - 2 * sign * root) / 21;
      points.push_back({at, (155 + sign * root) / 1200});
    }
  return points;
}

/// n(s) and t(s), one column each, linear between the nodes.
inline Matrix2d frame_at(const ContactLine& line, int e, double s) {
  return (1 - s) * line.frame(line.edge_node(0, e)) +
         s * line.frame(line.edge_node(1, e));
}

/// r(s) = r_n(s) n(s) + r_t(s) t(s).
inline Vector2d traction_at(const ContactLine& line, const ContactDensities& r,
                            int e, double s) {
  return frame_at(line, e, s) *
         Vector2d(between(r.normal(0, e), r.normal(1, e), s),
                  between(r.tangential(0, e), r.tangential(1, e), s));
}

/// (w . n(s) - gap, w . t(s)) of a displacement.
inline Vector2d motion_at(const ContactLine& line, const VectorXd& gap,
                          const VectorXd& displacement, int e, double s) {
  const int i = line.edge_node(0, e), j = line.edge_node(1, e);
  const Vector2d w = (1 - s) * jump_at(line, i, displacement) +
                     s * jump_at(line, j, displacement);
  Vector2d motion = frame_at(line, e, s).transpose() * w;
  if (gap.size() > 0) motion[0] -= between(gap[i], gap[j], s);
  return motion;
}

}  // namespace ffcontact::test
