// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/traction_parts.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace ffcontact {

namespace {

void add_polygon_parts(const FacingPolygon& polygon, double face_area,
                       Matrix<double, 9, 3>& own,
                       Matrix<double, 9, 3>& opposite) {
  for (const FanTriangle& triangle : fan_of(polygon.own)) {
    const Matrix3d phi = polygon.own(Eigen::all, triangle.corner),
                   eta = polygon.opposite(Eigen::all, triangle.corner);
    const Matrix<double, 9, 3> weighted = face_area * triangle.share *
                                          products_of_places(phi) *
                                          triple_products();
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
      parts.push_back({m, face, Matrix<double, 9, 3>::Zero()});
      last = m;
    }
    parts.push_back({m, polygon.opposite_face, Matrix<double, 9, 3>::Zero()});
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

namespace {

/// m of (r_n, r_t1, r_t2) in a frame.
Vector3d turned(const Matrix3d& frame, const Vector3d& traction) {
  const Vector3d along = frame.rightCols<2>() * traction.tail<2>();
  return along.cross(frame.col(0));
}

}  // namespace

bool normals_differ(const ContactSurface& surface, int contact_face) {
  const std::vector<int> nodes = face_hats(surface, contact_face).node;
  return std::any_of(nodes.begin(), nodes.end(), [&](int i) {
    return surface.normal.col(i) != surface.normal.col(nodes[0]);
  });
}

bool turns(const ContactSurface& surface) {
  for (int m = 0; m < surface.face_count(); ++m)
    if (normals_differ(surface, m)) return true;
  return false;
}

BentTraction bent_traction(const ContactSurface& surface, int contact_face,
                           const Ref<const Matrix3Xd>& traction) {
  const FaceHats hats = face_hats(surface, contact_face);
  BentTraction at_nodes{surface.normal(Eigen::all, hats.node),
                        traction(0, hats.node), Matrix3Xd(3, hats.node.size())};
  for (std::size_t a = 0; a < hats.node.size(); ++a)
    at_nodes.turned.col(static_cast<Index>(a)) =
        turned(surface.frame(hats.node[a]), traction.col(hats.node[a]));
  const MatrixXd shares = hats.hat.transpose();
  return {at_nodes.normal * shares, at_nodes.pressing * shares,
          at_nodes.turned * shares};
}

BentTraction bent_traction(const std::array<Matrix3d, 3>& frames,
                           const Matrix3d& corners) {
  BentTraction traction{Matrix3Xd(3, 3), corners.row(0), Matrix3Xd(3, 3)};
  for (int k = 0; k < 3; ++k) {
    traction.normal.col(k) = frames[k].col(0);
    traction.turned.col(k) = turned(frames[k], corners.col(k));
  }
  return traction;
}

QuadraticOnFace along_axes(const BentTraction& traction) {
  const auto& [n, rn, m] = traction;
  QuadraticOnFace r;
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 3; ++l) {
      const Vector3d n_k = n.col(k), n_l = n.col(l), m_k = m.col(k),
                     m_l = m.col(l);
      r.col(3 * k + l) =
          0.5 * (rn[k] * n_l + rn[l] * n_k + n_l.cross(m_k) + n_k.cross(m_l));
    }
  return r;
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
      parts.push_back({m, surface.face[m], area * triple_products()});
    }
  return parts;
}

FacePolygons::FacePolygons(const SolidMesh& mesh, const Facets<3>& faces,
                           const ContactSurface& surface)
    : polygons(surface.face_count()), parts(surface.face_count()) {
  for (const FacingPolygon& polygon : surface.polygons)
    polygons[polygon.contact_face].push_back(&polygon);
  for (const TractionPart& part : traction_parts(mesh, faces, surface))
    parts[part.contact_face].push_back(part);
}

bool FacePolygons::cover(int contact_face) const {
  constexpr double nothing_left = 1e-9;
  double share = 0;
  for (const FacingPolygon* polygon : polygons[contact_face])
    share += share_of(polygon->own);
  return std::abs(share - 1) < nothing_left;
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

double share_of(const Ref<const Matrix3Xd>& corners) {
  double share = 0;
  for (const FanTriangle& triangle : fan_of(corners)) share += triangle.share;
  return share;
}

}  // namespace ffcontact
