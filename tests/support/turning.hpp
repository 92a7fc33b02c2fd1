// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "ffcontact/base/plane.hpp"
#include "ffcontact/contact/law/contact_densities.hpp"
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
