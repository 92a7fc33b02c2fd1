// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "problem/contact_type.hpp"

namespace ffcontact::plugin {

/// Writes a solution of solids, and what its estimate left if there is one, for
/// pictures.py, ParaView and gmsh, as plugin/reference/contactpicture.md describes the files:
///   stepN.vtu, stepNb.vtu, ...      the bodies: displacement, eps_E
///   stepN.msh, stepNb.msh, ...      the same for gmsh, with labels and regions
///   stressN.vtu, stressNb.vtu, ...  sigma_hat on the subtetrahedra
///   surfaceN.vtu                    the contact surface: pressures, state, r_hat
///   contactN.txt                    its nodes
/// Such files of this and of later steps that an earlier run left are removed.
/// @throws std::invalid_argument  if a file cannot be written
void write_pictures(const std::filesystem::path& folder, long step,
                    const ContactProblem<3>& problem,
                    const SolvedContact<3>& solved);

}  // namespace ffcontact::plugin
