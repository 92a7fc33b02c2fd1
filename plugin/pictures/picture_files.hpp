// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "problem/contact_type.hpp"

namespace ffcontact::plugin {

/// Writes a solution, and what its estimate left if there is one, for pictures.py and
/// ParaView, as plugin/reference/contactpicture.md describes the files:
///   stepN.vtu, stepNb.vtu, ...      the bodies: displacement, eps_E
///   stressN.vtu, stressNb.vtu, ...  sigma_hat on the subtriangles
///   contactN.txt                    the nodes of the contact line
///   tractionsN.txt                  r_hat on the edges of the line
/// Such files of this and of later steps that an earlier run left are removed.
/// @throws std::invalid_argument  if a file cannot be written
void write_pictures(const std::filesystem::path& folder, long step,
                    const ContactProblem<2>& problem,
                    const SolvedContact<2>& solved);

}  // namespace ffcontact::plugin
