// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/contact_law.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Deviations from the chord below this part of the coefficient are rounding.
constexpr double chord_rounding = 1e-12;

/// End values where they are not negative, otherwise the least value at both ends.
Vector2d positive_or(const VectorXd& values, const Vector2d& ends) {
  if (ends.minCoeff() < 0) return Vector2d::Constant(values.minCoeff());
  return ends;
}

/// End values of linear functions.
struct Chords {
  Vector2d least, most;
};

/// Those below and above values on an edge, parallel to the chord of these.
Chords enclosing_chords(const VectorXd& values) {
  const VectorXd s = VectorXd::LinSpaced(values.size(), 0, 1);
  const Vector2d ends(values[0], values[values.size() - 1]);
  const VectorXd above =
      values - ends[0] * (1 - s.array()).matrix() - ends[1] * s;
  if (max_norm(above) <= chord_rounding * values.maxCoeff())
    return {positive_or(values, ends), ends};
  const Vector2d least = ends.array() + above.minCoeff();
  return {positive_or(values, least), ends.array() + above.maxCoeff()};
}

void require_nodal(const char* name, const VectorXd& values,
                   const ContactLine& line) {
  require_size(name, values.size(), line.node_count());
  require_nonnegative(name, values);
}

/// Nothing, or a finite number a node.
void require_given(const char* name, const VectorXd& values,
                   const ContactLine& line) {
  if (values.size() == 0) return;
  require_size(name, values.size(), line.node_count());
  require_finite(name, values);
}

/// Nothing, or end values of every edge.
void require_on_edges(const char* name, const Matrix2Xd& bound,
                      const ContactLine& line) {
  if (bound.size() == 0) return;
  require_size(name, bound.cols(), line.edge_count());
  require_nonnegative(name, bound.reshaped());
}

void require_valid(const char* name, const EdgeRange& range,
                   const ContactLine& line) {
  require_on_edges(name, range.least, line);
  require_on_edges(name, range.most, line);
}

/// Adds the weight of node j in the rows of node i, its directions turned into theirs.
void add_weight(const ContactLine& line, int i, int j, double weight,
                Triplets& entries) {
  const Vector2d n_i = line.normal.col(i);
  const bool turned = n_i != line.normal.col(j);
  const double cosine = turned ? n_i.dot(line.normal.col(j)) : 1,
               sine = turned ? n_i.dot(line.tangent(j)) : 0;
  for (int c = 0; c < 2; ++c) {
    const double sign = c == 0 ? 1 : -1;
    entries.emplace_back(2 * i + c, 2 * j + c, weight * cosine);
    if (turned)
      entries.emplace_back(2 * i + c, 2 * j + 1 - c, sign * weight * sine);
  }
}

}  // namespace

EdgeRange enclosing_range(const Ref<const MatrixXd>& samples) {
  EdgeRange range{Matrix2Xd(2, samples.cols()), Matrix2Xd(2, samples.cols())};
  for (Index e = 0; e < samples.cols(); ++e) {
    const Chords chords = enclosing_chords(samples.col(e));
    range.least.col(e) = chords.least;
    range.most.col(e) = chords.most;
  }
  return range;
}

ContactLaw on_layer(ContactLaw law, const Ref<const Matrix2Xd>& traction) {
  if (!law.layer.given()) return law;
  law.carried = traction;
  const Matrix2Xd moved = law.layer.given_way(law.carried);
  law.gap = beyond<VectorXd>(law.gap, moved.row(0));
  law.previous = beyond<VectorXd>(law.previous, moved.row(1));
  return law;
}

void require_valid(const ContactLaw& law, const ContactLine& line) {
  require_valid(law.layer);
  if (law.layer.given() && law.multiplier == Multiplier::pressure)
    refuse("compliance= is for nodal forces: leave multiplier= out");
  require_nodal("friction", law.friction, line);
  if (law.tresca()) require_nodal("slipbound", law.slip_bound, line);
  if (law.limited() && law.tresca())
    refuse("a shear limit belongs to Coulomb's law, not to Tresca's");
  if (law.limited()) require_nodal("shear limit", law.shear_limit, line);
  require_valid("the coefficient between the nodes", law.between_nodes, line);
  require_valid("the shear limit between the nodes", law.limit_between_nodes,
                line);
  require_given("gap", law.gap, line);
  require_given("previous tangential displacement", law.previous, line);
}

SparseMatrix weight_matrix(Multiplier multiplier, const ContactLine& line) {
  if (multiplier == Multiplier::pressure) return contact_mass(line);
  SparseMatrix identity(line.node_count(), line.node_count());
  identity.setIdentity();
  return identity;
}

SparseMatrix weight_of_rows(Multiplier multiplier, const ContactLine& line) {
  const SparseMatrix W = weight_matrix(multiplier, line);
  Triplets entries;
  entries.reserve(4 * W.nonZeros());
  for (int j = 0; j < W.outerSize(); ++j)
    for (SparseMatrix::InnerIterator w(W, j); w; ++w)
      add_weight(line, static_cast<int>(w.row()), j, w.value(), entries);
  return packed(2 * W.rows(), 2 * W.cols(), entries);
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
  return std::max(max_norm(law.gap), max_norm(law.previous));
}

double largest_displacement(const ContactLaw& law,
                            const Ref<const VectorXd>& displacement) {
  return std::max(max_norm(displacement), largest_given(law));
}

}  // namespace ffcontact
