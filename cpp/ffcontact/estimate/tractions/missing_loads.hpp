// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Which loads of u_h may be missing at a vertex, as the end of a sentence.
/// @param in_contact  what is said of a vertex where contact may occur; empty elsewhere
template <int d>
std::string missing_loads(const SimplexMesh<d>& mesh, int vertex,
                          const std::string& in_contact) {
  if (!(mesh.boundary.array() == vertex).any())
    return "inside the body: give the bodyforce=, initialstrain= and "
           "initialstress= u was computed with";
  if (!in_contact.empty()) return in_contact;
  return "on the boundary: give the traction=, rest=, initialstrain= and "
         "initialstress= u was computed with";
}

}  // namespace ffcontact
