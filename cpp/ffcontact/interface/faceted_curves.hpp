// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// A smooth curve that a contact line takes for a polygon.
struct FacetedCurve {
  int edge;             ///< mesh edge after the vertex in its middle
  int edges;            ///< how many it is made of
  double largest_turn;  ///< between two of them [rad]
};

/// The smooth curves on which a line has two nodes a vertex, each with the normal of its
/// edge. Such a line answers for the polygon: it locks sliding at every vertex, and raises
/// the pressure, at any size of its edges.
///
/// A curve is at least five edges, no two of them on one straight line, that turn by less
/// than 29 degrees each, and by about as much as their neighbours (line_parts): twelve
/// edges of a circle are a polygon, thirteen a curve. It is one that the line takes for a
/// polygon if at half of its inner vertices or more both edges have normals of their own.
std::vector<FacetedCurve> faceted_curves(const Mesh& mesh, const Edges& edges,
                                         const ContactLine& line);

}  // namespace ffcontact
