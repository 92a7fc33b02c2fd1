// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/matrix_free/product_step.hpp"

#include "ffcontact/contact/matrix_free/product_preconditioner.hpp"
#include "ffcontact/linear/iterative/gmres.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

constexpr GmresLimits gmres_limits{1e-4, 150};
/// Residual of GMRES that is of no use.
constexpr double of_no_use = 0.1;

/// The unknowns of the last rows, 0 where that is the condition; P is that of S.
ContactRows start(const ProductEquations& equations, const ContactRows& last) {
  const ProductRelation& relation = equations.relation;
  VectorXd x = VectorXd::Zero(relation.size()),
           q = VectorXd::Zero(relation.E.cols());
  for (int k : equations.unknown) x[k] = last.v[relation.row(k)];
  for (int d : equations.dependent) q[d] = last.P[relation.dependent[d]];
  ContactRows rows = rows_of(relation, x, q);
  for (int row : relation.dependent)
    if (equations.law.is_held(row)) rows.v[row] = 0;
  return rows;
}

/// @param right  scaled, of size 1
GmresResult increment(const ProductEquations& equations, const VectorXd& right,
                      double springs) {
  const ProductPreconditioner preconditioner(equations, springs);
  const Index n = count_of(equations.unknown);
  return gmres(
      [&](const VectorXf& x) -> VectorXf {
        VectorXd y = equations.product(x.cast<double>());
        y.head(n) += springs * x.head(n).cast<double>();
        return y.cast<float>();
      },
      [&](const VectorXf& x) -> VectorXf {
        return preconditioner(x.cast<double>()).cast<float>();
      },
      right.cast<float>(), gmres_limits);
}

void move(const ProductEquations& equations, const VectorXd& by,
          ContactRows& rows) {
  const ContactRows change = equations.increment(by);
  rows.P += change.P;
  rows.v += change.v;
  for (int row : equations.relation.dependent)
    if (equations.law.is_held(row)) rows.v[row] = 0;
}

}  // namespace

ProductStep solve_product_step(const ProductRelation& relation,
                               const SurfaceEquations& law, ContactRows& rows) {
  const ProductEquations equations(relation, law);
  ContactRows next = start(equations, rows);
  const VectorXd right = equations.residual(next);
  const double size = max_norm(right);
  ProductStep step;
  if (!(size > 0)) {
    rows = std::move(next);
    return step;
  }
  for (double springs : {0.0, 1e-4, 1e-2}) {
    const GmresResult found = increment(equations, right / size, springs);
    step.products += found.steps;
    if (!(found.residual < of_no_use) || !found.x.allFinite()) continue;
    move(equations, size * found.x.cast<double>(), next);
    rows = std::move(next);
    return step;
  }
  step.kind = SystemKind::inconsistent;
  return step;
}

}  // namespace ffcontact
