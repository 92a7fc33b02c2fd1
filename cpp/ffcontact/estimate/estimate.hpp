// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/estimate/admissible_pair.hpp"
#include "ffcontact/estimate/bodies/estimate_settings.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"

namespace ffcontact {

/// Builds the admissible pair and evaluates it, as the numbered steps in the body.
///
/// Bodies against each other come as one joined mesh and system, with contact that faces
/// other bodies: w is a jump, r_hat acts on the contact's body and -r_hat on the opposite
/// one, pointwise. Where the traces of plane bodies do not match all this is done on their
/// common refinement: non-penetration holds at each of its nodes, r_hat is linear on each
/// of its edges, and the triangles beside it are the fans of the refinement. Surfaces have
/// none: between them r_hat is linear on the faces, and where these do not match
/// (matching_faces) it has an oscillation, and is relaxed on whole faces (facing_faces).
///
/// Bodies without loads whose stresses and tractions are below 1e-12 of the terms |C|
/// |grad phi| max(|u|, |gap|, |previous|) that stresses are summed from, and that slide
/// nowhere against Tresca's friction, have none: sigma_hat = 0, r_hat = 0, and e is that
/// of u_hat - u, which is 0 but where u penetrates.
/// @param system  the stiffness and the prescribed dofs u_h was computed with
/// @throws std::invalid_argument  for input that does not fit (see law_of_matrix.hpp), loads
///                                that are not those of u_h, or where no tractions in the
///                                cone hold the body
/// @throws std::runtime_error     if a part of the body is held by nothing
template <int d>
Estimate<d> estimate_error(const Topology<d>& topology,
                           const LineOrSurface<d>& contact,
                           const ElasticSystem& system,
                           const SolvedBody<d>& body,
                           const EstimateSettings<d>& settings = {});

}  // namespace ffcontact
