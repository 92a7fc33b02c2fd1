// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/equilibrium/tractions/prescribed_labels.hpp"
#include "ffcontact/interface/traction_parts.hpp"

namespace ffcontact {

namespace {

/// What one boundary face carries.
/// @param free    components that the support answers
/// @param column  of SolidMesh::boundary
void put_face(const SolidMesh& mesh, const Facets<3>& faces, int face,
              int column, const std::array<bool, 3>& free,
              const Ref<const FaceMoments>& neumann, FaceTractions& given) {
  for (int k = 0; k < 3; ++k) {
    const int place = faces.place_of(mesh.boundary(k, column), face);
    for (int c = 0; c < 3; ++c) {
      given.known(c, face) = !free[c];
      if (!free[c])
        given.moments(3 * place + c, face) = neumann(3 * k + c, column);
    }
  }
}

}  // namespace

FaceTractions given_tractions(const SolidMesh& mesh, const Facets<3>& faces,
                              const Flags& prescribed,
                              const Ref<const FaceMoments>& neumann) {
  require_fitting(mesh, prescribed, neumann);
  const PrescribedLabels<3> fixed = prescribed_labels(mesh, prescribed);
  FaceTractions given;
  given.known.setConstant(3, faces.count(), false);
  given.moments = FaceMoments::Zero(9, faces.count());
  for (int f = 0; f < faces.count(); ++f) {
    if (!faces.on_boundary(f)) continue;
    const int column = faces.boundary_index[f];
    put_face(mesh, faces, f, column,
             entry_of(fixed, mesh.boundary_label[column], "facet with a label"),
             neumann, given);
  }
  return given;
}

FaceTractions with_contact(FaceTractions given, const SolidMesh& mesh,
                           const Facets<3>& faces,
                           const ContactSurface& surface,
                           const Ref<const Matrix3Xd>& traction) {
  for (const TractionPart& part : traction_parts(mesh, faces, surface)) {
    const Matrix3d moments =
        traction_at_corners(surface, part.contact_face, traction) * part.weight;
    given.known.col(part.face).setConstant(true);
    given.moments.col(part.face) += moments.reshaped();
  }
  return given;
}

}  // namespace ffcontact
