// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "ffcontact/interface/contact_surface.hpp"
#include "ffcontact/interface/face_quadratic.hpp"

namespace ffcontact {

/// The functions that carry nodal values on one contact face: the hat of each corner that
/// is a node, and equal shares of those that are none,
///     chi_a = sum over the corners of hat(k, a) phi_k,   sum chi_a = 1.
/// Linear between values in a convex set is in it.
struct FaceHats {
  std::vector<int> node;  ///< one to three
  Matrix3Xd hat;          ///< one column each
};
FaceHats face_hats(const ContactSurface& surface, int contact_face);

/// Do the normals of a face's nodes differ, as on a curved surface?
bool normals_differ(const ContactSurface& surface, int contact_face);
/// Do they on any?
bool turns(const ContactSurface& surface);

/// A traction along directions that turn over a contact face, or over a part of it,
///     r = r_n n + n x m,   m = r_t x n,
/// by its values at the corners, linear between them, one column each. n is not of unit
/// length between the nodes: |n x m| <= |n| |m| and |r . n| = |r_n| |n|^2, so that r is in the
/// cone |r_t| <= mu |r_n| about n at every place where |m| <= mu |r_n|, which linear m and r_n
/// keep that do at the corners. Where n does not turn this is the linear r_n n + r_t.
struct BentTraction {
  Matrix3Xd normal;             ///< n
  Eigen::RowVectorXd pressing;  ///< r_n [MPa]
  Matrix3Xd turned;             ///< m [MPa]

  /// The same between other corners, at these places of it.
  BentTraction between(const Ref<const Matrix3Xd>& places) const {
    return {normal * places, pressing * places, turned * places};
  }
};

/// Of (r_n, r_t1, r_t2) at the nodes [MPa, 3 x p], at the three corners of a contact face.
BentTraction bent_traction(const ContactSurface& surface, int contact_face,
                           const Ref<const Matrix3Xd>& traction);
/// @param frames   n, t1, t2 at the corners of a face
/// @param corners  (r_n, r_t1, r_t2) there
BentTraction bent_traction(const std::array<Matrix3d, 3>& frames,
                           const Matrix3d& corners);

/// r along x, y, z on the triangle of three corners.
QuadraticOnFace along_axes(const BentTraction& traction);

/// What a quadratic traction R on a contact face does to one mesh face: with the hats of its
/// three vertices the moments are the columns of R weight. On its own face weight = int
/// phi_k phi_l phi', over what faces the opposite body; on a face of that body it is -int
/// phi_k phi_l eta' over the polygons that they share, eta its barycentric coordinates: both
/// bodies feel the same forces, in opposite directions.
struct TractionPart {
  int contact_face;
  int face;                     ///< of the mesh
  Matrix<double, 9, 3> weight;  ///< [mm^2]
};
std::vector<TractionPart> traction_parts(const SolidMesh& mesh,
                                         const Facets<3>& faces,
                                         const ContactSurface& surface);

/// The polygons and the parts of each contact face.
struct FacePolygons {
  std::vector<std::vector<const FacingPolygon*>> polygons;
  std::vector<std::vector<TractionPart>> parts;

  /// @param surface  stays where it is
  FacePolygons(const SolidMesh& mesh, const Facets<3>& faces,
               const ContactSurface& surface);
  /// Do polygons have all of a face, once?
  bool cover(int contact_face) const;
};

/// The triangles of a polygon from its first corner: three of its corners each, and the
/// part of its face's area that they have.
/// @param corners  barycentric [3 x k]
struct FanTriangle {
  Vector3i corner;
  double share;
};
std::vector<FanTriangle> fan_of(const Ref<const Matrix3Xd>& corners);
/// The part of its face's area that the polygon has.
double share_of(const Ref<const Matrix3Xd>& corners);

}  // namespace ffcontact
