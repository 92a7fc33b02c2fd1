// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/interface/pairing/matching_faces.hpp"

namespace ffcontact {

/// What moves on a contact face, or on a polygon of it, by values at its corners that are
/// linear between them, one column each: w against the foundation or what the face faces.
///     depth  w . n - gap,    slip  n x (w - w_before)
/// are quadratic where normals turn, and n is not of unit length: |n x w| = |n| |w_t|.
struct FaceMotion {
  Matrix3Xd normal;        ///< n
  Matrix3Xd jump;          ///< w [mm]
  Matrix3Xd before;        ///< w_t of the load step before [mm]
  Eigen::RowVectorXd gap;  ///< [mm]

  Index corners() const { return jump.cols(); }
  /// At a corner, and by the polar form of the quadratics.
  double depth(Index k) const { return depth(k, k); }
  double depth(Index k, Index l) const;
  Vector3d slip(Index k, Index l) const;
  /// At a place by the weights of the corners.
  double depth_at(const Ref<const VectorXd>& place) const;
  Vector3d slip_at(const Ref<const VectorXd>& place) const;
};

/// On a face whose corners are all nodes, against a rigid foundation or a face that matches.
FaceMotion motion_on_face(const Facets<3>& faces, const ContactSurface& surface,
                          const ContactLaw<3>& law, int contact_face,
                          const MatchingFace& match,
                          const Ref<const VectorXd>& displacement);

/// On a polygon of the common refinement.
FaceMotion motion_on_polygon(const Facets<3>& faces,
                             const ContactSurface& surface,
                             const ContactLaw<3>& law,
                             const FacingPolygon& polygon,
                             const Ref<const VectorXd>& displacement);

/// What unit tractions at the corners of a triangle cost per area [mm]: int phi_i times depth,
/// slip, and |slip|, for which the Bernstein polynomial of the |slip(k, l)| stands: |.| is
/// convex, so that it is a bound.
struct FaceCosts {
  Vector3d depth, friction;
  Matrix3d slip;
};
/// @param corners   of the triangle
/// @param rounding  |slip| that is 0 [mm]
FaceCosts face_costs(const FaceMotion& motion, const Vector3i& corners,
                     double rounding);

/// The largest depth on a triangle, at least 0, and the corner that is deepest.
double deepest_on(const FaceMotion& motion, const Vector3i& corners);
int deepest_corner(const FaceMotion& motion, const Vector3i& corners);

/// How far two corners of a triangle must go along their normals, so that it keeps clear
/// between them: with depths -q_k, -q_l <= 0 and their polar form m it does where all sides
/// have m <= (q_k q_l)^(1/2) / 2, as sum psi_k^2 >= sum psi_k psi_l for psi_k = q_k^(1/2)
/// phi_k. m / (n_k . n_l + 1/2) does; 0 where none is needed.
/// @param alone  whether each of them must do without the other
double depth_between(const FaceMotion& motion, Index k, Index l, bool alone);

}  // namespace ffcontact
