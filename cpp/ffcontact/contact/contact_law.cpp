// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/contact_law.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

/// Deviations from the chord below this part of the coefficient are rounding.
constexpr double rounding = 1e-12;

void require_valid(const char* name, const EdgeRange& range,
                   const ContactLine& line) {
  for (const Matrix2Xd* bound : {&range.least, &range.most}) {
    if (bound->size() == 0) continue;
    require_size(name, bound->cols(), line.edge_count());
    require_nonnegative(name, bound->reshaped());
  }
}

}  // namespace

EdgeRange enclosing_range(const Ref<const MatrixXd>& samples) {
  const VectorXd s = VectorXd::LinSpaced(samples.rows(), 0, 1);
  EdgeRange range{Matrix2Xd(2, samples.cols()), Matrix2Xd(2, samples.cols())};
  for (Index e = 0; e < samples.cols(); ++e) {
    const VectorXd values = samples.col(e);
    const Vector2d ends(values[0], values[values.size() - 1]);
    const VectorXd above =
        values - ends[0] * (1 - s.array()).matrix() - ends[1] * s;
    const bool linear =
        above.cwiseAbs().maxCoeff() <= rounding * values.maxCoeff();
    range.least.col(e) =
        linear ? ends : Vector2d(ends.array() + above.minCoeff());
    range.most.col(e) =
        linear ? ends : Vector2d(ends.array() + above.maxCoeff());
    if (range.least.col(e).minCoeff() < 0)
      range.least.col(e).setConstant(values.minCoeff());
  }
  return range;
}

void require_valid(const ContactLaw& law, const ContactLine& line) {
  require_size("friction", law.friction.size(), line.node_count());
  require_nonnegative("friction", law.friction);
  if (law.tresca()) {
    require_size("slipbound", law.slip_bound.size(), line.node_count());
    require_nonnegative("slipbound", law.slip_bound);
  }
  if (law.limited()) {
    if (law.tresca())
      refuse("a shear limit belongs to Coulomb's law, not to Tresca's");
    require_size("shear limit", law.shear_limit.size(), line.node_count());
    require_nonnegative("shear limit", law.shear_limit);
  }
  require_valid("the coefficient between the nodes", law.between_nodes, line);
  require_valid("the shear limit between the nodes", law.limit_between_nodes,
                line);
  if (law.gap.size() > 0) {
    require_size("gap", law.gap.size(), line.node_count());
    require_finite("gap", law.gap);
  }
  if (law.previous.size() > 0) {
    require_size("previous tangential displacement", law.previous.size(),
                 line.node_count());
    require_finite("previous tangential displacement", law.previous);
  }
}

SparseMatrix weight_matrix(Multiplier multiplier, const ContactLine& line) {
  if (multiplier == Multiplier::pressure) return contact_mass(line);
  SparseMatrix identity(line.node_count(), line.node_count());
  identity.setIdentity();
  return identity;
}

SparseMatrix weight_of_rows(Multiplier multiplier, const ContactLine& line) {
  const SparseMatrix W = weight_matrix(multiplier, line);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * W.nonZeros());
  for (int j = 0; j < W.outerSize(); ++j)
    for (SparseMatrix::InnerIterator w(W, j); w; ++w) {
      const int i = static_cast<int>(w.row());
      const bool turned = line.normal.col(i) != line.normal.col(j);
      const double cosine =
          turned ? line.normal.col(i).dot(line.normal.col(j)) : 1;
      const double sine = turned ? line.normal.col(i).dot(line.tangent(j)) : 0;
      for (int c = 0; c < 2; ++c) {
        entries.emplace_back(2 * i + c, 2 * j + c, w.value() * cosine);
        if (turned)
          entries.emplace_back(2 * i + c, 2 * j + 1 - c,
                               (c == 0 ? 1 : -1) * w.value() * sine);
      }
    }
  SparseMatrix rows(2 * W.rows(), 2 * W.cols());
  rows.setFromTriplets(entries.begin(), entries.end());
  return rows;
}

Matrix2Xd displacement_against_foundation(
    const ContactLine& line, const ContactLaw& law,
    const Ref<const VectorXd>& displacement) {
  Matrix2Xd trace = contact_components(line, displacement);
  if (law.gap.size() > 0) trace.row(0) -= law.gap.transpose();
  if (law.previous.size() > 0) trace.row(1) -= law.previous.transpose();
  return trace;
}

double largest_given(const ContactLaw& law) {
  double largest = 0;
  for (const VectorXd* given : {&law.gap, &law.previous})
    if (given->size() > 0)
      largest = std::max(largest, given->cwiseAbs().maxCoeff());
  return largest;
}

double largest_displacement(const ContactLaw& law,
                            const Ref<const VectorXd>& displacement) {
  return std::max(displacement.cwiseAbs().maxCoeff(), largest_given(law));
}

}  // namespace ffcontact
