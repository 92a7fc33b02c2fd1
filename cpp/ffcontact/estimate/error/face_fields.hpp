// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/estimate/error/between_nodes.hpp"
#include "ffcontact/estimate/error/face_motion.hpp"
#include "ffcontact/estimate/tractions/surface_tractions.hpp"
#include "ffcontact/interface/traction_parts.hpp"

namespace ffcontact {

/// r_hat on a surface: on its faces, and before its relaxation at the nodes.
struct TractionFields {
  const Matrix3Xd& nodal;            ///< [MPa, 3 x p]
  const SurfaceTractions& on_faces;  ///< [MPa, 9 x m]
};

/// r_hat and its bounds c of |m|, which e takes linear, at the corners of a contact face: those
/// of the face where all of them are nodes, and else of its nodes.
struct BoundedTraction {
  BentTraction traction;
  Eigen::RowVectorXd bound;  ///< [MPa]

  /// @param places  rounding of them is none of a large bound
  BoundedTraction between(const Ref<const Matrix3Xd>& places) const {
    return {traction.between(places), bound * places.cwiseMax(0)};
  }
};
/// @param cones  of the law at all nodes
BoundedTraction traction_on_face(const ContactSurface& surface,
                                 const std::vector<FrictionCone>& cones,
                                 int contact_face, const TractionFields& r);
BentTraction bent_on_face(const ContactSurface& surface, int contact_face,
                          const TractionFields& r);

/// The cone by which e pays for |n x w| in place of |w_t| = |n x w| / |n| on a face: |n| cancels
/// against that of |r . n| in Coulomb's bound; for bounds that are given the least |n| counts.
FrictionCone paid_cone(const ContactSurface& surface, int contact_face,
                       FrictionCone cone);

/// f of BetweenNodes,
///     f = c |n x w| - m . (n x w) + r_n (w . n - gap),
/// at the corners of a face or of a part of it, at the quarters of the sides between
/// neighbours, and in the middle; and what the directions of the face's nodes turn by, if that
/// is 90 degrees or more.
void note(const BoundedTraction& r, const FaceMotion& motion,
          const Matrix3Xd& normals_of_nodes, int face, BetweenNodes& found);

}  // namespace ffcontact
