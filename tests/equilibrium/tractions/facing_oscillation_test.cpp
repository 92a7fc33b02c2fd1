// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/facing_oscillation.hpp"

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

Matrix9d symmetric(Random& random) {
  const Matrix9d A = random_matrix(9, 9, random);
  return A + A.transpose();
}

RC_GTEST_PROP(FacingOscillation, slope_and_form_are_those_of_the_value,
              (Random random)) {
  FacingOscillation<3> beyond;
  for (int contact : {2, 0})
    beyond.parts.push_back(
        {contact, symmetric(random), random_matrix(9, 9, random)});
  beyond.of_moments = symmetric(random);
  beyond.first_moments = random_vector(9, random);
  std::vector<Matrix3d> before(3), after;
  for (Matrix3d& R : before) R = random_matrix(3, 3, random);
  after = before;
  double change = 0;
  for (const auto& part : beyond.parts) {
    const Matrix3d by = random_matrix(3, 3, random);
    after[part.contact] += by;
    change += 2 * beyond.slope(part, before).dot(by.reshaped());
  }
  for (const auto& row : beyond.parts)
    for (const auto& column : beyond.parts) {
      const Vector9d of_row =
                         (after[row.contact] - before[row.contact]).reshaped(),
                     of_column =
                         (after[column.contact] - before[column.contact])
                             .reshaped();
      change += of_row.dot(beyond.form(row, column) * of_column);
    }
  RC_ASSERT(std::abs(beyond.value(after) - beyond.value(before) - change) <
            1e-9 * (1 + std::abs(change)));
}

}  // namespace
}  // namespace ffcontact
