// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Orthonormal combinations of motions, one column each.
struct Combinations {
  /// on which no contact force works by more than 1e-3 of its size times theirs
  MatrixXd sliding;
  MatrixXd others;
};
/// @param traces  traces_of the motions
/// @param work    extreme_forces on them
Combinations sliding_combinations(const MatrixXd& traces, const MatrixXd& work);

/// The largest work of a load on motions, relative to the sum of |b|.
double relative_push(const VectorXd& load, const MatrixXd& motions);

/// Does a load drive motions by no more than the noise of coordinates does?
bool is_noise(const VectorXd& load, const MatrixXd& motions);

/// Coefficients c of motions z whose sum c z as a body force, lumped, does the same work on
/// each of them as a load r:   (sum over v of V_v z_v' z_v) c = z' r.
/// @param volumes  lumped_volumes
VectorXd lumped_coefficients(const VectorXd& volumes, const MatrixXd& motions,
                             const VectorXd& r);

/// The unit vector nearest to the first axis and across the columns of a matrix [dim]; the
/// axis itself where it is across them to rounding, or where they span all there is.
VectorXd first_axis_across(const MatrixXd& columns);

}  // namespace ffcontact
