// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/estimate/error/face_fields.hpp"

namespace ffcontact {

/// The oscillation (facet_oscillation.hpp) of contact tractions where surfaces do not match, r
/// being known on the polygons of their common refinement, on faces of the opposite body and
/// on those that face it in part; and where normals turn, r being quadratic (BentTraction).
///
/// (sum over T of (sum over F of |d|_F')^2)^(1/2) [(N mm)^(1/2)]. Integrals are exact on
/// the polygons, those that overlap on a face included; what is smaller than 1e-12 of a
/// face is rounding.
double traction_oscillation(const SolidMesh& mesh, const Facets<3>& faces,
                            const ContactSurface& surface,
                            const HookeTensors<3>& hooke,
                            const TractionFields& traction);

}  // namespace ffcontact
