// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ffcontact/linear/iterative/krylov.hpp"

namespace ffcontact {

struct ConjugateGradientLimits {
  double tolerance;  ///< of |b - A x| / |b|
  int steps;
};

/// x of A x = b by conjugate gradients with a preconditioner (Saad, Iterative Methods for
/// Sparse Linear Systems, 9.2), A and M symmetric and positive definite.
/// @param M  near A^-1
/// @return nothing where the steps are not enough or a number is not finite
std::optional<VectorXd> conjugate_gradients(
    const LinearMap& A, const LinearMap& M, const VectorXd& b,
    const ConjugateGradientLimits& limits);

}  // namespace ffcontact
