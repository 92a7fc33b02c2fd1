// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/hooke.hpp"

namespace ffcontact {

/// The largest of the terms that stresses are summed from, |C| |grad phi_k| |u_k| summed
/// over the vertices of a cell [MPa]: their rounding is relative to it.
template <int dim>
double largest_stress_terms(const SimplexMesh<dim>& mesh,
                            const HookeTensors<dim>& hooke,
                            const VectorXd& displacement);

}  // namespace ffcontact
