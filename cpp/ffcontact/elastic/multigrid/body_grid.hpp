// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/multigrid/smoothed_grid.hpp"
#include "ffcontact/elastic/multigrid/vertex_frames.hpp"

namespace ffcontact {

/// The stiffness of y in single precision, and how rigid motions move it. Vertices that
/// follow others are parts of their own: their y is the motion of one body against another,
/// which no rigid motion of either is.
template <int dim>
Grid<dim, dim> body_grid(const ElasticSystem& system,
                         const Matrix<double, dim, Dynamic>& vertices,
                         const VertexFrames<dim>& frames);

/// How rigid motions move the y of a vertex, of the unknowns with a direction:
///     y = (T'T)^-1 T'u.
template <int dim>
SingleBlock<dim, NodeMotions<dim, dim>::count> motions_along(
    const MatrixOf<dim>& T);

}  // namespace ffcontact
