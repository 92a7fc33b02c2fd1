// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/traction_parts.hpp"

#include <Eigen/LU>
#include <cmath>

namespace ffcontact {

namespace {

/// int over the unit of area of two linear functions, by their values at the corners.
Matrix3d linear_products() {
  return (Matrix3d::Ones() + Matrix3d::Identity()) / 12;
}

void add_polygon_parts(const FacingPolygon& polygon, double face_area,
                       Matrix3d& own, Matrix3d& opposite) {
  for (const FanTriangle& triangle : fan_of(polygon.own)) {
    const Matrix3d phi = polygon.own(Eigen::all, triangle.corner),
                   eta = polygon.opposite(Eigen::all, triangle.corner),
                   weighted =
                       face_area * triangle.share * phi * linear_products();
    own += weighted * phi.transpose();
    opposite -= weighted * eta.transpose();
  }
}

/// Polygons of one contact face stand together.
void add_facing_parts(const SolidMesh& mesh, const Facets<3>& faces,
                      const ContactSurface& surface,
                      std::vector<TractionPart>& parts) {
  int last = -1;
  std::size_t own = 0;
  for (const FacingPolygon& polygon : surface.polygons) {
    const int m = polygon.contact_face, face = surface.face[m];
    if (m != last) {
      own = parts.size();
      parts.push_back({m, face, Matrix3d::Zero()});
      last = m;
    }
    parts.push_back({m, polygon.opposite_face, Matrix3d::Zero()});
    add_polygon_parts(polygon, facet_measure(mesh, faces, face),
                      parts[own].weight, parts.back().weight);
  }
}

}  // namespace

FaceHats face_hats(const ContactSurface& surface, int contact_face) {
  const Vector3i nodes = surface.face_node.col(contact_face);
  const int count = static_cast<int>((nodes.array() >= 0).count());
  FaceHats hats{{}, Matrix3Xd::Zero(3, count)};
  for (int k = 0; k < 3; ++k) {
    if (nodes[k] < 0)
      hats.hat.row(k).setConstant(1.0 / count);
    else
      hats.hat(k, static_cast<Index>(hats.node.size())) = 1;
    if (nodes[k] >= 0) hats.node.push_back(nodes[k]);
  }
  return hats;
}

Matrix3d traction_at_corners(const ContactSurface& surface, int contact_face,
                             const Ref<const Matrix3Xd>& traction) {
  const FaceHats hats = face_hats(surface, contact_face);
  Matrix3d corners = Matrix3d::Zero();
  for (std::size_t a = 0; a < hats.node.size(); ++a) {
    const Vector3d r = surface.frame(hats.node[a]) * traction.col(hats.node[a]);
    corners += r * hats.hat.col(static_cast<Index>(a)).transpose();
  }
  return corners;
}

std::vector<TractionPart> traction_parts(const SolidMesh& mesh,
                                         const Facets<3>& faces,
                                         const ContactSurface& surface) {
  std::vector<TractionPart> parts;
  if (surface.against_a_body())
    add_facing_parts(mesh, faces, surface, parts);
  else
    for (int m = 0; m < surface.face_count(); ++m) {
      const double area = facet_measure(mesh, faces, surface.face[m]);
      parts.push_back({m, surface.face[m], area * linear_products()});
    }
  return parts;
}

std::vector<FanTriangle> fan_of(const Ref<const Matrix3Xd>& corners) {
  std::vector<FanTriangle> triangles;
  for (int k = 2; k < corners.cols(); ++k) {
    const Vector3i corner(0, k - 1, k);
    const Matrix3d at = corners(Eigen::all, corner);
    triangles.push_back({corner, std::abs(at.determinant())});
  }
  return triangles;
}

}  // namespace ffcontact
