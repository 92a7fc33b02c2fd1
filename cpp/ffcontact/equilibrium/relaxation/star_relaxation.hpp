// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/progress.hpp"
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/equilibrium/tractions/free_tractions.hpp"

namespace ffcontact {

struct RelaxationSettings {
  int sweeps = 2;  ///< at most; fewer where one no longer lowers e
  /// stop when the last sweep lowered e by less than this fraction; 0: do all sweeps
  double tightness = 0;
  ProgressReport
      report{};  ///< of every sweep, with e (without Tresca's constant)
};

/// Star relaxation: lowers e^2 = |sigma_hat - C eps(u_hat)|^2 + contact part, and keeps
/// equilibrium exactly.
///
/// A sweep is two steps of conjugate gradients with the additive solves of the stars of all
/// vertices (FacetDescent), in which known traction components of boundary edges stay as
/// they are. Then, at the vertices on free contact edges, the end values of r_hat are
/// unknowns too, kept in the cone by linear inequalities; where the line faces another
/// body, whose trace must match, the facing vertices are relaxed together, with r_hat on
/// one and -r_hat on the other (relax_boundary).
///
/// Springs whose tractions are free (released) take part by their error, a term of their
/// edges (terms_of).
///
/// The relaxation ends where a sweep no longer changes a digit of e.
///
/// The result does not depend on the number of threads.
/// @param body     sigma is C eps(u_hat); body loads int f phi_i per triangle, less those
///                 of sigma where it varies
/// @param moments  of sigma_hat, in equilibrium; relaxed in place
/// @param contact  r_hat, relaxed in place; null keeps it fixed
/// @return what e^2 fell by in every sweep [N/mm per unit thickness times mm]
std::vector<double> relax_stars(const LoadedFacets<2>& body,
                                const RelaxationSettings& settings,
                                EdgeMoments& moments, FreeContact* contact);

}  // namespace ffcontact
