// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"

namespace ffcontact {

/// A contact face, its law and its displacement w against what it faces, for tractions
/// r_hat that are linear on it: (r_n, r_t1, r_t2) at its vertices, one column each [MPa].
struct ContactFace {
  int face;               ///< of the mesh
  int surface_face = -1;  ///< of the contact surface
  /// the mesh face of another body that matches it and feels the opposite traction, or -1
  int opposite = -1;
  Vector3i opposite_corner;          ///< which its corners face
  double area;                       ///< [mm^2]
  std::array<Matrix3d, 3> frame;     ///< columns n, t1, t2 at its vertices
  std::array<FrictionCone, 3> cone;  ///< of tractions there
  /// of what e pays there, which is wider where friction is bounded (bounded_friction)
  std::array<FrictionCone, 3> paid;
  Matrix3d work;  ///< int phi_i w along n, t1, t2, one column a vertex [mm^3]
  Vector3d slip;  ///< int phi_i |w_t|, |w_t| linear between the vertices [mm^3]
  Matrix<double, 2, 3> direction;  ///< w_t / |w_t| at the vertices, or 0
};

/// What r_hat on the face adds to e^2 / 2 [N mm]:
///     sum over the vertices of c_i int phi_i |w_t| + r_i . int phi_i w,   c the bound of |r_t|   [CHH01, (2.11), (2.19)]
/// With c, |w_t|, r and w linear between the vertices this is the integral of c |w_t| + r
/// . w; |w_t| is convex, so that it is a bound.
double contact_term(const ContactFace& face, const Matrix3d& traction);

/// Without the components of contact faces, and of those that match them: what relaxation
/// leaves alone.
KnownComponents without_contact(KnownComponents known,
                                const std::vector<ContactFace>& contact);

/// Tractions of given moments, and moments of given tractions.
Matrix3d traction_of(const ContactFace& face, const Matrix3d& moments);
Matrix3d moments_of(const ContactFace& face, const Matrix3d& traction);

/// Largest of r_n and |r_t| less its bound at the vertices [MPa]; 0 in the cone, and with
/// it on all of the face: the cones are convex and their bounds concave.
double cone_violation(const ContactFace& face, const Matrix3d& traction);

}  // namespace ffcontact
