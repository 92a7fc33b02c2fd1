// SPDX-License-Identifier: GPL-3.0-or-later
#include "freefem/solid_views.hpp"

#include <map>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
//
#include "freefem/body_values.hpp"

namespace ffcontact::plugin {

namespace {

BoundaryPlace<3> on_boundary(const SolidPart& part, const FacePlace& place) {
  const int column = part.faces.boundary_index[place.face];
  Vector3d weights = Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      if (part.mesh.boundary(j, column) == part.faces.vertices(k, place.face))
        weights[j] = place.coordinates[k];
  return {column - part.first_boundary, weights};
}

void put_vertices(const Fem2D::Mesh3& Th, SolidMesh& mesh) {
  mesh.vertices.resize(3, Th.nv);
  for (int v = 0; v < Th.nv; ++v)
    mesh.vertices.col(v) << Th(v).x, Th(v).y, Th(v).z;
}

void put_tetrahedra(const Fem2D::Mesh3& Th, SolidMesh& mesh) {
  mesh.cells.resize(4, Th.nt);
  for (int t = 0; t < Th.nt; ++t)
    for (int k = 0; k < 4; ++k) mesh.cells(k, t) = Th(t, k);
}

void put_boundary(const Fem2D::Mesh3& Th, SolidMesh& mesh) {
  mesh.boundary.resize(3, Th.nbe);
  mesh.boundary_label.resize(Th.nbe);
  for (int e = 0; e < Th.nbe; ++e) {
    for (int k = 0; k < 3; ++k) mesh.boundary(k, e) = Th(Th.be(e)[k]);
    mesh.boundary_label[e] = Th.be(e).lab;
  }
}

}  // namespace

SolidMesh solid_mesh_of(const Fem2D::Mesh3* fem_mesh) {
  if (!fem_mesh) refuse("the mesh3 is not set");
  SolidMesh mesh;
  put_vertices(*fem_mesh, mesh);
  put_tetrahedra(*fem_mesh, mesh);
  put_boundary(*fem_mesh, mesh);
  require_valid(mesh);
  return mesh;
}

std::vector<FacePlace> places_of_nodes(const ContactSurface& surface) {
  std::vector<FacePlace> places(surface.node_count());
  for (int m = surface.face_count() - 1; m >= 0; --m)
    for (int k = 0; k < 3; ++k)
      if (const int node = surface.face_node(k, m); node >= 0)
        places[node] = {surface.face[m], Vector3d::Unit(k)};
  return places;
}

std::vector<FacePlace> places_faced(
    const ContactSurface& part, const ContactSurface& whole,
    const std::vector<FacingPolygon>& polygons) {
  std::map<int, int> number;  // of each face in the part
  for (int m = 0; m < part.face_count(); ++m) number[part.face[m]] = m;
  std::vector<FacePlace> places(part.node_count());
  VectorXd nearness = VectorXd::Constant(part.node_count(), -1);
  for (const FacingPolygon& polygon : polygons) {
    const auto m = number.find(whole.face[polygon.contact_face]);
    if (m == number.end()) continue;
    for (int k = 0; k < 3; ++k) {
      const int node = part.face_node(k, m->second);
      Index corner;
      const double nearest = polygon.own.row(k).maxCoeff(&corner);
      if (node < 0 || nearest <= nearness[node]) continue;
      nearness[node] = nearest;
      places[node] = {polygon.opposite_face, polygon.opposite.col(corner)};
    }
  }
  return places;
}

VectorXd at_places(Stack stack, Expression expression, const SolidPart& part,
                   const std::vector<FacePlace>& places, double otherwise) {
  if (!expression) return VectorXd::Constant(count_of(places), otherwise);
  std::vector<BoundaryPlace<3>> at;
  for (const FacePlace& place : places) at.push_back(on_boundary(part, place));
  return part.elsewhere ? part.elsewhere->values(expression, part.body, at)
                        : at_boundary(stack, expression, part, at);
}

}  // namespace ffcontact::plugin
