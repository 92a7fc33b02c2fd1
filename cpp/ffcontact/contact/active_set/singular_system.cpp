// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/active_set/singular_system.hpp"

#include <optional>

#include "ffcontact/linear/dense/dense_lu.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"

namespace ffcontact {

namespace {

/// Residual, relative to the right-hand side, up to which a singular system counts as
/// solved.
constexpr double fulfilled = 1e-10;
/// Unknowns from which on single precision with refinement is worth its products.
constexpr Index many = 500;
/// Stiffness, relative to the diagonal, that holds a body which nothing else holds.
constexpr double leash = 1e-8;

}  // namespace

VectorXd solved(const MatrixXd& transposed, const VectorXd& b,
                Index displacements, SystemKind& kind, RefinedSolver& solver) {
  kind = SystemKind::regular;
  if (b.size() == 0) return b;
  if (b.size() >= many)
    if (std::optional<VectorXd> x = solver.solve_transposed(transposed, b))
      return *x;
  MatrixXd A = transposed.transpose();
  const DenseLu lu(A);
  if (lu.reciprocal_condition() > singular_condition) return lu.solve(b);
  const VectorXd smallest = least_squares(A, b, {10 * singular_condition});
  kind = SystemKind::consistent;
  if ((A * smallest - b).norm() <= fulfilled * b.norm()) return smallest;
  kind = SystemKind::inconsistent;
  A.diagonal().head(displacements).array() += leash;
  return DenseLu(A).solve(b);
}

}  // namespace ffcontact
