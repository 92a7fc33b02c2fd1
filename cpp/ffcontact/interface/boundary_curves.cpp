// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/boundary_curves.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/interface/boundary_chains.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ffcontact/mesh/line_parts.hpp"
#include "ffcontact/mesh/straight_runs.hpp"
#include "ffcontact/mesh/turns.hpp"

namespace ffcontact {

BoundaryCurves::BoundaryCurves(const Mesh& mesh, const Edges& edges,
                               double corner) {
  if (!(corner > 0)) return;
  const std::vector<int> boundary = boundary_edges(edges);
  const double size = extent(mesh.vertices),
               precision =
                   coordinate_precision(places_of(mesh, edges, boundary), size);
  for (std::vector<int>& chain : boundary_chains(mesh, edges, boundary))
    add_chain(mesh, edges, std::move(chain),
              straight_tolerance(precision, size), corner * M_PI / 180);
}

void BoundaryCurves::add_chain(const Mesh& mesh, const Edges& edges,
                               std::vector<int> chain, double tolerance,
                               double corner) {
  Matrix2Xd points = points_of(mesh, edges, chain);
  if (points.col(0) == points.col(points.cols() - 1)) {
    const int start = loop_start(points, tolerance, corner);
    std::rotate(chain.begin(), chain.begin() + start, chain.end());
    points = points_of(mesh, edges, chain);
  }
  const std::vector<LinePart> parts = line_parts(points, tolerance, corner);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k].straight) continue;
    const SmoothCurve<2> curve = curve_of(points, parts, k);
    for (int piece = 0; piece < curve.pieces(); ++piece)
      chords_.emplace(chain[parts[k].first + piece], curve.chord(piece));
  }
}

const Chord<2>* BoundaryCurves::chord(int edge) const {
  const auto found = chords_.find(edge);
  return found == chords_.end() ? nullptr : &found->second;
}

Vector2d BoundaryCurves::beside(int edge, double s) const {
  const Chord<2>* curved = chord(edge);
  if (!curved) return Vector2d::Zero();
  return curved->curve_at(s) - curved->first - s * curved->vector;
}

CurvedEdges curved_edges(const BoundaryCurves& curves, const VectorXi& edges) {
  CurvedEdges found;
  for (const int edge : edges) {
    const Chord<2>* chord = curves.chord(edge);
    if (!chord) continue;
    ++found.count;
    found.largest_turn =
        std::max(found.largest_turn,
                 angle_between(chord->first_tangent, chord->last_tangent));
    found.sagitta = std::max(found.sagitta, curves.beside(edge, 0.5).norm());
  }
  return found;
}

CorneredEdges cornered_edges(const Mesh& mesh, const Edges& edges,
                             const std::vector<int>& boundary, double corner) {
  constexpr double most = M_PI / 3 + 1e-9;
  CorneredEdges longest;
  for (const std::vector<int>& chain : boundary_chains(mesh, edges, boundary)) {
    const Turns<2> turns(points_of(mesh, edges, chain));
    CorneredEdges row{1, 0};
    double least = infinity;
    for (Index k = 1; k < turns.edges(); ++k) {
      const double turn = turns.turn(k);
      least = std::min(least, turn);
      row.largest_turn = std::max(row.largest_turn, turn);
      ++row.count;
      if (turn <= corner || turn > most || row.largest_turn > 2 * least)
        row = {1, 0}, least = infinity;
      if (row.count > longest.count) longest = row;
    }
  }
  return longest;
}

}  // namespace ffcontact
