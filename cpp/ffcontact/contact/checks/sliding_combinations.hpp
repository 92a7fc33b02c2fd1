// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Combinations of motions on which no contact force works by more than 1e-3 of its size
/// times theirs, one column each.
/// @param traces  traces_of the motions
/// @param work    extreme_forces on them
MatrixXd sliding_combinations(const MatrixXd& traces, const MatrixXd& work);

/// Does a load drive motions by no more than the noise of coordinates does?
bool is_noise(const VectorXd& load, const MatrixXd& motions);

/// The unit vector nearest to the first axis and across the columns of a matrix [dim]; the
/// axis itself where it is across them to rounding, or where they span all there is.
VectorXd first_axis_across(const MatrixXd& columns);

}  // namespace ffcontact
