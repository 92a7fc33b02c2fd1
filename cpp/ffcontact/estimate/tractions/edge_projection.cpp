// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/edge_projection.hpp"

#include <Eigen/Cholesky>

#include "ffcontact/base/over.hpp"
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"
#include "ffcontact/linear/dense/congruent.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"
#include "ffcontact/linear/dense/products.hpp"
#include "ffcontact/linear/minimum/quadratic_minimum.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Conditions that are met with equality to this part of the tractions hold the
/// projection.
constexpr double tight = 1e-11;

/// Basis of the end values that friction leaves free.
MatrixXd free_end_values(const EdgeCone& cone) {
  MatrixXd basis = MatrixXd::Zero(4, 4 - cone.frictionless.count());
  for (int k = 0, column = 0; k < 4; ++k)
    if (k % 2 == 0 || !cone.frictionless[k / 2]) basis(k, column++) = 1;
  return basis;
}

/// (-1, -sign mu) at each end.
MatrixXd rays_of_slip(const ConesAtEnds& cones, int sign) {
  MatrixXd basis = MatrixXd::Zero(4, 2);
  for (int end = 0; end < 2; ++end)
    basis.block<2, 1>(2 * end, end) =
        Vector2d(-1, -sign * cones[end].friction).normalized();
  return basis;
}

/// Basis of the end values that are left.
MatrixXd basis_of(const ConesAtEnds& cones, const EdgeCone& cone,
                  Carrying carrying) {
  if (carrying == Carrying::slip_forward) return rays_of_slip(cones, 1);
  if (carrying == Carrying::slip_backward) return rays_of_slip(cones, -1);
  const MatrixXd free = free_end_values(cone);
  if (carrying == Carrying::any) return free;
  if (cones[0].depends_on_contact() || cone.frictionless.all())
    return MatrixXd(4, 0);
  MatrixXd tangential = free;
  tangential.row(0).setZero();
  tangential.row(2).setZero();
  return tangential(Eigen::all, numbers_where(free.cols(), [&](int k) {
                      return !tangential.col(k).isZero(0);
                    }));
}

/// On a ray r_n <= 0 is all that there is.
EdgeCone conditions_on(EdgeCone cone, Carrying carrying) {
  if (carrying != Carrying::slip_forward && carrying != Carrying::slip_backward)
    return cone;
  cone.C = Matrix<double, 2, 4>::Zero();
  cone.C(0, 0) = cone.C(1, 2) = -1;
  cone.d = Vector2d::Zero();
  return cone;
}

}  // namespace

EndValues motions_on_edge(const ContactLine& line, const MatrixXd& motions,
                          int e) {
  EndValues jumps(4, motions.cols()), values(4, motions.cols());
  for (int end = 0; end < 2; ++end) {
    const int node = line.edge_node(end, e);
    jumps.middleRows<2>(2 * end) = jump_at(line, node, motions);
    values.middleRows<2>(2 * end) =
        line.frame(node).transpose() * jumps.middleRows<2>(2 * end);
  }
  if (!turns(line, e)) return values;
  return mass_of(line, e).llt().solve(moments_of_ends(line, e).transpose() *
                                      jumps);
}

Matrix4d mass_of(const ContactLine& line, int e) {
  Matrix4d mass = 2 * Matrix4d::Identity();
  mass.topRightCorner<2, 2>().setIdentity();
  mass.bottomLeftCorner<2, 2>().setIdentity();
  return line.length[e] / 6 * mass;
}

EdgeProjection::EdgeProjection(const ContactLine& line,
                               const ContactLaw<2>& law,
                               const MatrixXd& motions, int e,
                               Carrying carrying)
    : line_(line),
      law_(law),
      edge_(e),
      cone_(conditions_on(edge_cone(line, law, e), carrying)),
      mass_(mass_of(line, e)),
      motions_(motions_on_edge(line, motions, e)),
      basis_(basis_of(least_cones(line, law, e), cone_, carrying)),
      free_mass_(congruent(mass_, basis_)),
      half_(free_mass_),
      moving_(half_.half_solve(transposed_product(mass_ * basis_, motions_))) {}

Vector4d EdgeProjection::operator()(const Vector4d& r) const {
  if (basis_.cols() == 0) return Vector4d::Zero();
  const auto y = quadratic_minimum(free_mass_, -basis_.transpose() * mass_ * r,
                                   product(cone_.C, basis_), cone_.d);
  return y ? clamped_to_cone(line_, law_, edge_, basis_ * *y)
           : Vector4d::Zero();
}

MatrixXd EdgeProjection::slope(const Vector4d& r,
                               const Vector4d& outside) const {
  if (basis_.cols() == 0)
    return MatrixXd::Zero(motions_.cols(), motions_.cols());
  return transposed_product(moving_, moving_on_face(held(r, outside)));
}

std::vector<int> EdgeProjection::held(const Vector4d& r,
                                      const Vector4d& outside) const {
  const double scale = max_norm(outside) + max_norm(cone_.d);
  return numbers_where(cone_.d.size(), [&](int row) {
    return cone_.C.row(row).dot(r) - cone_.d[row] <= tight * scale;
  });
}

MatrixXd EdgeProjection::moving_on_face(const std::vector<int>& held) const {
  if (held.empty()) return moving_;
  const MatrixXd normals =
      half_.half_solve(product(cone_.C(held, Eigen::all), basis_).transpose());
  return moving_ - product(normals, least_squares_of_columns(normals, moving_));
}

}  // namespace ffcontact
