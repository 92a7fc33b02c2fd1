// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/uniqueness/directed_slip.hpp"
#include "ffcontact/estimate/estimate.hpp"

namespace ffcontact {

/// What Coulomb's law makes of e of solids.
struct SolidCoulomb {
  double friction;  ///< mu, the largest coefficient
  double kappa;     ///< directed_constant
  double missed;    ///< delta [the unit of e]
  /// B; with e + the traction oscillation for e; infinite for a pair that is not
  /// admissible
  double bound;
};

/// s and d of the admissible pair at the nodes: s is w_hat_t / |w_hat_t| where that is more
/// than 1e-9 of the largest displacement; elsewhere -r_hat_t over the friction bound, both
/// as means of the faces around the node weighted by their areas, or 0 where nothing
/// presses. The moments of d are those of its values at the corners of the faces, linear
/// between.
DirectedSlip directed_slip(const Topology<3>& topology,
                           const ContactSurface& surface,
                           const SolvedBody<3>& body,
                           const Estimate<3>& estimate);

/// kappa, delta and B of a judged solution: 0, 0 and e without friction that depends on
/// r_n. Infinite where a traction is at the shear limit; elsewhere the exact solution's are
/// taken to be below it. Infinite, too, where normals turn over a face: d is known for
/// tractions that are linear.
/// @param system  as for estimate_error
/// @param held    1 at nodes that slip nowhere, neither in the exact solution [p]
SolidCoulomb solid_coulomb(const Topology<3>& topology,
                           const ContactSurface& surface,
                           const ElasticSystem& system,
                           const SolvedBody<3>& body,
                           const Estimate<3>& estimate, const Flags& held);

}  // namespace ffcontact
