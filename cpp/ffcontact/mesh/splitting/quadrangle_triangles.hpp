// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// A body with less than this fraction of the square of its longest diagonal as its area,
/// or of the cube as its volume, is flat. Layers of aspect 1e6 are far above it, rounding
/// of coordinates 1e3 diagonals away from 0 is below.
constexpr double flat_body = 1e-12;

/// The two triangles into which a diagonal cuts a quadrangle in space.
///
/// The diagonal is the one that lies inside. Of two inside it is the shorter one, and of
/// two that are equal up to rounding the one through the vertex of the lowest number. This
/// depends on the vertices alone, to the last bit, and not on where a cell begins to list
/// them or which way round: two cells that share a quadrangle cut it alike. A warped
/// quadrangle is seen along its vector area.
/// @param corners  one column each, around the quadrangle
/// @param numbers  of the vertices, different
/// @return the corners of the triangles (0 to 3), which run around as the quadrangle does;
///         nothing where no diagonal lies inside: it is flat or crosses itself
std::optional<std::array<Vector3i, 2>> quadrangle_triangles(
    const Matrix<double, 3, 4>& corners, const Vector4i& numbers);

}  // namespace ffcontact
