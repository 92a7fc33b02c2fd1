// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/trace_stiffness.hpp"

#include "ffcontact/base/cholesky.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/products.hpp"

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
    if (contact.held.row[contact.dependent[d]]) continue;
    const bool is_free = contact.F(d, d) * stiffness > row_rounding;
    (is_free ? rows.free : rows.following).push_back(d);
  }
  return rows;
}

}  // namespace

TraceStiffness trace_stiffness(const CondensedContact& contact) {
  const DependentRows dependent = dependent_rows(contact);
  const Index f = count_of(contact.primary), d = count_of(dependent.free);
  TraceStiffness traces;
  traces.row = contact.primary;
  traces.S.resize(f + d, f + d);
  traces.S.topLeftCorner(f, f) = contact.S;
  if (d > 0) {
    const Cholesky F(contact.F(dependent.free, dependent.free));
    const MatrixXd E = contact.E(Eigen::all, dependent.free),
                   q_of_v = F.solve_columns(E.transpose());
    traces.S.topLeftCorner(f, f) += product(E, q_of_v);
    traces.S.bottomLeftCorner(d, f) = -q_of_v;
    traces.S.topRightCorner(f, d) = -q_of_v.transpose();
    traces.S.bottomRightCorner(d, d) =
        F.solve_columns(MatrixXd::Identity(d, d));
  }
  for (int k : dependent.free) traces.row.push_back(contact.dependent[k]);
  traces.place = VectorXi::Constant(contact.position.size(), -1);
  for (Index k = 0; k < f + d; ++k)
    traces.place[traces.row[k]] = static_cast<int>(k);
  traces.is_followed.assign(f + d, 0);
  for (int k : dependent.following)
    for (Index j = 0; j < f; ++j)
      if (std::abs(contact.E(j, k)) > row_rounding) traces.is_followed[j] = 1;
  return traces;
}

}  // namespace ffcontact
