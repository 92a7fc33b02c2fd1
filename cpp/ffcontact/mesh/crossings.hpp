// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Vertices of four triangles in which two straight lines cross, over the triangles.
///
/// Linear triangles of a nearly incompressible material lock: each has the condition that
/// its divergence vanishes. At a crossing one of four conditions follows from the others
/// [J. C. Nagtegaal, D. M. Parks, J. R. Rice, Comput. Methods Appl. Mech. Engrg. 4 (1974)].
/// Quadrangles that are cut by both diagonals have one crossing in four triangles, and do
/// not lock.
double crossing_share(const Mesh& mesh);

}  // namespace ffcontact
