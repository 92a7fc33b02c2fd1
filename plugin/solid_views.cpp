// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid_views.hpp"

#include "ffcontact/base/require.hpp"
#include "ffcontact/mesh/near_origin.hpp"
//
#include "solid_point.hpp"

namespace ffcontact::plugin {

SolidMesh solid_mesh_of(const Fem2D::Mesh3* fem_mesh) {
  if (!fem_mesh) refuse("the mesh3 is not set");
  const Fem2D::Mesh3& Th = *fem_mesh;
  SolidMesh mesh;
  mesh.vertices.resize(3, Th.nv);
  mesh.cells.resize(4, Th.nt);
  mesh.boundary.resize(3, Th.nbe);
  mesh.boundary_label.resize(Th.nbe);
  for (int v = 0; v < Th.nv; ++v)
    mesh.vertices.col(v) << Th(v).x, Th(v).y, Th(v).z;
  for (int t = 0; t < Th.nt; ++t)
    for (int k = 0; k < 4; ++k) mesh.cells(k, t) = Th(t, k);
  for (int e = 0; e < Th.nbe; ++e) {
    for (int k = 0; k < 3; ++k) mesh.boundary(k, e) = Th(Th.be(e)[k]);
    mesh.boundary_label[e] = Th.be(e).lab;
  }
  require_valid(mesh);
  take_from_near_origin(mesh);
  return mesh;
}

VectorXd at_nodes(Stack stack, Expression expression, const SolidView& solid,
                  const ContactSurface& surface, double otherwise) {
  VectorXd values = VectorXd::Constant(surface.node_count(), otherwise);
  if (!expression) return values;
  std::vector<char> known(surface.node_count(), 0);
  SolidPoint point(stack, solid);
  for (int m = 0; m < surface.face_count(); ++m)
    for (int node : surface.face_node.col(m)) {
      if (known[node]) continue;
      known[node] = 1;
      point.go_to_corner(surface.face[m], surface.vertex[node]);
      values[node] = point.value(expression);
    }
  return values;
}

}  // namespace ffcontact::plugin
