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

/// The given tractions alone; contact faces are as any others.
/// @param prescribed  1 where the dof is prescribed [3 * vertices]
/// @param neumann     moments of the given tractions at the three vertices of each column
///                    of SolidMesh::boundary [N, 9 x boundary]; not read on prescribed
///                    components
/// @throws std::invalid_argument  if sizes differ or a traction is not finite
FaceTractions given_tractions(const SolidMesh& mesh, const Facets<3>& faces,
                              const Flags& prescribed,
                              const Ref<const FaceMoments>& neumann);

/// Adds contact tractions, with which all components are known. Against another body they
/// act on both, where faces do not match by the linear tractions nearest to them: these
/// have their force and their moment on every face.
/// @param traction  (r_n, r_t1, r_t2) at the nodes, linear on the faces [MPa, 3 x p]
FaceTractions with_contact(FaceTractions given, const SolidMesh& mesh,
                           const Facets<3>& faces,
                           const ContactSurface& surface,
                           const Ref<const Matrix3Xd>& traction);

}  // namespace ffcontact
