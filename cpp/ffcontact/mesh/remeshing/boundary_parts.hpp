// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/mesh.hpp"
#include "ffcontact/mesh/smooth_curve.hpp"

namespace ffcontact {

/// The labelled edges of a mesh as straight lines and smooth curves, each from a corner,
/// a branch or a change of label to the next; a curve may go on beyond a change of label.
/// A remesher that keeps the ends of labels, as adaptmesh does, keeps the ends of parts
/// when every part has a label of its own (labelled_by_parts); what it makes of their
/// inside is then put on them (moved_onto_parts).
struct BoundaryPart {
  std::vector<int>
      vertices;  ///< in order; the first again at the end of a closed curve
  std::vector<int> columns;  ///< of Mesh::boundary
  /// the whole curve that it is a part of; none if it is straight
  std::optional<SmoothCurve<2>> curve;
  int label;  ///< in the mesh

  bool straight() const { return !curve; }
};

/// @param corner  where a curve turns by more it has a corner [rad]; between straight
///                lines every vertex is one
std::vector<BoundaryPart> boundary_parts(const Mesh& mesh, double corner);

/// Angle between the turns inside curves and those at corners [rad], at most `corner`.
double smallest_corner(const Mesh& mesh, const std::vector<BoundaryPart>& parts,
                       double corner);

/// The label that a part has in labelled_by_parts: above all labels of the mesh.
int part_label(const Mesh& mesh, int part);

VectorXi labelled_by_parts(const Mesh& mesh,
                           const std::vector<BoundaryPart>& parts);

}  // namespace ffcontact
