// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ffcontact/contact/rigid_tool.hpp"
//
#include "solve/solve_call.hpp"

namespace ffcontact::plugin {

/// The rigid foundation that push=, moment=, about= and guide= of a call free, or nothing.
/// push= frees both translations, or that along guide=, moment= the rotation about about=.
/// @param origin  of the mesh's vertices
/// @throws std::invalid_argument  if guide= has no direction, or guide= or about= has
///                                nothing that it belongs to
std::optional<RigidTool> stated_tool(const SolveCall& call,
                                     const Vector2d& origin);

/// @throws std::invalid_argument  if the call of a solid gives such a parameter
void require_no_tool(const NamedArguments& named);

}  // namespace ffcontact::plugin
