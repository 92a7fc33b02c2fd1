// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/contact_faces.hpp"

#include <array>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "ffcontact/estimate/error/between_nodes.hpp"
#include "ffcontact/estimate/tractions/cone_projection.hpp"
#include "ffcontact/interface/pairing/matching_faces.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Tractions nearer to the cone than this part of the largest are in it but for rounding.
constexpr double traction_rounding = 2e-12;

/// w at the corners of a contact face, less the gap and the load step before, along n, t1,
/// t2 of each of its corners, whose frames differ on curved surfaces.
using SeenMotions = std::array<Matrix3d, 3>;

/// Against a rigid foundation, or a face that matches.
SeenMotions seen_motions(const Facets<3>& faces, const ContactSurface& surface,
                         const SurfaceLaw& law, int m,
                         const MatchingFace& match,
                         const Ref<const VectorXd>& u) {
  const Vector3i nodes = surface.face_node.col(m);
  Matrix3d jump, previous = Matrix3d::Zero();
  Vector3d gap = Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const int i = nodes[k];
    jump.col(k) = vector_at<3>(u, faces.vertices(k, surface.face[m]));
    if (match.face >= 0)
      jump.col(k) -=
          vector_at<3>(u, faces.vertices(match.corner[k], match.face));
    if (law.gap.size() > 0) gap[k] = law.gap[i];
    if (law.previous.size() > 0)
      previous.col(k) = surface.frame(i).rightCols<2>() * law.previous.col(i);
  }
  SeenMotions seen;
  for (int a = 0; a < 3; ++a) {
    const Matrix3d frame = surface.frame(nodes[a]);
    seen[a] = frame.transpose() * jump;
    seen[a].row(0) -= gap.transpose();
    seen[a].bottomRows<2>() -= frame.rightCols<2>().transpose() * previous;
  }
  return seen;
}

/// @param least     |w_t| without direction [mm]
/// @param rounding  |w_t| that is 0
void put_motions(const SeenMotions& seen, double least, double rounding,
                 ContactFacet<3>& face) {
  for (int i = 0; i < 3; ++i) {
    Matrix3d slip = Matrix3d::Zero();
    for (int k = 0; k < 3; ++k)
      slip(0, k) = slip_beyond(rounding, seen[i].col(k).tail<2>().norm());
    face.work.col(i) = facet_moments_of<3>(seen[i], face.measure).col(i);
    face.slip[i] = facet_moments_of<3>(slip, face.measure)(0, i);
    face.direction.col(i).setZero();
    if (slip(0, i) > least)
      face.direction.col(i) = seen[i].col(i).tail<2>() / slip(0, i);
  }
}

}  // namespace

std::vector<ContactFacet<3>> contact_faces(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const SurfaceLaw& law,
    const Ref<const VectorXd>& displacement) {
  const bool between_bodies = surface.against_a_body();
  const std::vector<MatchingFace> matches =
      matching_faces(mesh, faces, surface);
  const std::vector<FrictionCone> cones = traction_cones(law, surface),
                                  paid = law_cones(law, surface);
  const double least = least_motion * largest_displacement(law, displacement),
               rounding = rounding_of_slip(law, displacement);
  std::vector<ContactFacet<3>> contact;
  for (int m = 0; m < surface.face_count(); ++m) {
    const Vector3i nodes = surface.face_node.col(m);
    if (nodes.minCoeff() < 0 || (between_bodies && matches[m].face < 0))
      continue;
    ContactFacet<3> face;
    face.facet = surface.face[m];
    face.index = m;
    face.opposite = matches[m].face;
    face.opposite_corner = matches[m].corner;
    face.measure = facet_measure(mesh, faces, face.facet);
    for (int i = 0; i < 3; ++i) {
      face.frame[i] = surface.frame(nodes[i]);
      face.cone[i] = cones[nodes[i]];
      face.paid[i] = paid[nodes[i]];
    }
    put_motions(seen_motions(faces, surface, law, m, matches[m], displacement),
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
    moments.col(face.facet) = own;
    for (int k = 0; k < 3 && face.opposite >= 0; ++k)
      moments.col(face.opposite).segment<3>(3 * face.opposite_corner[k]) -=
          change.segment<3>(3 * k);
  }
}

}  // namespace ffcontact
