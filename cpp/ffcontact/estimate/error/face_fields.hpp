// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/estimate/error/between_nodes.hpp"
#include "ffcontact/interface/contact_surface.hpp"

namespace ffcontact {

/// What is linear between the corners of a contact face, or of a part of it, one column a
/// corner.
struct FaceFields {
  Matrix3Xd normal;    ///< n, of any length between the nodes
  Matrix3Xd traction;  ///< r_hat [MPa]
  /// w_hat less the gap along n and the load step before [mm]
  Matrix3Xd motion;
  std::vector<FrictionCone> cone;
};

/// Directions, tractions and bounds c of |r_t|, which e takes linear, at the corners of a
/// contact face; no motions. A corner that is no node has those of one of the face's nodes.
/// @param cones     at all nodes [MPa]
/// @param traction  (r_n, r_t1, r_t2) at the corners [9]
FaceFields fields_on_face(const ContactSurface& surface,
                          const std::vector<FrictionCone>& cones,
                          int contact_face,
                          const Ref<const VectorXd>& traction);

/// f of BetweenNodes at the corners, at the quarters of the sides between neighbours, and in
/// the middle; and what the directions of the face's nodes turn by, below 1e-11 rounding
/// and 0.
void note(const FaceFields& fields, const Matrix3Xd& normals_of_nodes, int face,
          BetweenNodes& found);

}  // namespace ffcontact
