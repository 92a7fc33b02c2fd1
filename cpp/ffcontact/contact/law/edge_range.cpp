// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/edge_range.hpp"

#include <algorithm>
#include <cmath>

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

void require_valid(const char* name, const EdgeRange& range, int edges) {
  for (const Matrix2Xd* ends : {&range.least, &range.most}) {
    if (ends->size() == 0) continue;
    require_size(name, ends->cols(), edges);
    require_nonnegative(name, ends->reshaped());
  }
}

}  // namespace ffcontact
