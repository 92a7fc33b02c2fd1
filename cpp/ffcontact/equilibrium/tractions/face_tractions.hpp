// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/interface/contact_surface.hpp"
#include "ffcontact/mesh/facets.hpp"

namespace ffcontact {

/// Moments of linear face tractions, int F phi at the three vertices of each mesh face,
/// where F = sigma n with the face's normal (outward on the boundary): one column of three
/// vectors per face [N].
using FaceMoments = FacetColumns<3>;

using FaceTractions = FacetTractions<3>;

/// Adds contact tractions, with which all components are known. Against another body they
/// act on both, where faces do not match by the linear tractions nearest to them: these
/// have their force and their moment on every face.
/// @param traction  (r_n, r_t1, r_t2) at the nodes (bent_traction) [MPa, 3 x p]
FaceTractions with_contact(FaceTractions given, const SolidMesh& mesh,
                           const Facets<3>& faces,
                           const ContactSurface& surface,
                           const Ref<const Matrix3Xd>& traction);

}  // namespace ffcontact
