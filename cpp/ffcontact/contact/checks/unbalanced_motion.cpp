// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/unbalanced_motion.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/over.hpp"
#include "ffcontact/base/words.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"
#include "ffcontact/linear/dense/products.hpp"
#include "ffcontact/linear/dense/symmetric_eigen.hpp"
#include "ffcontact/linear/minimum/nonnegative_least_squares.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Work of less than this part of what it is made of is rounding.
constexpr double rounding = 1e-9;
/// Rows along the motions that contact is to balance count for this much more, and what
/// they leave in the other row is below `nothing`.
constexpr double much = 1e3, nothing = 1e-4;

using Vertices = std::vector<int>;

/// Vertices that a field moves.
template <int dim>
Vertices moved_vertices(const Ref<const VectorXd>& field) {
  return numbers_where(field.size() / dim, [&](int v) {
    return !vector_at<dim>(field, v).isZero(0);
  });
}

template <int dim>
VectorXd translation(const Vertices& part, const VectorOf<dim>& along,
                     Index dofs) {
  VectorXd field = VectorXd::Zero(dofs);
  for (int v : part) vector_at<dim>(field, v) = along;
  return field;
}

/// Motions in an orthonormal basis.
class Balance {
 public:
  explicit Balance(const Pushed& pushed)
      : load_(pushed.load), basis_(orthonormal_basis(pushed.motions)) {
    forces_ = pushed.forces(basis_);
    work_of_load_ = basis_.transpose() * load_;
  }

  /// Do the loads work on a motion, and no contact force against them?
  bool is_unopposed(const VectorXd& field) const {
    if (!is_free(field) || !is_pushed(field)) return false;
    const VectorXd work = forces_.transpose() * coordinates(field);
    return work.size() == 0 ||
           work.minCoeff() >= -rounding * forces_.norm() * field.norm();
  }

  /// The force along a motion that contact has at most while it balances all others;
  /// nothing where it cannot.
  std::optional<double> hold(const VectorXd& field) const {
    if (!is_free(field) || !is_pushed(field)) return std::nullopt;
    const VectorXd c = coordinates(field).normalized();
    const VectorXd contact =
        forces_ * nonnegative_least_squares(weighted(forces_, c),
                                            -weighted(work_of_load_, c));
    const VectorXd left = work_of_load_ + contact;
    const double along = left.dot(c);
    const VectorXd across = left - along * c;
    if (along <= rounding * work_of_load_.norm() ||
        across.norm() > std::sqrt(rounding) * along)
      return std::nullopt;
    return -contact.dot(coordinates(field));
  }

 private:
  VectorXd coordinates(const VectorXd& field) const {
    return basis_.transpose() * field;
  }
  bool is_free(const VectorXd& field) const {
    return field.norm() > 0 && (field - basis_ * coordinates(field)).norm() <=
                                   std::sqrt(rounding) * field.norm();
  }
  bool is_pushed(const VectorXd& field) const {
    return field.dot(load_) > rounding * field.cwiseProduct(load_).lpNorm<1>();
  }
  /// With rows across c that count for much more than that along c.
  static MatrixXd weighted(const MatrixXd& rows, const VectorXd& c) {
    const Eigen::RowVectorXd along = c.transpose() * rows;
    return much * (rows - c * along) + c * along;
  }

  VectorXd load_;
  MatrixXd basis_, forces_;
  VectorXd work_of_load_;
};

/// Main direction of the normals of a part's contact nodes; 0 where there are none.
template <int dim>
VectorOf<dim> main_normal(const Pushed& pushed, const Vertices& part) {
  using Vector = VectorOf<dim>;
  const Index dofs = pushed.load.size();
  MatrixXd normals(pushed.normal_components(pushed.load).size(), dim);
  for (int c = 0; c < dim; ++c)
    normals.col(c) =
        pushed.normal_components(translation<dim>(part, Vector::Unit(c), dofs));
  if (normals.isZero(0)) return Vector::Zero();
  return symmetric_eigen(transposed_product(normals, normals))
      .vectors.col(dim - 1);
}

/// The translations of a part along its contact line and along its normal that the loads
/// push it in.
template <int dim>
std::vector<VectorXd> translations(const Pushed& pushed, const Vertices& part) {
  using Vector = VectorOf<dim>;
  Vector resultant = Vector::Zero();
  for (int v : part) resultant += vector_at<dim>(pushed.load, v);
  const Vector normal = main_normal<dim>(pushed, part);
  const Vector along_normal = normal * normal.dot(resultant);
  std::vector<VectorXd> fields;
  for (const Vector& along : {Vector(resultant - along_normal), along_normal})
    if (along.norm() > rounding * resultant.norm())
      fields.push_back(
          translation<dim>(part, along.normalized(), pushed.load.size()));
  return fields;
}

/// Rotations of a part, either way, about those of its contact vertices that are farthest
/// to either side.
[[maybe_unused]] std::vector<VectorXd> rotations(const Mesh& mesh,
                                                 const Pushed& pushed,
                                                 const Vertices& part) {
  const Index dofs = pushed.load.size();
  const Vector2d normal = main_normal<2>(pushed, part),
                 tangent(-normal.y(), normal.x());
  std::optional<int> first, last;
  const auto at = [&](int v) { return tangent.dot(mesh.vertices.col(v)); };
  for (int v : part) {
    const VectorXd alone = translation<2>({v}, normal, dofs);
    if (pushed.normal_components(alone).isZero(0)) continue;
    if (!first || at(v) < at(*first)) first = v;
    if (!last || at(v) > at(*last)) last = v;
  }
  std::vector<VectorXd> fields;
  for (const std::optional<int>& centre : {first, last})
    for (const double turn : {1.0, -1.0}) {
      if (!centre) continue;
      VectorXd field = VectorXd::Zero(dofs);
      for (int v : part) {
        const Vector2d r = mesh.vertices.col(v) - mesh.vertices.col(*centre);
        vector_at<2>(field, v) = turn * Vector2d(-r.y(), r.x());
      }
      fields.push_back(std::move(field));
    }
  return fields;
}

/// The parts that the motions move.
template <int dim>
std::vector<Vertices> moved_parts(const SimplexMesh<dim>& mesh,
                                  const MatrixXd& motions) {
  // each of these moves one part
  const MatrixXd all =
      free_rigid_motions(mesh, Flags(dim * mesh.vertices.cols(), 0));
  std::vector<Vertices> parts;
  for (Index k = 0; k < all.cols(); k += dim * (dim + 1) / 2) {
    const MatrixXd own = all.middleCols(k, dim * (dim + 1) / 2);
    const VectorXd moved = own.cwiseAbs().rowwise().sum();
    if (transposed_product(own, motions).norm() <=
        rounding * own.norm() * motions.norm())
      continue;
    parts.push_back(moved_vertices<dim>(moved));
  }
  return parts;
}

/// "the body", or, of several, where it is.
template <int dim>
std::string body_in_words(const SimplexMesh<dim>& mesh, const Vertices& part) {
  VectorXi used = VectorXi::Zero(mesh.vertices.cols());
  for (int v : mesh.cells.reshaped()) used[v] = 1;
  if (static_cast<Index>(part.size()) == used.sum()) return "the body";
  auto middle = mesh.origin;
  for (int v : part)
    middle += mesh.vertices.col(v) / static_cast<double>(part.size());
  return "the body about " + in_words(middle, digits_of_figures);
}

template <int dim>
std::string against_in_words(const UnbalancedMotion& motion) {
  if (motion.hold <= nothing * motion.push)
    return ", which neither prescribed displacements nor contact forces oppose";
  const std::string unit = dim == 2 ? " N/mm" : " N";
  return " with " + in_digits(motion.push) + unit +
         ", against which contact has " + in_digits(motion.hold) + unit +
         " at most";
}

}  // namespace

template <int dim>
UnbalancedMotion unbalanced_motion(const SimplexMesh<dim>& mesh,
                                   const Pushed& pushed, VectorXd otherwise) {
  const Balance balance(pushed);
  const std::vector<Vertices> parts = moved_parts(mesh, pushed.motions);
  std::vector<UnbalancedMotion> resisted;
  for (const Vertices& part : parts)
    for (const VectorXd& field : translations<dim>(pushed, part)) {
      if (balance.is_unopposed(field)) return {field};
      const std::optional<double> hold = balance.hold(field);
      if (!hold) continue;
      const double push = field.dot(pushed.load);
      if (*hold <= nothing * push) return {field};
      resisted.push_back({field, push, *hold});
    }
  if constexpr (dim == 2)
    for (const Vertices& part : parts)
      for (const VectorXd& field : rotations(mesh, pushed, part))
        if (balance.is_unopposed(field)) return {field};
  return resisted.empty() ? UnbalancedMotion{std::move(otherwise)}
                          : resisted.front();
}

template <int dim>
void refuse_unbalanced(const SimplexMesh<dim>& mesh,
                       const UnbalancedMotion& motion) {
  const std::vector<Vertices> parts = moved_parts(mesh, motion.field);
  if (parts.empty())
    throw NoEquilibrium("no equilibrium: no contact forces balance the loads",
                        "the body", mesh.cells(0, 0));
  const std::string who = body_in_words(mesh, parts.front());
  throw NoEquilibrium("no equilibrium: the loads push " + who + " in a " +
                          motion_in_words(mesh, motion.field) +
                          against_in_words<dim>(motion),
                      who, parts.front().front());
}

template UnbalancedMotion unbalanced_motion(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const Pushed&, VectorXd);
template void refuse_unbalanced(const SimplexMesh<FFCONTACT_DIMENSION>&,
                                const UnbalancedMotion&);

}  // namespace ffcontact
