// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/estimate/estimate.hpp"
#include "freefem/arguments.hpp"
#include "problem/contact_problem.hpp"

namespace ffcontact::plugin {

/// Stresses at the corners of the subtetrahedra as the P1dc arrays of their components on
/// splitmesh4(Th), whose tetrahedron 4 t + k is tetrahedron t with vertex k moved to the
/// barycentre: rows xx, yy, zz, yz, xz, xy [6 x 16 cells]. FreeFEM keeps P1dc values of a
/// mesh3 at the vertices shrunk by 1e-4 towards the tetrahedron's barycentre.
/// @param stress  one tetrahedron after the other
CellStresses<3> p1dc_arrays(const std::vector<SubcellStress<3>>& stress);

/// The admissible stress where the script asks for it: sxx=, syy=, szz=, syz=, sxz= and
/// sxy= of one solid, sxx1=, ... of several.
void put_solid_stress(Stack stack, const NamedArguments& named,
                      const ContactProblem<3>& problem,
                      const Topology<3>& topology, const Estimate<3>& estimate,
                      const SolvedBody<3>& body);

}  // namespace ffcontact::plugin
