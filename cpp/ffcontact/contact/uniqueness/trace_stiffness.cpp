// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/uniqueness/trace_stiffness.hpp"

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/linear/dense/cholesky.hpp"
#include "ffcontact/linear/dense/products.hpp"

namespace ffcontact {

namespace {

/// What moves a row by less than this, beside what moves the primary ones, does not.
constexpr double row_rounding = 1e-9;

/// Columns of E and F of the dependent rows that are not held: those that move by
/// themselves, and those that follow.
struct DependentRows {
  std::vector<int> free, following;
};

DependentRows dependent_rows(const CondensedContact& contact) {
  DependentRows rows;
  const double stiffness = contact.S.diagonal().mean();
  for (int d = 0; d < count_of(contact.dependent); ++d) {
    if (contact.held[contact.dependent[d]]) continue;
    const bool is_free = contact.F(d, d) * stiffness > row_rounding;
    (is_free ? rows.free : rows.following).push_back(d);
  }
  return rows;
}

/// [f + d x f + d], with the rows that move by themselves at the end.
MatrixXd stiffness_of(const CondensedContact& contact,
                      const std::vector<int>& free) {
  const Index f = count_of(contact.primary), d = count_of(free);
  MatrixXd S(f + d, f + d);
  S.topLeftCorner(f, f) = contact.S;
  if (d == 0) return S;
  const Cholesky F(contact.F(free, free));
  const MatrixXd E = contact.E(Eigen::all, free),
                 q_of_v = F.solve_columns(E.transpose());
  S.topLeftCorner(f, f) += product(E, q_of_v);
  S.bottomLeftCorner(d, f) = -q_of_v;
  S.topRightCorner(f, d) = -q_of_v.transpose();
  S.bottomRightCorner(d, d) = F.solve_columns(MatrixXd::Identity(d, d));
  return S;
}

/// Which primary rows others follow.
Flags followed_rows(const CondensedContact& contact,
                    const std::vector<int>& following, Index rows) {
  Flags is_followed(rows, 0);
  for (int k : following)
    for (Index j = 0; j < count_of(contact.primary); ++j)
      if (std::abs(contact.E(j, k)) > row_rounding) is_followed[j] = 1;
  return is_followed;
}

}  // namespace

TraceStiffness trace_stiffness(const CondensedContact& contact) {
  const DependentRows dependent = dependent_rows(contact);
  TraceStiffness traces;
  traces.S = stiffness_of(contact, dependent.free);
  traces.row = contact.primary;
  for (int k : dependent.free) traces.row.push_back(contact.dependent[k]);
  const int rows = count_of(traces.row);
  traces.place = VectorXi::Constant(contact.position.size(), -1);
  for (int k = 0; k < rows; ++k) traces.place[traces.row[k]] = k;
  traces.is_followed = followed_rows(contact, dependent.following, rows);
  return traces;
}

}  // namespace ffcontact
