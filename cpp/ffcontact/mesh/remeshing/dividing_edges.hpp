// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "ffcontact/mesh/remeshing/dividing_faces.hpp"

namespace ffcontact {

/// The edges of dividing faces, each with the faces around it: numbers in
/// DividingFaces, ascending.
struct DividingEdge {
  std::array<int, 2> vertices;  ///< ascending
  std::vector<int> faces;
};

/// Ascending by their vertices.
std::vector<DividingEdge> dividing_edges(const Facets<3>& faces,
                                         const DividingFaces& dividing);

}  // namespace ffcontact
