// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/contact_faces.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/estimate/error/face_fields.hpp"
#include "ffcontact/estimate/tractions/cone_projection.hpp"
#include "ffcontact/interface/traction_parts.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Tractions nearer to the cone than this part of the largest are in it but for rounding.
constexpr double traction_rounding = 2e-12;

/// @param least     |w_t| without direction [mm]
/// @param rounding  |w_t| that is 0
void put_motion(const FaceMotion& motion, double least, double rounding,
                ContactFacet<3>& face) {
  const FaceCosts costs = face_costs(motion, {0, 1, 2}, rounding);
  face.slip = face.measure * costs.friction;
  for (int i = 0; i < 3; ++i) {
    const Vector3d n = motion.normal.col(i), slip = motion.slip(i, i);
    const auto along = face.frame[i].rightCols<2>().transpose();
    // r_t . w_t of m = r_t x n:  -m . slip = r_t . (slip x n)
    face.work(0, i) = face.measure * costs.depth[i];
    face.work.col(i).tail<2>() =
        face.measure * along * Vector3d(costs.slip.col(i)).cross(n);
    face.direction.col(i).setZero();
    if (slip.norm() > least)
      face.direction.col(i) = along * slip.cross(n) / slip.norm();
  }
}

/// Of bonded bodies, between which nothing moves.
void put_rest(ContactFacet<3>& face) {
  face.work.setZero();
  face.slip.setZero();
  face.direction.setZero();
}

/// Moments of tractions that turn with the directions, and back.
void bend(ContactFacet<3>& face) {
  face.moments_of_bent.resize(9, 9);
  for (int column = 0; column < 9; ++column) {
    Matrix3d unit = Matrix3d::Zero();
    unit(column % 3, column / 3) = face.measure;
    face.moments_of_bent.col(column) =
        (along_axes(bent_traction(face.frame, unit)) * triple_products())
            .reshaped();
  }
  face.bent_of_moments = face.moments_of_bent.inverse();
}

}  // namespace

std::vector<ContactFacet<3>> contact_faces(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const ContactLaw<3>& law,
    const Ref<const VectorXd>& displacement) {
  const bool between_bodies = surface.against_a_body();
  const std::vector<MatchingFace> matches =
      matching_faces(mesh, faces, surface);
  const std::vector<FrictionCone> cones = traction_cones(law),
                                  paid = law_cones(law);
  const double least = least_motion * largest_displacement(law, displacement),
               rounding = rounding_of_slip(law, displacement);
  std::vector<ContactFacet<3>> contact;
  for (int m = 0; m < surface.face_count(); ++m) {
    const Vector3i nodes = surface.face_node.col(m);
    if (nodes.minCoeff() < 0 || (between_bodies && matches[m].face < 0))
      continue;
    const bool bonded = law.is_bonded(nodes[0]);
    ContactFacet<3> face;
    face.facet = surface.face[m];
    face.index = m;
    face.opposite = matches[m].face;
    face.opposite_corner = matches[m].corner;
    face.measure = facet_measure(mesh, faces, face.facet);
    for (int i = 0; i < 3; ++i) {
      face.frame[i] = surface.frame(nodes[i]);
      face.cone[i] = cones[nodes[i]];
      if (!bonded) face.paid[i] = paid_cone(surface, m, paid[nodes[i]]);
    }
    if (normals_differ(surface, m)) bend(face);
    if (bonded)
      put_rest(face);
    else
      put_motion(
          motion_on_face(faces, surface, law, m, matches[m], displacement),
          least, rounding, face);
    contact.push_back(face);
  }
  return contact;
}

VectorXi surface_faces(const std::vector<ContactFacet<3>>& contact) {
  VectorXi places(count_of(contact));
  for (int m = 0; m < places.size(); ++m) places[m] = contact[m].index;
  return places;
}

SurfaceTractions tractions_of(const std::vector<ContactFacet<3>>& contact,
                              const FaceMoments& moments) {
  SurfaceTractions tractions(9, contact.size());
  if (contact.empty()) return tractions;
  for (std::size_t m = 0; m < contact.size(); ++m) {
    tractions.col(m) = traction_on<3>(contact[m], moments).reshaped();
  }
  const double rounding = traction_rounding * max_norm(tractions);
  for (std::size_t m = 0; m < contact.size(); ++m)
    for (int i = 0; i < 3; ++i) {
      auto r = tractions.col(m).segment<3>(3 * i);
      const Vector3d nearest = cone_projection(contact[m].cone[i], r).point;
      if (max_norm(nearest - r) <= rounding) r = nearest;
    }
  return tractions;
}

void put_moments(const std::vector<ContactFacet<3>>& contact,
                 const SurfaceTractions& tractions, FaceMoments& moments) {
  for (std::size_t m = 0; m < contact.size(); ++m) {
    const ContactFacet<3>& face = contact[m];
    const Vector9d own = moments_of<3>(face, of_face(tractions, m)).reshaped() +
                         face.beside,
                   change = own - moments.col(face.facet);
    const Matrix3d before = traction_on<3>(face, moments);
    moments.col(face.facet) = own;
    for (const FacingPart<3>& part : face.facing)
      moments.col(part.facet) +=
          part.moments * (of_face(tractions, m) - before).reshaped();
    for (int k = 0; k < 3 && face.opposite >= 0; ++k)
      moments.col(face.opposite).segment<3>(3 * face.opposite_corner[k]) -=
          change.segment<3>(3 * k);
  }
}

}  // namespace ffcontact
