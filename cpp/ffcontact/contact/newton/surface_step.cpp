// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/newton/surface_step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/linear/dense/dense_lu.hpp"

namespace ffcontact {

namespace {

/// r, where what the unknowns move is 1.
constexpr double proximal = 1e-8;

/// The linear system.
class SurfaceStep {
 public:
  SurfaceStep(const CondensedContact& contact,
              const SurfaceEquations& equations)
      : contact_(contact), equations_(equations) {
    UnknownScales scales = unknown_scales(contact);
    v_scale_ = std::move(scales.v);
    for (int k = 0; k < count_of(contact.primary); ++k)
      if (!equations_.is_fixed(contact.primary[k])) unknown_.push_back(k);
    for (int d = 0; d < count_of(contact.dependent); ++d)
      if (!equations_.is_held(contact.dependent[d])) dependent_.push_back(d);
    for (int d : dependent_) q_scale_.push_back(scales.q[d]);
  }

  SystemKind solve(ContactRows& rows, RefinedSolver& solver) {
    assemble(rows.P);
    SystemKind kind;
    const VectorXd x =
        solved(transposed_, right_, count_of(unknown_), kind, solver);
    if (!x.allFinite()) return SystemKind::inconsistent;
    rows = spread(x);
    // exactly, so that a body without contact has no forces of rounding
    for (int row = 0; row < rows.P.size(); ++row)
      if (equations_.carries_nothing(row / 3)) rows.P[row] = 0;
    return kind;
  }

  std::optional<StepLine> line(const ContactRows& last,
                               const VectorXd& bound_change) {
    assemble(last.P);
    VectorXd x = right_, change = change_of_right(bound_change);
    int orientation = 1;
    if (x.size() > 0) {
      const DenseLu lu(transposed_);
      if (!(lu.reciprocal_condition() > singular_condition)) return {};
      x = lu.solve_transposed(x);
      change = lu.solve_transposed(change);
      orientation = lu.determinant_sign();
    }
    const ContactRows at = spread(x), to = spread(x + change);
    return StepLine{at, {to.P - at.P, to.v - at.v}, orientation};
  }

 private:
  /// P_row = S_k v - g_k - E_k q of a primary row k; S is read by columns, as it is stored.
  void add_force(Index e, int row, double factor) {
    const Index n = count_of(unknown_), q = count_of(dependent_);
    const int k = contact_.position[row];
    auto coefficients = transposed_.col(e);
    if (k < 0) {
      for (Index d = 0; d < q; ++d)
        if (dependent_[d] == -1 - k)
          coefficients[n + d] += factor * q_scale_[d];
      return;
    }
    const auto S_k = contact_.S.col(k);
    for (Index j = 0; j < n; ++j)
      coefficients[j] += factor * S_k[unknown_[j]] * v_scale_[unknown_[j]];
    for (Index d = 0; d < q; ++d)
      coefficients[n + d] -=
          factor * contact_.E(k, dependent_[d]) * q_scale_[d];
    right_[e] += factor * contact_.g[k];
  }

  void add_displacement(Index e, int row, double factor) {
    const Index n = count_of(unknown_), q = count_of(dependent_);
    const int k = contact_.position[row];
    auto coefficients = transposed_.col(e);
    if (k >= 0) {
      const auto place = std::lower_bound(unknown_.begin(), unknown_.end(), k);
      if (place != unknown_.end() && *place == k)
        coefficients[place - unknown_.begin()] += factor * v_scale_[k];
      return;
    }
    const int d = -1 - k;
    const auto E_d = contact_.E.col(d);
    for (Index j = 0; j < n; ++j)
      coefficients[j] += factor * E_d[unknown_[j]] * v_scale_[unknown_[j]];
    for (Index j = 0; j < q; ++j)
      coefficients[n + j] +=
          factor * contact_.F(d, dependent_[j]) * q_scale_[j];
    right_[e] -= factor * contact_.dependent_offset[d];
  }

  void put_equation(Index e, int row, double v_scale, double P_scale) {
    const Equation condition = equations_.equation(row);
    const double scale = equations_.is_fixed(row) ? P_scale : v_scale;
    right_[e] = scale * condition.value;
    for (const Term& term : condition.terms) {
      if (term.P != 0) add_force(e, term.row, scale * term.P);
      if (term.v != 0) add_displacement(e, term.row, scale * term.v);
    }
  }

  void assemble(const VectorXd& last_P) {
    const Index n = count_of(unknown_), q = count_of(dependent_);
    transposed_ = MatrixXd::Zero(n + q, n + q);
    right_ = VectorXd::Zero(n + q);
#pragma omp parallel for
    for (Index e = 0; e < n; ++e)
      put_equation(e, contact_.primary[unknown_[e]], v_scale_[unknown_[e]], 0);
    for (Index d = 0; d < q; ++d) {
      const int row = contact_.dependent[dependent_[d]];
      put_equation(n + d, row, 1 / q_scale_[d], q_scale_[d]);
    }
    add_proximal_terms(last_P);
  }

  VectorXd change_of_right(const VectorXd& bound_change) const {
    const Index n = count_of(unknown_), q = count_of(dependent_);
    VectorXd change(n + q);
    const auto of = [&](int row) {
      return equations_.value_by_bound(row) * bound_change[row / 3];
    };
    for (Index e = 0; e < n; ++e)
      change[e] = v_scale_[unknown_[e]] * of(contact_.primary[unknown_[e]]);
    for (Index d = 0; d < q; ++d)
      change[n + d] = of(contact_.dependent[dependent_[d]]) / q_scale_[d];
    return change;
  }

  /// + r (P - last P) in the equation of a dependent row.
  void add_proximal_terms(const VectorXd& last) {
    const Index n = count_of(unknown_);
    for (Index d = 0; d < count_of(dependent_); ++d) {
      const int row = contact_.dependent[dependent_[d]];
      transposed_(n + d, n + d) += proximal;
      right_[n + d] += proximal * last[row] / q_scale_[d];
    }
  }

  ContactRows spread(const VectorXd& x) const {
    VectorXd v = VectorXd::Zero(contact_.S.rows()),
             q = VectorXd::Zero(contact_.E.cols());
    for (std::size_t j = 0; j < unknown_.size(); ++j)
      v[unknown_[j]] = v_scale_[unknown_[j]] * x[j];
    for (std::size_t d = 0; d < dependent_.size(); ++d)
      q[dependent_[d]] = q_scale_[d] * x[unknown_.size() + d];
    ContactRows rows = rows_of(contact_, v, q);
    for (int row = 0; row < rows.P.size(); ++row) {
      if (equations_.is_held(row)) rows.v[row] = 0;
      if (row % 3 == 0 && equations_.is_open(row / 3)) rows.P[row] = 0;
    }
    return rows;
  }

  const CondensedContact& contact_;
  const SurfaceEquations& equations_;
  VectorXd v_scale_, right_;
  std::vector<int> unknown_, dependent_;
  std::vector<double> q_scale_;
  MatrixXd transposed_;  ///< of the matrix, an equation is a column
};

}  // namespace

SystemKind solve_surface_step(const CondensedContact& contact,
                              const SurfaceEquations& equations,
                              ContactRows& rows, RefinedSolver& solver) {
  return SurfaceStep(contact, equations).solve(rows, solver);
}

std::optional<StepLine> surface_step_line(const CondensedContact& contact,
                                          const SurfaceEquations& equations,
                                          const ContactRows& last,
                                          const VectorXd& bound_change) {
  return SurfaceStep(contact, equations).line(last, bound_change);
}

}  // namespace ffcontact
