// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/condensed_contact.hpp"
#include "ffcontact/contact/surface_law.hpp"

namespace ffcontact {

/// How the free dofs of a contact surface move its nodes.
///
/// A vertex moves along n, t1, t2 of its first node, or along its free axes where some
/// of its dofs are prescribed. As many rows of its first node are primary: n unless the
/// free axes are tangential, then the tangents that they move most. The other rows of
/// such a node, and those of later nodes of a vertex that no free dof moves, are held: no
/// equation gives a force there, it is 0, and the cone acts on what is left.
struct SurfaceTrace {
  ContactTrace trace;  ///< v_prescribed with gap and previous displacement
  std::vector<int> primary;  ///< [f]
  std::vector<char> held;    ///< [3 p]
};

/// @throws std::invalid_argument  if every dof of the surface is prescribed
SurfaceTrace surface_trace(const ContactSurface& surface, const SurfaceLaw& law,
                           const ElasticSystem& system);

}  // namespace ffcontact
