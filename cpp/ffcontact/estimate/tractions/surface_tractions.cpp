// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/surface_tractions.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/bounded_friction.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/estimate/bodies/clearing.hpp"
#include "ffcontact/estimate/tractions/cone_projection.hpp"
#include "ffcontact/estimate/tractions/damped_newton.hpp"
#include "ffcontact/interface/traction_parts.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Resultants are kept to this part of their terms.
constexpr double resultant_rounding = 1e-14;
/// Resultants that are off by more than this part of their terms are not kept.
constexpr double resultant_missed = 1e-12;

constexpr int most_cone_steps = 100;

/// Rows of node i, [3 p x k]: what units of r along n, t1, t2 there do along [z], so that
/// the resultants of r are its product with them.
MatrixXd weighted_motions(const SolidMesh& mesh, const Facets<3>& faces,
                          const ContactSurface& surface,
                          const MatrixXd& motions) {
  MatrixXd rows = MatrixXd::Zero(3 * surface.node_count(), motions.cols());
  Matrix3Xd unit = Matrix3Xd::Zero(3, surface.node_count());
  for (const TractionPart& part : traction_parts(mesh, faces, surface))
    for (const int node : face_hats(surface, part.contact_face).node)
      for (int c = 0; c < 3; ++c) {
        unit(c, node) = 1;
        const Matrix3d moments =
            along_axes(bent_traction(surface, part.contact_face, unit)) *
            part.weight;
        unit(c, node) = 0;
        for (int k = 0; k < motions.cols(); ++k)
          rows(3 * node + c, k) +=
              moments
                  .cwiseProduct(vectors_at<3>(motions.col(k),
                                              faces.vertices.col(part.face)))
                  .sum();
      }
  return rows;
}

/// The dual problem of nearest_in_cone.
class SurfaceDual {
 public:
  SurfaceDual(std::vector<FrictionCone> cones, const ContactSurface& surface,
              const Ref<const Matrix3Xd>& traction, MatrixXd motions,
              const VectorXd& resultants, const Flags& carries)
      : cones_(std::move(cones)),
        area_(surface.area),
        traction_(traction.reshaped()),
        motions_(std::move(motions)),
        resultants_(resultants),
        carries_(carries) {}

  struct Point {
    VectorXd eta;
    VectorXd r;
    VectorXd off;
    MatrixXd slope;
  };

  Point point_at(const VectorXd& eta) const {
    Point point{eta, traction_, -resultants_,
                MatrixXd::Zero(eta.size(), eta.size())};
    for (std::size_t i = 0; i < cones_.size(); ++i) {
      const auto z = motions_.middleRows<3>(3 * i);
      if (!carries_.empty() && !carries_[i]) {
        point.off += z.transpose() * traction_.segment<3>(3 * i);
        continue;
      }
      const Vector3d outside = traction_.segment<3>(3 * i) + z * eta / area_[i];
      const ConeProjection nearest = cone_projection(cones_[i], outside);
      point.r.segment<3>(3 * i) = nearest.point;
      point.off += z.transpose() * nearest.point;
      point.slope += z.transpose() * nearest.slope * z / area_[i];
    }
    return point;
  }

  Point start() const { return point_at(VectorXd::Zero(resultants_.size())); }

  /// The sizes of the terms of the resultants.
  double scale() const {
    return std::max(
        max_norm(resultants_),
        max_norm(motions_.cwiseAbs().transpose() * traction_.cwiseAbs()));
  }

  const MatrixXd& slope(const Point& point) const { return point.slope; }

 private:
  std::vector<FrictionCone> cones_;
  const VectorXd& area_;
  VectorXd traction_;
  MatrixXd motions_;  ///< weighted_motions
  VectorXd resultants_;
  const Flags& carries_;
};

/// Nodes that touch the foundation and that supports hold along their normals.
Flags held_in_contact(const ContactLaw<3>& law, const ContactSurface& surface,
                      const VectorXd& displacement, const Flags& prescribed) {
  constexpr double rounding = 1e-10;
  const double touching = -rounding * largest_displacement(law, displacement);
  const Matrix3Xd v =
      displacement_against_foundation(surface, law, displacement);
  Flags held(surface.node_count());
  for (int i = 0; i < surface.node_count(); ++i)
    held[i] =
        v(0, i) >= touching &&
        !is_free_along(surface.vertex[i], surface.frame(i).col(0), prescribed);
  return held;
}

/// At each held node the sum of the tractions at the nodes of its faces that are not, and
/// how many they are.
Matrix4Xd sums_beside(const ContactSurface& surface, const Flags& held,
                      const Matrix3Xd& traction) {
  Matrix4Xd sums = Matrix4Xd::Zero(4, traction.cols());
  for (int m = 0; m < surface.face_count(); ++m)
    for (const int i : surface.face_node.col(m))
      for (const int j : surface.face_node.col(m))
        if (held[i] && !held[j]) sums.col(i) += traction.col(j).homogeneous();
  return sums;
}

/// int phi_i over int phi_i n . n_i at each node, as of faces of one size; 1 where the normals
/// are the same.
VectorXd areas_over_projected(const ContactSurface& surface) {
  VectorXd count = VectorXd::Zero(surface.node_count()), projected = count;
  for (const auto& nodes : surface.face_node.colwise())
    for (const int i : nodes)
      for (const int k : nodes) {
        if (i < 0 || k < 0) continue;
        const double weight = i == k ? 2 : 1;
        const bool same = surface.normal.col(i) == surface.normal.col(k);
        count[i] += weight;
        projected[i] +=
            weight *
            (same ? 1 : surface.normal.col(i).dot(surface.normal.col(k)));
      }
  return (projected.array() > 0).select(count.cwiseQuotient(projected), 1);
}

}  // namespace

std::vector<FrictionCone> traction_cones(const ContactLaw<3>& law) {
  std::vector<FrictionCone> cones = law_cones(law);
  for (FrictionCone& cone : cones)
    cone.friction = bounded_friction(cone.friction);
  return cones;
}

Matrix3Xd lumped_tractions(const ContactLaw<3>& law,
                           const ContactSurface& surface,
                           const Ref<const Matrix3Xd>& force) {
  const std::vector<FrictionCone> cones = traction_cones(law);
  const VectorXd larger = areas_over_projected(surface);
  Matrix3Xd traction(3, force.cols());
  for (Index i = 0; i < force.cols(); ++i)
    traction.col(i) =
        cone_projection(cones[i], larger[i] / surface.area[i] * force.col(i))
            .point;
  return traction;
}

Matrix3Xd continued_tractions(const ContactLaw<3>& law,
                              const ContactSurface& surface,
                              const VectorXd& displacement,
                              const Flags& prescribed, Matrix3Xd traction) {
  Flags held = held_in_contact(law, surface, displacement, prescribed);
  const std::vector<FrictionCone> cones = traction_cones(law);
  for (bool goes_on = true; goes_on;) {  // from ring to ring
    const Matrix4Xd beside = sums_beside(surface, held, traction);
    goes_on = false;
    for (int i = 0; i < surface.node_count(); ++i) {
      if (!held[i] || beside(3, i) == 0) continue;
      const Vector3d mean = beside.col(i).head<3>() / beside(3, i);
      traction.col(i) = cone_projection(cones[i], mean).point;
      held[i] = 0;
      goes_on = true;
    }
  }
  return traction;
}

SurfaceTractions tractions_by_face(const ContactSurface& surface,
                                   const Ref<const Matrix3Xd>& traction) {
  SurfaceTractions by_face(9, surface.face_count());
  for (int m = 0; m < surface.face_count(); ++m) {
    const FaceHats hats = face_hats(surface, m);
    const Matrix3d at_vertices =
        traction(Eigen::all, hats.node) * hats.hat.transpose();
    by_face.col(m) = at_vertices.reshaped();
  }
  return by_face;
}

VectorXd resultants_of(const SolidMesh& mesh, const Facets<3>& faces,
                       const ContactSurface& surface,
                       const Ref<const Matrix3Xd>& traction,
                       const MatrixXd& motions) {
  return weighted_motions(mesh, faces, surface, motions).transpose() *
         traction.reshaped();
}

std::optional<Matrix3Xd> nearest_in_cone(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const ContactLaw<3>& law,
    const Ref<const Matrix3Xd>& traction, const MatrixXd& motions,
    const VectorXd& resultants, const Flags& carries) {
  const SurfaceDual dual(traction_cones(law), surface, traction,
                         weighted_motions(mesh, faces, surface, motions),
                         resultants, carries);
  SurfaceDual::Point point = dual.start(), closest = point;
  const double scale = dual.scale();
  DampedNewton newton(dual, surface.area.sum(), scale);
  for (int step = 0; step < most_cone_steps; ++step) {
    if (max_norm(closest.off) <= resultant_rounding * scale) break;
    point = newton.after(point);
    if (point.off.norm() < closest.off.norm()) closest = point;
  }
  if (max_norm(closest.off) > resultant_missed * scale) return std::nullopt;
  return Matrix3Xd(closest.r.reshaped(3, traction.cols()));
}

double cone_violation(const ContactLaw<3>& law,
                      const Ref<const Matrix3Xd>& traction) {
  const std::vector<FrictionCone> cones = traction_cones(law);
  double largest = 0;
  for (Index i = 0; i < traction.cols(); ++i) {
    const double rt = traction.col(i).tail<2>().norm();
    largest = std::max(largest, cones[i].violation(traction(0, i), rt));
  }
  return largest;
}

}  // namespace ffcontact
