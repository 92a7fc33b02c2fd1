// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// S with S R = 0 to the last places of its own rows, for motions R that strain nothing.
///
/// Schur's complement has the rounding of the stiffness that it comes from: where a soft
/// part of the body hangs on a stiff one, that is far more than a last place of its own
/// rows, and a body that contact alone holds seems to be held by it. With
/// D = diag(S)^1/2 and the orthonormal Q that spans D R,
///     S <- D (I - Q Q') D^-1 S D^-1 (I - Q Q') D.
/// @param S        symmetric and positive semidefinite but for rounding [n x n]
/// @param motions  R, linearly dependent columns do no harm [n x k]
MatrixXd without_stiffness_of(const MatrixXd& motions, MatrixXd S);

}  // namespace ffcontact
