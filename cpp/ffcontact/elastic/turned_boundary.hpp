// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// How much of a body's boundary resists a rotation of the body as a whole. With the
/// vertices of the mesh that K was assembled on, K z = 0 for every rigid motion z at vertices
/// that nothing else holds. With others, as those before movemesh, a rotation is none, and
/// its strain loads the boundary (inside, a uniform one loads nothing).
///
/// Asked are vertices whose dofs are free and whose rows translations do not load (there no
/// springs act). They resist if a rotation about them has more than 1/200 of the terms that
/// its force adds up, sum |K_ij| |x_j - x_i|.
/// @param first, end  vertices of a body
/// @return the share of those that are asked; 0 if none are
template <int dim>
double share_resisting_rotation(const SimplexMesh<dim>& mesh,
                                const ElasticSystem& system, int first,
                                int end);

}  // namespace ffcontact
