// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "freefem/body_part.hpp"
#include "freefem/point_evaluator.hpp"

namespace ffcontact::plugin {

/// Evaluates expressions on boundary edges and in triangles.
class PlanePoint : public PointEvaluator {
 public:
  PlanePoint(Stack stack, const BodyPart<2>& part)
      : PointEvaluator(stack), Th_(*part.fem_mesh) {}

  void go_to(const BoundaryPlace<2>& place) {
    int side;
    const int k = Th_.BoundaryElement(place.column, side);
    const Fem2D::Triangle& triangle = Th_[k];
    const Fem2D::Mesh::BorderElement& edge = Th_.bedges[place.column];
    const auto& ends = Fem2D::VerticesOfTriangularEdge[side];
    const bool same = Th_(k, ends[0]) == Th_(edge[0]);
    const R2 first(Fem2D::TriangleHat[ends[0]]),
        second(Fem2D::TriangleHat[ends[1]]),
        hat = first * place.weights[same ? 0 : 1] +
              second * place.weights[same ? 1 : 0];
    const R2 along = triangle.Edge(side);
    const R2 normal = along.perp() / -std::sqrt((along, along));
    point().set(Th_, triangle(hat), hat, triangle, edge.lab, normal, side);
  }
  void go_to_cell(int t, const Vector3d& hats) {
    const Fem2D::Triangle& triangle = Th_[t];
    const R2 hat(hats[1], hats[2]);
    point().set(Th_, triangle(hat), hat, triangle, triangle.lab);
  }

 private:
  const Fem2D::Mesh& Th_;
};

}  // namespace ffcontact::plugin
