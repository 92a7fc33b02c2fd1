// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "case.hpp"

namespace ffcontact::fuzz {

/// The problem of a number: the same on every machine but for the last bits of pow, sin
/// and cos.
///
/// One to three bodies of 1 to 120 triangles: grids with random columns and rows, moved
/// vertices, flipped edges, split triangles and bites, kinks in the contact line,
/// sheared, turned, scaled by 1e-9 to 1e6 and away from the origin; E from 0.1 to 1e5
/// with jumps up to 1e6, nu from -0.9 to 0.499; clamped, moved or held by single
/// components or by contact alone; random tractions, body forces, gaps, previous
/// displacements, or none of them; frictionless, Tresca, Coulomb with a coefficient that
/// may vary.
Case random_case(std::uint64_t seed, std::uint64_t index);

}  // namespace ffcontact::fuzz
