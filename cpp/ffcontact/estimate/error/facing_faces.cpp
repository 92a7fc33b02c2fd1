// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/facing_faces.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/law/bounded_friction.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/estimate/error/contact_faces.hpp"
#include "ffcontact/estimate/error/face_motion.hpp"

namespace ffcontact {

DensityOfCorners density_by_corners(const ContactFacet<3>& face) {
  DensityOfCorners density;
  for (int column = 0; column < 9; ++column) {
    Matrix3d unit = Matrix3d::Zero();
    unit(column % 3, column / 3) = 1;
    density.col(column) =
        along_axes(bent_traction(face.frame, unit)).reshaped();
  }
  return density;
}

namespace {

/// The moments by (r_n, r_t1, r_t2) at the corners.
Matrix9d moments_by_corners(const DensityOfCorners& density,
                            const Matrix<double, 9, 3>& weight) {
  Matrix9d moments;
  for (int column = 0; column < 9; ++column)
    moments.col(column) =
        (density.col(column).reshaped(3, 9) * weight).reshaped();
  return moments;
}

/// Sums over the triangles of the polygons of a face.
void put_motions(const Facets<3>& faces, const ContactSurface& surface,
                 const ContactLaw<3>& law,
                 const std::vector<const FacingPolygon*>& polygons,
                 const Ref<const VectorXd>& displacement, double least,
                 double rounding, ContactFacet<3>& face) {
  FaceCosts sum{Vector3d::Zero(), Vector3d::Zero(), Matrix3d::Zero()};
  for (const FacingPolygon* polygon : polygons) {
    const FaceMotion motion =
        motion_on_polygon(faces, surface, law, *polygon, displacement);
    for (const FanTriangle& triangle : fan_of(polygon->own)) {
      const FaceCosts costs = face_costs(motion, triangle.corner, rounding);
      const Matrix3d place = face.measure * triangle.share *
                             polygon->own(Eigen::all, triangle.corner);
      sum.depth += place * costs.depth;
      sum.friction += place.cwiseMax(0) * costs.friction;
      sum.slip += costs.slip * place.transpose();
    }
  }
  face.slip = sum.friction;
  for (int i = 0; i < 3; ++i) {
    const auto along = face.frame[i].rightCols<2>().transpose();
    // r_t . w_t of m = r_t x n:  -m . slip = r_t . (slip x n)
    const Vector2d slid =
        along * Vector3d(sum.slip.col(i)).cross(face.frame[i].col(0));
    face.work.col(i) << sum.depth[i], slid;
    face.direction.col(i).setZero();
    if (slid.norm() > least * face.measure)
      face.direction.col(i) = slid.normalized();
  }
}

/// At all nodes.
struct Cones {
  std::vector<FrictionCone> of_tractions, paid;
};

/// The frames, cones and parts of a face.
ContactFacet<3> facing_face(const SolidMesh& mesh, const Facets<3>& faces,
                            const ContactSurface& surface,
                            const ContactLaw<3>& law, const Cones& cones, int m,
                            const std::vector<TractionPart>& parts) {
  ContactFacet<3> face;
  face.facet = surface.face[m];
  face.index = m;
  face.opposite_corner.setZero();
  face.measure = facet_measure(mesh, faces, face.facet);
  for (int i = 0; i < 3; ++i) {
    const int node = surface.face_node(i, m);
    face.frame[i] = surface.frame(node);
    face.cone[i] = cones.of_tractions[node];
    if (!law.is_bonded(node))
      face.paid[i] = paid_cone(surface, m, cones.paid[node]);
  }
  const DensityOfCorners density = density_by_corners(face);
  for (const TractionPart& part : parts) {
    const Matrix9d moments = moments_by_corners(density, part.weight);
    if (part.face == face.facet) {
      face.moments_of_bent = moments;
      face.bent_of_moments = moments.inverse();
    } else {
      face.facing.push_back({part.face, moments});
    }
  }
  return face;
}

/// Friction without bound costs what no relaxation gains.
bool may_be_relaxed(const ContactSurface& surface, const ContactLaw<3>& law) {
  return surface.against_a_body() && !law.layer.given() &&
         (law.friction.size() == 0 || law.friction.maxCoeff() <= most_friction);
}

}  // namespace

std::vector<ContactFacet<3>> facing_faces(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const ContactLaw<3>& law,
    const Ref<const VectorXd>& displacement) {
  std::vector<ContactFacet<3>> facing;
  if (!may_be_relaxed(surface, law)) return facing;
  const std::vector<MatchingFace> matches =
      matching_faces(mesh, faces, surface);
  const FacePolygons of(mesh, faces, surface);
  const Cones cones{traction_cones(law), law_cones(law)};
  const double least = least_motion * largest_displacement(law, displacement),
               rounding = rounding_of_slip(law, displacement);
  for (int m = 0; m < surface.face_count(); ++m) {
    if (matches[m].face >= 0 || surface.face_node.col(m).minCoeff() < 0 ||
        !of.cover(m))
      continue;
    ContactFacet<3> face =
        facing_face(mesh, faces, surface, law, cones, m, of.parts[m]);
    face.work.setZero();
    face.slip.setZero();
    face.direction.setZero();
    if (!law.is_bonded(surface.face_node(0, m)))
      put_motions(faces, surface, law, of.polygons[m], displacement, least,
                  rounding, face);
    facing.push_back(std::move(face));
  }
  return facing;
}

}  // namespace ffcontact
