// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/contact_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/nodal_law.hpp"
#include "ffcontact/contact/nodal_pressures.hpp"

namespace ffcontact {

namespace {

/// Deviations from the chord below this part of the coefficient are rounding.
constexpr double rounding = 1e-12;

/// The end values of a bound along an edge, which is linear between the nodes where it is
/// not given.
Vector2d at_ends(const ContactLine& line, const Matrix2Xd& bound, const VectorXd& nodal,
                 int edge) {
  if (bound.size() > 0) return bound.col(edge);
  return {nodal[line.edge_node(0, edge)], nodal[line.edge_node(1, edge)]};
}

const VectorXd& coefficient(const ContactLaw& law) {
  return law.tresca() ? law.slip_bound : law.friction;
}

Vector2d unlimited() {
  return Vector2d::Constant(std::numeric_limits<double>::infinity());
}

void require_valid(const char* name, const EdgeRange& range, const ContactLine& line) {
  for (const Matrix2Xd* bound : {&range.least, &range.most}) {
    if (bound->size() == 0) continue;
    require_size(name, bound->cols(), line.edge_count());
    require_nonnegative(name, bound->reshaped());
  }
}

}  // namespace

Vector2d least_coefficient(const ContactLine& line, const ContactLaw& law, int edge) {
  return at_ends(line, law.between_nodes.least, coefficient(law), edge);
}

Vector2d most_coefficient(const ContactLine& line, const ContactLaw& law, int edge) {
  return at_ends(line, law.between_nodes.most, coefficient(law), edge);
}

Vector2d least_shear_limit(const ContactLine& line, const ContactLaw& law, int edge) {
  return law.limited()
             ? at_ends(line, law.limit_between_nodes.least, law.shear_limit, edge)
             : unlimited();
}

Vector2d most_shear_limit(const ContactLine& line, const ContactLaw& law, int edge) {
  return law.limited()
             ? at_ends(line, law.limit_between_nodes.most, law.shear_limit, edge)
             : unlimited();
}

EdgeRange enclosing_range(const Ref<const MatrixXd>& samples) {
  const VectorXd s = VectorXd::LinSpaced(samples.rows(), 0, 1);
  EdgeRange range{Matrix2Xd(2, samples.cols()), Matrix2Xd(2, samples.cols())};
  for (Index e = 0; e < samples.cols(); ++e) {
    const VectorXd values = samples.col(e);
    const Vector2d ends(values[0], values[values.size() - 1]);
    const VectorXd above = values - ends[0] * (1 - s.array()).matrix() - ends[1] * s;
    const bool linear = above.cwiseAbs().maxCoeff() <= rounding * values.maxCoeff();
    range.least.col(e) = linear ? ends : Vector2d(ends.array() + above.minCoeff());
    range.most.col(e) = linear ? ends : Vector2d(ends.array() + above.maxCoeff());
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
    if (law.tresca()) refuse("a shear limit belongs to Coulomb's law, not to Tresca's");
    require_size("shear limit", law.shear_limit.size(), line.node_count());
    require_nonnegative("shear limit", law.shear_limit);
  }
  require_valid("the coefficient between the nodes", law.between_nodes, line);
  require_valid("the shear limit between the nodes", law.limit_between_nodes, line);
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
      const double cosine = turned ? line.normal.col(i).dot(line.normal.col(j)) : 1;
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

Matrix2Xd displacement_against_foundation(const ContactLine& line, const ContactLaw& law,
                                          const Ref<const VectorXd>& displacement) {
  Matrix2Xd trace = contact_components(line, displacement);
  if (law.gap.size() > 0) trace.row(0) -= law.gap.transpose();
  if (law.previous.size() > 0) trace.row(1) -= law.previous.transpose();
  return trace;
}

double complementarity_defect(const ContactLine& line, const ContactLaw& law,
                              const Ref<const VectorXd>& displacement,
                              const Ref<const Matrix2Xd>& multiplier,
                              const LawScales& least, const std::vector<char>& idle) {
  const SparseMatrix W = weight_of_rows(law.multiplier, line);
  VectorXd v = W * displacement_against_foundation(line, law, displacement).reshaped();
  const VectorXd weight =
      weight_matrix(law.multiplier, line) * VectorXd::Ones(line.node_count());
  double largest = displacement.cwiseAbs().maxCoeff();
  if (law.gap.size() > 0) largest = std::max(largest, law.gap.cwiseAbs().maxCoeff());
  if (law.previous.size() > 0)
    largest = std::max(largest, law.previous.cwiseAbs().maxCoeff());
  const double scale = std::max(least.v, largest * weight.maxCoeff());
  for (std::size_t row = 0; row < idle.size(); ++row)
    if (idle[row] && std::abs(v[row]) <= unsteered * scale) v[row] = 0;
  return law_violation(nodal_law(law, line), multiplier.reshaped(), v, {scale, least.P});
}

}  // namespace ffcontact
