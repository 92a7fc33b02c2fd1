// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/quantity.hpp"

#include "ffcontact/elastic/body_loads.hpp"
#include "ffcontact/elastic/inner_forces.hpp"
#include "ffcontact/equilibrium/tractions/boundary_springs.hpp"

namespace ffcontact {

template <int d>
VectorXd load_of(const SimplexMesh<d>& mesh, const Quantity<d>& quantity) {
  VectorXd load = boundary_forces<d>(mesh, quantity.tractions);
  if (!quantity.stress.empty())
    load += inner_forces<d>(mesh, quantity.stress.mean);
  add_body_loads(mesh, quantity.body_loads, load);
  return load;
}

template VectorXd load_of(const SimplexMesh<FFCONTACT_DIMENSION>&,
                          const Quantity<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
