// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "ffcontact/linear/single.hpp"

namespace ffcontact {

/// x -> A x in single precision.
using SingleMap = std::function<VectorXf(const VectorXf&)>;

struct GmresLimits {
  double tolerance = 1e-4;  ///< of |b - A x| / |b|
  int steps = 40;
};

struct GmresResult {
  VectorXf x;
  int steps = 0;  ///< products with A
  double residual =
      0;  ///< |b - A x| / |b|, as far as rounding lets it be known
};

/// x of A x = b by GMRES with a preconditioner from the right,
///     x = M (A M)^-1 b
/// (Saad, Iterative Methods for Sparse Linear Systems, 9.3.2), orthogonalised twice. The
/// vectors are of single precision, which leaves a residual of some 1e-6 at best: for steps
/// that others correct.
/// @param M  near A^-1
/// @param b  of a size that single numbers have
GmresResult gmres(const SingleMap& A, const SingleMap& M, const VectorXf& b,
                  const GmresLimits& limits = {});

}  // namespace ffcontact
