// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/interface/contact_line.hpp"

/// Where a line lies on the line that a problem states coefficients on: itself, or, where
/// the opposite body carries the multipliers, what it faces.
namespace ffcontact {

/// Points of a contact edge at which a coefficient is evaluated.
constexpr int samples_of_an_edge = 9;

/// A mesh edge, and the place on it: 0 at its first vertex, 1 at its second.
struct EdgePlace {
  int edge;
  double place;
};

/// The places that belong to the points of a line, evenly spaced on each contact edge,
/// ends included [edge][point].
using StatedPlaces = std::vector<std::vector<EdgePlace>>;

/// @param on_opposite  whether they are on what the line faces; each of its contact edges
///                     then has a piece
StatedPlaces stated_places(const ContactLine& line, bool on_opposite);

/// Nodes and ends of contact edges as the stated line counts them.
struct StatedAbscissae {
  VectorXi vertex;     ///< mesh vertex nearest to each node [p]
  VectorXd node;       ///< arc length of each node [mm, p]
  Matrix2Xd edge_end;  ///< and of the ends of each contact edge [mm, 2 x m]
};

/// @param stated  of whole edges
/// @param places  of `line`, on edges of `stated`
StatedAbscissae stated_abscissae(const Edges& edges, const ContactLine& stated,
                                 const ContactLine& line,
                                 const StatedPlaces& places);

}  // namespace ffcontact
