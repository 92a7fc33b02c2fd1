// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// min |G x - b|^2 over x >= 0, by the active-set method of Lawson and Hanson (Solving
/// Least Squares Problems, ch. 23). At the solution the residual r = b - G x obeys G' r
/// <= 0 with equality where x > 0 (up to rounding).
/// @param G  [m x n], columns of comparable length
/// @return x [n]
VectorXd nonnegative_least_squares(const MatrixXd& G, const VectorXd& b);

}  // namespace ffcontact
