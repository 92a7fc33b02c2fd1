// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/condensed/condensed_contact.hpp"
#include "ffcontact/contact/law/contact_law.hpp"

namespace ffcontact {

/// How the free dofs of a contact surface, and of what it faces, move its nodes.
///
/// A vertex moves along n, t1, t2 of its first node, or along its free axes where some
/// of its dofs are prescribed; an opposite one along its free axes. As many rows of the
/// first node of a vertex are primary: n unless the free axes are tangential, then the
/// tangents that they move most. Other rows are dependent if a later node's vertex or
/// opposite ones move them, and held if none does: no equation gives a force there, it is
/// 0, and the cone acts on what is left. Opposite vertices do not move a row where most of
/// their weights are fixed along it, as on planes of symmetry of both bodies, or where
/// those that are not weigh less than 1e-3 each (as in held_rows); nor do they along a
/// tangent that the own vertex is fixed along beside one that is not: friction is left out
/// at such a node, unless it follows one vertex alone. Forces and v of held rows are 0.
struct SurfaceTrace {
  ContactTrace trace;  ///< v_prescribed with gap and previous displacement
  std::vector<int> primary;  ///< [f]
  Flags held;                ///< [3 p]
};

/// @throws std::invalid_argument  if every dof of the surface is prescribed
SurfaceTrace surface_trace(const ContactSurface& surface,
                           const ContactLaw<3>& law,
                           const ElasticSystem& system);

}  // namespace ffcontact
