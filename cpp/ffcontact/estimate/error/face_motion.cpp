// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/face_motion.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/estimate/error/between_nodes.hpp"
#include "ffcontact/interface/traction_parts.hpp"

namespace ffcontact {

namespace {

/// Normals, load step before and gap of some nodes.
FaceMotion given_at(const ContactSurface& surface, const ContactLaw<3>& law,
                    const std::vector<int>& nodes) {
  const Index count = static_cast<Index>(nodes.size());
  FaceMotion given{surface.normal(Eigen::all, nodes), Matrix3Xd(3, count),
                   Matrix3Xd::Zero(3, count), Eigen::RowVectorXd::Zero(count)};
  for (Index a = 0; a < count; ++a) {
    const int i = nodes[a];
    if (law.gap.size() > 0) given.gap[a] = law.gap[i];
    if (law.previous.size() > 0)
      given.before.col(a) =
          surface.frame(i).rightCols<2>() * law.previous.col(i);
  }
  return given;
}

/// The largest value at least 0 of a quadratic on a side, by its Bernstein coefficients.
double highest_on_side(double first, double middle, double second) {
  const double rise = middle - first, fall = middle - second;
  const double ends = std::max({0.0, first, second});
  return rise > 0 && fall > 0
             ? std::max(ends, first + rise * rise / (rise + fall))
             : ends;
}

}  // namespace

double FaceMotion::depth(Index k, Index l) const {
  return 0.5 * (normal.col(k).dot(jump.col(l)) +
                normal.col(l).dot(jump.col(k)) - gap[k] - gap[l]);
}

Vector3d FaceMotion::slip(Index k, Index l) const {
  const Vector3d n_k = normal.col(k), n_l = normal.col(l),
                 w_k = jump.col(k) - before.col(k),
                 w_l = jump.col(l) - before.col(l);
  return 0.5 * (n_k.cross(w_l) + n_l.cross(w_k));
}

double FaceMotion::depth_at(const Ref<const VectorXd>& place) const {
  return (normal * place).dot(jump * place) - gap.dot(place);
}

Vector3d FaceMotion::slip_at(const Ref<const VectorXd>& place) const {
  const Vector3d n = normal * place, w = (jump - before) * place;
  return n.cross(w);
}

FaceMotion motion_on_face(const Facets<3>& faces, const ContactSurface& surface,
                          const ContactLaw<3>& law, int contact_face,
                          const MatchingFace& match,
                          const Ref<const VectorXd>& displacement) {
  const Vector3i nodes = surface.face_node.col(contact_face);
  FaceMotion motion =
      given_at(surface, law, std::vector<int>(nodes.begin(), nodes.end()));
  motion.jump = vectors_at<3>(displacement,
                              faces.vertices.col(surface.face[contact_face]));
  for (int k = 0; k < 3 && match.face >= 0; ++k)
    motion.jump.col(k) -=
        vector_at<3>(displacement, faces.vertices(match.corner[k], match.face));
  return motion;
}

FaceMotion motion_on_polygon(const Facets<3>& faces,
                             const ContactSurface& surface,
                             const ContactLaw<3>& law,
                             const FacingPolygon& polygon,
                             const Ref<const VectorXd>& displacement) {
  const int m = polygon.contact_face;
  const FaceHats hats = face_hats(surface, m);
  const FaceMotion at_nodes = given_at(surface, law, hats.node);
  const MatrixXd shares = hats.hat.transpose() * polygon.own;
  return {at_nodes.normal * shares,
          vectors_at<3>(displacement, faces.vertices.col(surface.face[m])) *
                  polygon.own -
              vectors_at<3>(displacement,
                            faces.vertices.col(polygon.opposite_face)) *
                  polygon.opposite,
          at_nodes.before * shares, at_nodes.gap * shares};
}

FaceCosts face_costs(const FaceMotion& motion, const Vector3i& corners,
                     double rounding) {
  Matrix<double, 5, 9> polar;
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 3; ++l) {
      const Vector3d slip = motion.slip(corners[k], corners[l]);
      polar.col(3 * k + l) << motion.depth(corners[k], corners[l]),
          slip_beyond(rounding, slip.norm()), slip;
    }
  const Matrix<double, 5, 3> moments = polar * triple_products();
  return {moments.row(0).transpose(), moments.row(1).transpose(),
          moments.bottomRows<3>()};
}

double deepest_on(const FaceMotion& motion, const Vector3i& corners) {
  Matrix3d polar;
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 3; ++l)
      polar(k, l) = motion.depth(corners[k], corners[l]);
  double deepest = 0;
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3;
    deepest = std::max(deepest,
                       highest_on_side(polar(k, k), polar(k, l), polar(l, l)));
  }
  // inside, where polar * phi is the same in all rows
  const Vector3d phi = polar.fullPivLu().solve(Vector3d::Ones());
  const double sum = phi.sum();
  if (std::isfinite(sum) && sum != 0 && (phi / sum).minCoeff() > 0)
    deepest = std::max(deepest, phi.dot(polar * phi) / (sum * sum));
  return deepest;
}

int deepest_corner(const FaceMotion& motion, const Vector3i& corners) {
  return *std::max_element(corners.begin(), corners.end(), [&](int k, int l) {
    return motion.depth(k) < motion.depth(l);
  });
}

double depth_between(const FaceMotion& motion, Index k, Index l, bool alone) {
  const double cosine = motion.normal.col(k).normalized().dot(
                   motion.normal.col(l).normalized()),
               middle = motion.depth(k, l),
               allowed = std::sqrt(std::max(0.0, -motion.depth(k)) *
                                   std::max(0.0, -motion.depth(l))) /
                         2;
  if (middle <= allowed || cosine <= 0) return 0;
  return alone ? 2 * (middle - allowed) / cosine : middle / (cosine + 0.5);
}

}  // namespace ffcontact
