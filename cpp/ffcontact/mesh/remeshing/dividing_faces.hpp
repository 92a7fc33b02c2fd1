// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/facets.hpp"

namespace ffcontact {

/// The faces that a new mesh of a solid must have too, and the parts of the body between
/// them: faces of the boundary, faces inside with a label, and faces between regions.
struct DividingFaces {
  std::vector<int> face;  ///< of Facets<3>, ascending
  /// column of SolidMesh::boundary, or -1 between regions without a label
  std::vector<int> boundary;
  /// the parts that a face's normal (facet_vector) comes from and points to, -1 outside
  Matrix2Xi parts;
  std::vector<int> region;  ///< of each part

  int count() const { return static_cast<int>(face.size()); }
  int part_count() const { return static_cast<int>(region.size()); }
};

/// @param regions  one per tetrahedron
/// @throws std::invalid_argument  naming the label of a face inside the body that does not
///                                part it from what is beyond
DividingFaces dividing_faces(const SolidMesh& mesh, const Facets<3>& faces,
                             const VectorXi& regions);

}  // namespace ffcontact
