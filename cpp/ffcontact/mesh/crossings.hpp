// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Vertices of four triangles in which two straight lines cross, over the vertices inside a
/// body, those from `first` on before `end`; 0 where there is none.
///
/// Linear triangles of a nearly incompressible material lock: each has the condition that
/// its divergence vanishes. At a crossing one of four conditions follows from the others
/// [J. C. Nagtegaal, D. M. Parks, J. R. Rice, Comput. Methods Appl. Mech. Engrg. 4 (1974)].
/// Where half of the vertices are crossings, as of quadrangles that are cut by both
/// diagonals, or by diagonals that alternate, triangles do not lock.
double crossing_share(const Mesh& mesh, int first, int end);

}  // namespace ffcontact
