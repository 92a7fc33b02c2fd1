// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/interface/contact_surface.hpp"

namespace ffcontact {

/// A polygon of the common refinement of bonded surfaces, seen from the body that follows: the
/// part of one of its faces that faces a part of a face of the other one.
struct FollowingPart {
  int face, followed;  ///< facets of the mesh
  Matrix3Xd place;     ///< corners on the face, barycentric [3 x k]
  /// where the vertices of the face lie on the plane of the other one, barycentric: what the
  /// other one does is linear, and goes on there
  Matrix3d followed_place;
  bool is_covered = false;  ///< does all of the face follow?

  /// The local vertex of the face that a corner is, -1 for none.
  int vertex_at(Index corner) const;
  /// That of which a corner is on the opposite side, -1 for none.
  int vertex_across(Index corner) const;
  /// h = u(y) - u(x) at the vertices x of the face, as it goes on from the polygon, one column
  /// each [mm].
  Matrix3d jumps(const Facets<3>& faces,
                 const Ref<const VectorXd>& displacement) const;
};

/// Of surfaces that hang together one body follows: that whose faces are all covered by the
/// other one's, and if both are that with more faces, which can follow the other one better;
/// the body that carries the multipliers if neither is. None on a rigid foundation.
std::vector<FollowingPart> following_parts(const Facets<3>& faces,
                                           const ContactSurface& surface);

}  // namespace ffcontact
