// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// min y'Hy / 2 + g'y subject to C y >= d, for a few unknowns and H positive definite.
///
/// With H = L L' and z = L'y + L^-1 g this is the smallest z with C L^-T z >= d + C H^-1
/// g, found by the dual method (Goldfarb, Idnani, Math. Programming 27, 1983): conditions
/// enter one by one, and those met with equality are met to rounding, however small the
/// angle between them (the cone of a small friction coefficient).
/// @return nothing if no y fulfils the conditions, or H is not positive definite
std::optional<VectorXd> quadratic_minimum(const MatrixXd& H, const VectorXd& g,
                                          const MatrixXd& C, const VectorXd& d);

}  // namespace ffcontact
