// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// x -> A x of a square matrix that is not at hand.
using LinearMap = std::function<VectorXd(const VectorXd&)>;

/// Largest eigenvalue of a symmetric positive semidefinite A by Lanczos' method with full
/// orthogonalisation (Saad, Numerical Methods for Large Eigenvalue Problems, 6.6): the
/// Ritz value and the residual of its vector, which is less than 1e-8 of it or what 200
/// steps leave.
double largest_eigenvalue(const LinearMap& A, Index size);

/// Largest real eigenvalue of A in (0, below) by Arnoldi's method (ibid., 6.2), where the
/// residual of its Ritz vector is 1e-9 of it after at most 200 steps; 0 if there is none.
/// Up to 200 unknowns none is missed, beyond that those among complex eigenvalues that
/// are farther from 0 may be. A Ritz value is real when its imaginary part is less than
/// 1e-8 of its modulus, and 0 when it is less than 1e-12 of the norm of A.
double largest_real_eigenvalue(const LinearMap& A, Index size, double below);

}  // namespace ffcontact
