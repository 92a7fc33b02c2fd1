// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/tractions/contact_facet.hpp"
#include "ffcontact/estimate/error/face_fields.hpp"

namespace ffcontact {

/// The faces of a surface that face another body with all of their area, corners that are all
/// nodes, and match none of its faces: their tractions may be relaxed, too.
///
/// With the polygons of the common refinement the part of e^2 is
///     2 sum over the corners of c_i s_i + r_i . v_i
/// as of faces that match (contact_term); s_i and v_i are sums of FaceCosts of the triangles
/// of the polygons by the places of their corners on the face.
/// @param displacement  u_hat on all dofs [mm]
std::vector<ContactFacet<3>> facing_faces(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const ContactLaw<3>& law,
    const Ref<const VectorXd>& displacement);

/// r along x, y, z on a face by (r_n, r_t1, r_t2) at its corners, column by column
/// (QuadraticOnFace) [27 x 9].
using DensityOfCorners = Matrix<double, 27, 9>;
DensityOfCorners density_by_corners(const ContactFacet<3>& face);

}  // namespace ffcontact
