// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "point_evaluator.hpp"
#include "solid_views.hpp"

namespace ffcontact::plugin {

/// Evaluates expressions on boundary faces and in tetrahedra.
class SolidPoint : public PointEvaluator {
 public:
  SolidPoint(Stack stack, const SolidPart& solid)
      : PointEvaluator(stack), solid_(solid) {}

  void go_to(const FacePlace& place) {
    const auto vertices =
        solid_.mesh.boundary.col(solid_.faces.boundary_index[place.face]);
    Vector3d weights = Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        if (vertices[j] == solid_.faces.vertices(k, place.face))
          weights[j] = place.coordinates[k];
    go_to_face(place.face, weights);
  }
  /// @param weights  of the vertices of the face's column of SolidMesh::boundary
  void go_to_face(int face, const Vector3d& weights) {
    const Fem2D::Mesh3& Th = solid_.fem_mesh;
    const int element = element_of(face);
    int side;
    const int k = Th.BoundaryElement(element, side);
    R3 hat;
    for (int j = 0; j < 3; ++j)
      hat += weights[j] * R3::KHat[corner_of(k, Th(Th.be(element)[j]))];
    const Fem2D::Tet& tetrahedron = Th[k];
    // Tet::n points inward in some versions of FreeFEM
    const Vector3d n = facet_normal(solid_.mesh, solid_.faces, face);
    point().set(Th, tetrahedron(hat), hat, tetrahedron, Th.be(element).lab,
                R3(n.x(), n.y(), n.z()), side);
  }
  void go_to_tetrahedron(int t, const R3& hat = R3(0.25, 0.25, 0.25)) {
    const Fem2D::Tet& tetrahedron = solid_.fem_mesh[t];
    point().set(solid_.fem_mesh, tetrahedron(hat), hat, tetrahedron,
                tetrahedron.lab);
  }

 private:
  int element_of(int face) const {
    return solid_.faces.boundary_index[face] - solid_.first_boundary;
  }
  int corner_of(int tetrahedron, int vertex) const {
    int corner = 0;
    while (solid_.fem_mesh(tetrahedron, corner) != vertex) ++corner;
    return corner;
  }

  const SolidPart& solid_;
};

}  // namespace ffcontact::plugin
