// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "ffcontact/mesh/edges.hpp"
#include "ffcontact/mesh/smooth_curve.hpp"

namespace ffcontact {

/// The smooth curves that boundary edges of plane bodies are chords of (line_parts), found
/// on whole boundaries, whatever their labels.
class BoundaryCurves {
 public:
  /// Where curves turn by more between two edges they have a corner [degrees]: twelve
  /// edges of a circle are a curve, with some rounding.
  static constexpr double default_corner = 30.5;

  /// None: all edges are straight.
  BoundaryCurves() = default;
  /// @param corner  [degrees]; 0 for no curve
  BoundaryCurves(const Mesh& mesh, const Edges& edges,
                 double corner = default_corner);

  /// The chord of a curve that an edge is, from its first to its second vertex; nullptr
  /// if it is straight.
  const Chord<2>* chord(int edge) const;

  /// From the point of an edge at s in [0, 1] to that of its curve [mm].
  Vector2d beside(int edge, double s) const;

 private:
  void add_chain(const Mesh& mesh, const Edges& edges, std::vector<int> chain,
                 double tolerance, double corner);

  std::map<int, Chord<2>> chords_;  ///< by edge
};

/// What some edges have of curves.
struct CurvedEdges {
  int count = 0;
  double largest_turn = 0;  ///< of a curve along an edge [rad]
  double sagitta = 0;       ///< largest distance of a curve from its edge [mm]
};
CurvedEdges curved_edges(const BoundaryCurves& curves, const VectorXi& edges);

/// Edges one after the other, with corners of 60 degrees at most and like each other.
struct CorneredEdges {
  int count = 0;
  double largest_turn = 0;  ///< between two of them [rad]
};
/// The longest row of edges that turn by more than `corner` between any two [rad], and not
/// twice as much somewhere as elsewhere.
CorneredEdges cornered_edges(const Mesh& mesh, const Edges& edges,
                             const std::vector<int>& boundary, double corner);

}  // namespace ffcontact
