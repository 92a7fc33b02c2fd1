// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/hooke.hpp"

namespace ffcontact {

/// int sigma : eps(phi) for all hat functions phi and components [N/mm in 2D, N in 3D].
/// @param stress  of each cell, Voigt [MPa]
template <int dim>
VectorXd inner_forces(
    const SimplexMesh<dim>& mesh,
    const Ref<const Matrix<double, voigt_size<dim>, Dynamic>>& stress);

}  // namespace ffcontact
