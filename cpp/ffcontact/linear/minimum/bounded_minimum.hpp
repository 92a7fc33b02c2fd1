// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// min x'H x / 2 + h'x subject to low <= x <= high, for some thousand unknowns and H
/// positive definite.
///
/// Face by face: on the free unknowns the step to the minimum, x_F - H_FF^-1 gradient_F,
/// is taken clamped to the bounds if that lowers the function enough, or else up to the
/// first bound it meets; what meets a bound stays there until the minimum of the face is
/// reached. Then all bounds are left at which the gradient points inwards. No face comes
/// back, for the function falls from one minimum to the next, so this ends; from a good
/// start after a few faces.
struct BoundedMinimum {
  VectorXd x;
  int steps = 0;  ///< Cholesky factorisations of H_FF
};

/// @param low, high   low <= high, may be infinite
/// @param start       clamped to the bounds
/// @param most_steps  after which the best x so far comes back
BoundedMinimum bounded_minimum(const MatrixXd& H, const VectorXd& h,
                               const VectorXd& low, const VectorXd& high,
                               const VectorXd& start, int most_steps);

}  // namespace ffcontact
