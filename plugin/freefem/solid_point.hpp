// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "freefem/body_part.hpp"
#include "freefem/point_evaluator.hpp"

namespace ffcontact::plugin {

/// Evaluates expressions on boundary faces and in tetrahedra.
class SolidPoint : public PointEvaluator {
 public:
  SolidPoint(Stack stack, const BodyPart<3>& solid)
      : PointEvaluator(stack), solid_(solid), Th_(*solid.fem_mesh) {}

  void go_to(const BoundaryPlace<3>& place) {
    int side;
    const int k = Th_.BoundaryElement(place.column, side);
    R3 hat;
    for (int j = 0; j < 3; ++j)
      hat += place.weights[j] *
             R3::KHat[corner_of(k, Th_(Th_.be(place.column)[j]))];
    const Fem2D::Tet& tetrahedron = Th_[k];
    const Vector3d n = outward_normal(place.column, solid_.first_cell + k);
    point().set(Th_, tetrahedron(hat), hat, tetrahedron,
                Th_.be(place.column).lab, R3(n.x(), n.y(), n.z()), side);
  }
  void go_to_cell(int t, const Vector4d& hats) {
    const Fem2D::Tet& tetrahedron = Th_[t];
    const R3 hat(hats[1], hats[2], hats[3]);
    point().set(Th_, tetrahedron(hat), hat, tetrahedron, tetrahedron.lab);
  }

 private:
  int corner_of(int tetrahedron, int vertex) const {
    int corner = 0;
    while (Th_(tetrahedron, corner) != vertex) ++corner;
    return corner;
  }
  /// Tet::n points inward in some versions of FreeFEM.
  Vector3d outward_normal(int column, int cell) const {
    const int first = solid_.first_boundary;
    for (int k = 0; k < 4; ++k) {
      const int face = solid_.facets.of_cell(k, cell);
      if (solid_.facets.boundary_index[face] == first + column)
        return solid_.facets.eta(k, cell) *
               facet_normal(solid_.mesh, solid_.facets, face);
    }
    return Vector3d::Zero();
  }

  const BodyPart<3>& solid_;
  const Fem2D::Mesh3& Th_;
};

}  // namespace ffcontact::plugin
