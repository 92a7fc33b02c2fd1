// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/joined_surfaces.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/packed.hpp"

namespace ffcontact {

ContactSurface joined_surfaces(const std::vector<ContactSurface>& surfaces) {
  ContactSurface all;
  std::vector<int> vertex, face;
  std::vector<Vector3d> normal;
  std::vector<double> area;
  std::vector<Vector3i> face_node;
  Triplets opposite, mass;
  Index vertices = 0;
  for (const ContactSurface& surface : surfaces) {
    const int first = count_of(vertex);
    for (FacingPolygon polygon : surface.polygons) {
      polygon.contact_face += count_of(face);
      all.polygons.push_back(std::move(polygon));
    }
    vertex.insert(vertex.end(), surface.vertex.begin(), surface.vertex.end());
    area.insert(area.end(), surface.area.begin(), surface.area.end());
    face.insert(face.end(), surface.face.begin(), surface.face.end());
    for (int i = 0; i < surface.node_count(); ++i) {
      normal.emplace_back(surface.normal.col(i));
      visit_opposite(surface, i, [&](int v, double weight) {
        opposite.emplace_back(first + i, v, weight);
      });
    }
    for (int j = 0; j < surface.mass.outerSize(); ++j)
      for (SparseMatrix::InnerIterator m(surface.mass, j); m; ++m)
        mass.emplace_back(first + m.row(), first + j, m.value());
    for (auto nodes : surface.face_node.colwise())
      face_node.emplace_back(
          (nodes.array() < 0).select(nodes, nodes.array() + first));
    vertices = std::max(vertices, surface.opposite.cols());
  }
  all.vertex = packed(vertex);
  all.normal = packed(normal);
  all.area = packed(area);
  all.face_node = packed(face_node);
  all.face = packed(face);
  all.mass = packed(count_of(vertex), count_of(vertex), mass);
  if (vertices > 0)
    all.opposite = packed<WeightsByNode>(count_of(vertex), vertices, opposite);
  return all;
}

}  // namespace ffcontact
