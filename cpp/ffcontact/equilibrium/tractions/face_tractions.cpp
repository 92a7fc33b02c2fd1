// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"

#include "ffcontact/interface/traction_parts.hpp"

namespace ffcontact {

FaceTractions with_contact(FaceTractions given, const SolidMesh& mesh,
                           const Facets<3>& faces,
                           const ContactSurface& surface,
                           const Ref<const Matrix3Xd>& traction) {
  for (const TractionPart& part : traction_parts(mesh, faces, surface)) {
    const Matrix3d moments =
        along_axes(bent_traction(surface, part.contact_face, traction)) *
        part.weight;
    given.known.col(part.face).setConstant(true);
    given.moments.col(part.face) += moments.reshaped();
  }
  return given;
}

}  // namespace ffcontact
