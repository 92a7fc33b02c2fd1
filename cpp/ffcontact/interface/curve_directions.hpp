// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// Whether contact directions turn along any edge.
bool turns(const ContactLine& line);

/// A line of smooth curves (BoundaryCurves) with one contact direction for each of
/// them, where it touches a foundation that is flatter: tractions are then linear on
/// edges, and can be judged.
///
/// The direction d is the normal of a straight line that the curve goes on from, or else
/// the curve's own where the gap is the smallest, at the vertex of the parabola through
/// three gaps; that of an axis if it is within a twentieth of an edge's turn of it, so
/// that a force along the axis does not push a body aside that nothing else holds. It
/// stands for the normals n while
///     n . d > 1/2   and   g - g_0 >= (x_0 - x) . d / 2   at all nodes of the curve, x_0 the one where g is the smallest:
/// the gap opens at least half as fast as the curve falls back from its tangent. A curve
/// that fits its foundation better than that keeps its own normals.
/// @param gap  at the line's nodes [mm]
ContactLine with_one_direction_a_curve(const Mesh& mesh, ContactLine line,
                                       const Ref<const VectorXd>& gap);

}  // namespace ffcontact
