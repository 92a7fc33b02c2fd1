// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/face_fields.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

/// Weights of the corners at the points that are tested, one column each.
MatrixXd tested_points(Index corners) {
  constexpr int of_side = 4;
  MatrixXd weights = MatrixXd::Zero(corners, of_side * corners + 1);
  for (Index k = 0; k < corners; ++k)
    for (int quarter = 0; quarter < of_side; ++quarter) {
      const double along = static_cast<double>(quarter) / of_side;
      weights(k, of_side * k + quarter) += 1 - along;
      weights((k + 1) % corners, of_side * k + quarter) += along;
    }
  weights.rightCols<1>().setConstant(1.0 / static_cast<double>(corners));
  return weights;
}

/// The largest angle between two directions, if it is 90 degrees or more.
double too_large_turn(const Matrix3Xd& normals) {
  double least = 1;
  for (Index i = 0; i < normals.cols(); ++i)
    for (Index j = 0; j < i; ++j)
      least = std::min(least, normals.col(i).dot(normals.col(j)));
  return least <= 0 ? std::acos(std::max(-1.0, least)) : 0;
}

}  // namespace

FrictionCone paid_cone(const ContactSurface& surface, int contact_face,
                       FrictionCone cone) {
  if (!normals_differ(surface, contact_face)) return cone;
  const Matrix3Xd normals =
      surface.normal(Eigen::all, face_hats(surface, contact_face).node);
  const Vector3d mean = normals.rowwise().sum().normalized();
  const double least = (mean.transpose() * normals).minCoeff();
  cone.cohesion /= least;
  cone.limit /= least;
  return cone;
}

BentTraction bent_on_face(const ContactSurface& surface, int contact_face,
                          const TractionFields& r) {
  const Vector3i nodes = surface.face_node.col(contact_face);
  if (nodes.minCoeff() < 0)
    return bent_traction(surface, contact_face, r.nodal);
  return bent_traction({surface.frame(nodes[0]), surface.frame(nodes[1]),
                        surface.frame(nodes[2])},
                       of_face(r.on_faces, contact_face));
}

BoundedTraction traction_on_face(const ContactSurface& surface,
                                 const std::vector<FrictionCone>& cones,
                                 int contact_face, const TractionFields& r) {
  const FaceHats hats = face_hats(surface, contact_face);
  const bool all_nodes = hats.node.size() == 3;
  Eigen::RowVector3d bound = Eigen::RowVector3d::Zero();
  for (int a = 0; a < count_of(hats.node); ++a) {
    const int node = hats.node[a];
    const double rn =
        all_nodes ? of_face(r.on_faces, contact_face)(0, a) : r.nodal(0, node);
    bound += paid_cone(surface, contact_face, cones[node]).bound(rn) *
             hats.hat.col(a).transpose();
  }
  return {bent_on_face(surface, contact_face, r), bound};
}

void note(const BoundedTraction& r, const FaceMotion& motion,
          const Matrix3Xd& normals_of_nodes, int face, BetweenNodes& found) {
  constexpr double rounding = 1e-15;  // of components, in parts of the vector
  const auto& [normal, pressing, turned] = r.traction;
  bool matters = !pressing.isZero(0) || !turned.isZero(0);
  const MatrixXd points = tested_points(motion.corners());
  for (const auto& place : points.colwise()) {
    const double rn = pressing * place, depth = motion.depth_at(place),
                 bound = r.bound * place;
    const Vector3d m = turned * place, slip = motion.slip_at(place);
    // with a large mu what carries r_t may be less than the rounding of r_n
    const double wider = (1 + rounding) * bound;
    matters = matters || depth > 0;
    found.note_integrand(wider * slip.norm() - m.dot(slip) + rn * depth, face);
  }
  if (matters) found.note_turn(too_large_turn(normals_of_nodes), face);
}

}  // namespace ffcontact
