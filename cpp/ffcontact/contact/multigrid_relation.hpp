// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ffcontact/contact/contact_relation.hpp"
#include "ffcontact/contact/stated_surface.hpp"

namespace ffcontact {

/// The relation of solids, on a rigid foundation or against each other, with a layer between
/// them or without, and without a factor of their stiffness: all displacements are unknown,
/// and surface_newton's steps are inexact ones by StepMultigrid, on the conditions that
/// StepConditions states. Memory and time grow like the number of dofs, where those of a factor
/// and of Schur's complement grow like its powers 1.4 and 2.
/// @param vertices  of the mesh
/// @param stated    whose surface does not face itself (faces_itself); outlives it
std::unique_ptr<ContactRelation> multigrid_relation(
    const Matrix3Xd& vertices, const StatedSurface& stated);

}  // namespace ffcontact
