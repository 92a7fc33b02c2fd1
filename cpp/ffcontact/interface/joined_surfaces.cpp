// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/joined_surfaces.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

class SurfaceJoiner {
 public:
  void add(const ContactSurface& surface) {
    first_ = count_of(vertex_);
    add_polygons(surface.polygons);
    append_to(vertex_, surface.vertex);
    append_to(area_, surface.area);
    append_to(face_, surface.face);
    for (int i = 0; i < surface.node_count(); ++i) add_node(surface, i);
    add_mass(surface.mass);
    for (auto nodes : surface.face_node.colwise())
      face_node_.emplace_back(
          (nodes.array() < 0).select(nodes, nodes.array() + first_));
    vertices_ = std::max(vertices_, surface.opposite.cols());
  }

  ContactSurface joined() && {
    const Index nodes = count_of(vertex_);
    all_.vertex = packed(vertex_);
    all_.normal = packed(normal_);
    all_.area = packed(area_);
    all_.face_node = packed(face_node_);
    all_.face = packed(face_);
    all_.mass = packed(nodes, nodes, mass_);
    if (vertices_ > 0)
      all_.opposite = packed<WeightsByNode>(nodes, vertices_, opposite_);
    return std::move(all_);
  }

 private:
  template <class Value, class Values>
  static void append_to(std::vector<Value>& all, const Values& values) {
    all.insert(all.end(), values.begin(), values.end());
  }

  void add_polygons(std::vector<FacingPolygon> polygons) {
    for (FacingPolygon& polygon : polygons) {
      polygon.contact_face += count_of(face_);
      all_.polygons.push_back(std::move(polygon));
    }
  }

  void add_node(const ContactSurface& surface, int i) {
    normal_.emplace_back(surface.normal.col(i));
    visit_opposite(surface, i, [&](int v, double weight) {
      opposite_.emplace_back(first_ + i, v, weight);
    });
  }

  void add_mass(const SparseMatrix& mass) {
    for (int j = 0; j < mass.outerSize(); ++j)
      for (SparseMatrix::InnerIterator m(mass, j); m; ++m)
        mass_.emplace_back(first_ + m.row(), first_ + j, m.value());
  }

  ContactSurface all_;
  std::vector<int> vertex_, face_;
  std::vector<Vector3d> normal_;
  std::vector<double> area_;
  std::vector<Vector3i> face_node_;
  Triplets opposite_, mass_;
  Index vertices_ = 0;
  int first_ = 0;  ///< node of the surface that is added
};

}  // namespace

ContactSurface joined_surfaces(const std::vector<ContactSurface>& surfaces) {
  SurfaceJoiner joiner;
  for (const ContactSurface& surface : surfaces) joiner.add(surface);
  return std::move(joiner).joined();
}

}  // namespace ffcontact
