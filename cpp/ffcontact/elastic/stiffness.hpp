// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/elastic/row_matrix.hpp"

namespace ffcontact {

/// K without boundary conditions, K_ij = int C eps(phi_i) : eps(phi_j).
template <int dim>
RowMatrix stiffness(const SimplexMesh<dim>& mesh,
                    const HookeTensors<dim>& hooke);

}  // namespace ffcontact
