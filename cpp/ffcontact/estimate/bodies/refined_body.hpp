// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"
#include "ffcontact/interface/pairing/common_refinement.hpp"

namespace ffcontact {

/// The same solution, law and loads on the common refinement of the facing traces.
SolvedBody<2> refined_body(const Mesh& old_mesh, const Edges& old_edges,
                           const ContactLine& old_line,
                           const SolvedBody<2>& old,
                           const CommonRefinement& refinement);

/// A vertex field, linear in between, at the vertices of the refinement.
VectorXd refined_field(const CommonRefinement& refinement,
                       const VectorXd& field);

/// 1 where a dof of the refinement is prescribed: a new vertex is held where both ends of
/// its edge are.
Flags refined_prescribed(const CommonRefinement& refinement, const Flags& old);

/// Forces on the vertices of the refinement as forces on the old vertices, with the same
/// work on fields linear in between.
VectorXd unrefined_forces(const CommonRefinement& refinement,
                          const VectorXd& forces);

}  // namespace ffcontact
