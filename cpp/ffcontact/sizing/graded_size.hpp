// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// The largest field below `size` whose slope along mesh edges is at most `gradation`.
/// @param edges  their vertices
template <int dim>
VectorXd graded_size(const SimplexMesh<dim>& mesh,
                     const Ref<const Matrix2Xi>& edges, VectorXd size,
                     double gradation);

}  // namespace ffcontact
