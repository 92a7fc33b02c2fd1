// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/face_fields.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/interface/traction_parts.hpp"

namespace ffcontact {

namespace {

/// Directions that differ by less are the same but for rounding [rad].
constexpr double least_turn = 1e-11;
/// In parts of the vector.
constexpr double rounding_of_component = 1e-15;

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

double largest_turn(const Matrix3Xd& normals) {
  double largest = 0;
  for (Index i = 0; i < normals.cols(); ++i)
    for (Index j = 0; j < i; ++j) {
      const double half = (normals.col(i) - normals.col(j)).norm() / 2;
      largest = std::max(largest, 2 * std::asin(std::min(1.0, half)));
    }
  return largest > least_turn ? largest : 0;
}

}  // namespace

FaceFields fields_on_face(const ContactSurface& surface,
                          const std::vector<FrictionCone>& cones,
                          int contact_face,
                          const Ref<const VectorXd>& traction) {
  const Vector3i nodes = surface.face_node.col(contact_face);
  const FaceHats hats = face_hats(surface, contact_face);
  const Matrix3d none = Matrix3d::Zero();
  FaceFields fields{none, none, {}, {}};
  fields.cone.resize(3);
  Index a = 0;  // hats of the corners that are nodes, in their order
  for (int k = 0; k < 3; ++k) {
    const int node = nodes[k] >= 0 ? nodes[k] : nodes.maxCoeff();
    fields.normal.col(k) = surface.normal.col(node);
    fields.traction.col(k) = surface.frame(node) * traction.segment<3>(3 * k);
    if (nodes[k] < 0) continue;
    const double bound = cones[node].bound(traction[3 * k]);
    for (int corner = 0; corner < 3; ++corner)
      fields.cone[corner].cohesion += hats.hat(corner, a) * bound;
    ++a;
  }
  return fields;
}

void note(const FaceFields& fields, const Matrix3Xd& normals_of_nodes, int face,
          BetweenNodes& found) {
  bool matters = !fields.traction.isZero(0);
  const MatrixXd points = tested_points(fields.normal.cols());
  for (const auto& weights : points.colwise()) {
    const Vector3d n = (fields.normal * weights).normalized(),
                   r = fields.traction * weights, w = fields.motion * weights;
    const double rn = r.dot(n), wn = w.dot(n);
    const Vector3d rt = r - rn * n, wt = w - wn * n;
    const double slip = wt.norm();
    double f = rt.dot(wt) + rn * wn;
    // with a large mu what carries r_t may be less than the rounding of r . n
    const double pressing = rn - rounding_of_component * r.norm();
    if (slip > 0)
      f += cone_between(fields.cone, weights).bound(pressing) * slip;
    matters = matters || wn > 0;
    found.note_integrand(f, face);
  }
  if (matters) found.note_turn(largest_turn(normals_of_nodes), face);
}

}  // namespace ffcontact
