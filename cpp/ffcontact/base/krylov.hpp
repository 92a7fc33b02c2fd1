// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// x -> A x of a square matrix that is not at hand.
using LinearMap = std::function<VectorXd(const VectorXd&)>;

/// Largest eigenvalue of a symmetric positive semidefinite A by Lanczos' method with full
/// orthogonalisation (Saad, Numerical Methods for Large Eigenvalue Problems, 6.6), from
/// below: steps are taken until the residual of the Ritz vector is 1e-8 of the Ritz
/// value, or 200; with as many steps as unknowns it is exact. 0 where A has none.
double largest_eigenvalue(const LinearMap& A, Index size);

/// Largest real eigenvalue of A in (0, below), by Arnoldi's method (ibid., 6.2) until
/// the residual of its Ritz vector is 1e-6 of it, at most 200 steps; 0 if there is none.
/// Complex eigenvalues do not count: a Ritz value is real when its imaginary part is less
/// than 1e-8 of its modulus.
double largest_real_eigenvalue(const LinearMap& A, Index size, double below);

}  // namespace ffcontact
