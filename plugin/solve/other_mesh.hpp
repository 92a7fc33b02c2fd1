// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/turned_boundary.hpp"
//
#include "freefem/freefem.hpp"

namespace ffcontact::plugin {

inline void say_other_mesh() {
  cout << "contactsolve: A resists a rotation of the mesh that the contact was "
          "stated on: it is of another mesh, or of no elasticity. Where a mesh "
          "has moved state the contact anew: C = contact(Th, ...)"
       << endl;
}

/// Says once in a run, at any verbosity, that a matrix is not of the mesh that the contact was
/// stated on: fespaces follow a mesh variable that is assigned anew, contacts do not.
/// @param first_vertex  of each body, and the number of all
template <int dim>
void warn_of_other_mesh(const SimplexMesh<dim>& mesh,
                        const ElasticSystem& system,
                        const std::vector<int>& first_vertex) {
  constexpr double most = 0.3;
  static bool has_said = false;
  for (std::size_t body = 1; body < first_vertex.size(); ++body) {
    if (has_said || mpirank != 0) return;
    has_said = share_resisting_rotation(mesh, system, first_vertex[body - 1],
                                        first_vertex[body]) > most;
    if (has_said) say_other_mesh();
  }
}

}  // namespace ffcontact::plugin
