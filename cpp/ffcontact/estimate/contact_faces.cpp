// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/contact_faces.hpp"

#include "ffcontact/base/norms.hpp"
#include "ffcontact/estimate/cone_projection.hpp"
#include "ffcontact/estimate/surface_tractions.hpp"

namespace ffcontact {

namespace {

/// Tractions nearer to the cone than this part of the largest are in it but for rounding.
constexpr double traction_rounding = 1e-12;

/// Motions below this part of the largest displacement have no direction.
constexpr double least_motion = 1e-9;

}  // namespace

std::vector<ContactFace> contact_faces(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const SurfaceLaw& law,
    const Ref<const VectorXd>& displacement) {
  const Matrix3Xd w =
      displacement_against_foundation(surface, law, displacement);
  const std::vector<FrictionCone> cones = traction_cones(law, surface);
  const double least = least_motion * largest_displacement(law, displacement);
  std::vector<ContactFace> contact;
  for (int m = 0; m < surface.face_count(); ++m) {
    const Vector3i nodes = surface.face_node.col(m);
    if (nodes.minCoeff() < 0) continue;
    ContactFace face;
    face.face = surface.face[m];
    face.area = facet_measure(mesh, faces, face.face);
    Matrix3d slip = Matrix3d::Zero();
    Matrix3d at_vertices;
    for (int i = 0; i < 3; ++i) {
      face.frame[i] = surface.frame(nodes[i]);
      face.cone[i] = cones[nodes[i]];
      at_vertices.col(i) = w.col(nodes[i]);
      const Vector2d tangential = at_vertices.col(i).tail<2>();
      slip(0, i) = tangential.norm();
      face.direction.col(i).setZero();
      if (slip(0, i) > least) face.direction.col(i) = tangential / slip(0, i);
    }
    face.work = face_moments_of(at_vertices, face.area);
    face.slip = face_moments_of(slip, face.area).row(0);
    contact.push_back(face);
  }
  return contact;
}

SurfaceTractions tractions_of(const std::vector<ContactFace>& contact,
                              const FaceMoments& moments) {
  SurfaceTractions tractions(9, contact.size());
  for (std::size_t m = 0; m < contact.size(); ++m) {
    const Matrix3d of_face = moments.col(contact[m].face).reshaped(3, 3);
    tractions.col(m) = traction_of(contact[m], of_face).reshaped();
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

void put_moments(const std::vector<ContactFace>& contact,
                 const SurfaceTractions& tractions, FaceMoments& moments) {
  for (std::size_t m = 0; m < contact.size(); ++m) {
    const Matrix3d of_face = tractions.col(m).reshaped(3, 3);
    moments.col(contact[m].face) = moments_of(contact[m], of_face).reshaped();
  }
}

}  // namespace ffcontact
