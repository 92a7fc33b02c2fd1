// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/surface_supports.hpp"

#include <algorithm>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/checks/held_apart.hpp"
#include "ffcontact/contact/law/gaps_in_reach.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Penetrations of prescribed vertices below this part of the displacements are rounding.
constexpr double penetration_of_rounding = 1e-10;

/// Motions along a direction below this are rounding.
constexpr double no_motion = 1e-6;

/// What prescribed dofs alone make of v, 0 where a free one takes part [3 x p].
Matrix3Xd given_motions(const ContactSurface& surface, const ContactLaw<3>& law,
                        const ElasticSystem& system) {
  Matrix3Xd v =
      displacement_against_foundation(surface, law, system.prescribed_value);
  for (int i = 0; i < surface.node_count(); ++i) {
    const Matrix3d frame = surface.frame(i);
    const auto leave_out = [&](int vertex, double weight) {
      const Matrix3Xd free =
          weight * frame.transpose() * free_axes<3>(vertex, system.prescribed);
      for (int c = 0; c < 3; ++c)
        if (free.row(c).norm() > no_motion) v(c, i) = 0;
    };
    leave_out(surface.vertex[i], 1);
    visit_opposite(surface, i, leave_out);
  }
  return v;
}

/// How deep a node that supports hold is in what it faces, if what is free there moves as
/// that which moves away most of what supports hold; 0 where all is free.
double held_depth(const ContactSurface& surface, const ContactLaw<3>& law,
                  const ElasticSystem& system, int node) {
  const Vector3d n = surface.normal.col(node);
  const auto along_n = [&](int vertex) {
    return vector_at<3>(system.prescribed_value, vertex).dot(n);
  };
  double held = 0, followed = 0, farthest = -infinity;
  visit_opposite(surface, node, [&](int vertex, double weight) {
    const Matrix3Xd axes = free_axes<3>(vertex, system.prescribed);
    if ((n.transpose() * axes).norm() > no_motion) return;
    held += weight;
    followed += weight * along_n(vertex);
    farthest = std::max(farthest, along_n(vertex));
  });
  const double depth =
      along_n(surface.vertex[node]) - (law.gap.size() > 0 ? law.gap[node] : 0);
  if (!surface.against_a_body()) return depth;
  return held == 0 ? 0 : depth - followed - (1 - held) * farthest;
}

/// @throws std::invalid_argument  if prescribed dofs hold a bonded vertex off what it faces
void require_together(const SolidMesh& mesh, const ContactSurface& surface,
                      const ContactLaw<3>& law, const ElasticSystem& system,
                      double least) {
  if (!law.has_bonded()) return;
  const Matrix3Xd given = given_motions(surface, law, system);
  for (int i = 0; i < surface.node_count(); ++i)
    if (const double apart = given.col(i).norm();
        law.is_bonded(i) && apart > least)
      refuse_held_apart(apart, in_words(mesh.place(surface.vertex[i])));
}

}  // namespace

void require_feasible(const SolidMesh& mesh, const ContactSurface& surface,
                      const ContactLaw<3>& law, const ElasticSystem& system,
                      const Flags& held) {
  const ContactLaw<3> near =
      with_gaps_in_reach(law, mesh, system.prescribed_value);
  const double least = penetration_of_rounding *
                       largest_displacement(near, system.prescribed_value);
  require_together(mesh, surface, near, system, least);
  for (int i = 0; i < surface.node_count(); ++i) {
    if (law.is_bonded(i)) continue;
    const double depth = held[3 * i] ? held_depth(surface, near, system, i) : 0;
    if (depth > least)
      refuse(
          "no admissible displacement: prescribed displacements hold vertex ",
          surface.vertex[i], " ", in_words(mesh.place(surface.vertex[i])), " ",
          depth,
          " inside the foundation; prescribe less there, or a larger gap=");
  }
}

}  // namespace ffcontact
