// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/incompressibility.hpp"
//
#include "freefem/freefem.hpp"

namespace ffcontact::plugin {

inline double poissons_ratio(double bulk_over_shear) {
  return bulk_over_shear / (2 * (bulk_over_shear + 1));
}

/// Says once in a run, at any verbosity, that linear cells of this material lock.
/// @param remedy  for cells of this kind
template <int dim>
void warn_that_cells_lock(const SimplexMesh<dim>& mesh,
                          const ElasticSystem& system, const char* cells,
                          const char* remedy) {
  constexpr double locking = 45;  // lambda/G, nu 0.489
  static bool has_said = false;
  if (has_said || mpirank != 0) return;
  const double ratio = largest_bulk_over_shear(mesh, system);
  if (ratio < locking) return;
  has_said = true;
  cout << "contactsolve: the material is nearly incompressible (nu "
       << poissons_ratio(ratio) << "), and linear " << cells
       << " lock: forces and pressures are too large, on coarse meshes by a "
          "multiple, which eps tells; "
       << remedy << "; or take nu 0.48" << endl;
}

}  // namespace ffcontact::plugin
