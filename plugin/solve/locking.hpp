// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/incompressibility.hpp"
//
#include "freefem/freefem.hpp"

namespace ffcontact::plugin {

inline double poissons_ratio(double bulk_over_shear) {
  return bulk_over_shear / (2 * (bulk_over_shear + 1));
}

inline void say_that_cells_lock(double bulk_over_shear, const char* cells,
                                const char* remedy) {
  cout << "contactsolve: the material is nearly incompressible (nu "
       << poissons_ratio(bulk_over_shear) << "), and linear " << cells
       << " lock: forces and pressures are too large, on coarse meshes by a "
          "multiple, which eps tells; "
       << remedy << ", or lower nu to 0.48" << endl;
}

/// Says once in a run, at any verbosity, that linear cells of a body's material lock.
/// @param first_vertex  of each body, and the number of all
/// @param may_lock      whether the cells of these vertices, first and end, do
/// @param remedy        for cells of this kind
template <int dim, class MayLock>
void warn_that_cells_lock(const SimplexMesh<dim>& mesh,
                          const ElasticSystem& system,
                          const std::vector<int>& first_vertex,
                          const MayLock& may_lock, const char* cells,
                          const char* remedy) {
  constexpr double locking = 45;  // lambda/G, nu 0.489
  static bool has_said = false;
  for (std::size_t body = 1; body < first_vertex.size(); ++body) {
    if (has_said || mpirank != 0) return;
    const int first = first_vertex[body - 1], end = first_vertex[body];
    const double ratio = largest_bulk_over_shear(mesh, system, first, end);
    if (ratio < locking || !may_lock(first, end)) continue;
    has_said = true;
    say_that_cells_lock(ratio, cells, remedy);
  }
}

}  // namespace ffcontact::plugin
