// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/progress.hpp"
#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/difference_loads.hpp"
#include "ffcontact/equilibrium/free_springs.hpp"
#include "ffcontact/equilibrium/free_tractions.hpp"
#include "ffcontact/mesh/topology.hpp"

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
/// The corrections are one Airy function (AirySpace), from zero: every triangle's energy
/// is a fixed form in its unknowns, set up once (AiryEnergy), and equilibrium keeps to
/// rounding however many sweeps there are. A sweep is two steps of conjugate gradients
/// with the additive solves of all stars (StarDescent), in which known traction
/// components of boundary edges stay as they are. Then, at the vertices on free contact
/// edges, the end values of r_hat are unknowns too, kept in the cone by linear
/// inequalities; where the line faces another body, whose trace must match, the facing
/// vertices are relaxed together, with r_hat on one and -r_hat on the other
/// (relax_boundary).
///
/// Springs whose tractions are free (released) take part by their error, which joins the
/// energies of the triangles beside them.
///
/// The relaxation ends where a sweep no longer changes a digit of e.
///
/// The result does not depend on the number of threads.
/// @param body_loads  int f phi_i per triangle
/// @param difference  edge loads of sigma_hat - C eps(u_hat), relaxed in place
/// @param contact     r_hat, relaxed in place; null keeps it fixed
/// @param springs     free_springs, not known on the boundary
/// @return what e^2 fell by in every sweep [N/mm per unit thickness times mm]
std::vector<double> relax_stars(const Topology& topology, const Hooke& hooke,
                                const BoundaryTractions& boundary,
                                const BodyLoadsOfAll& body_loads,
                                const RelaxationSettings& settings,
                                EdgeLoadsOfAll& difference,
                                FreeContact* contact,
                                const std::vector<FreeSpring>& springs = {});

}  // namespace ffcontact
