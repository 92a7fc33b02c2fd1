// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

/// Products of dense matrices whose sizes are known when they run. They are compiled once:
/// Eigen's blocked kernels take the compiler a second in each file that multiplies.
namespace ffcontact {

/// A B
MatrixXd product(const Ref<const MatrixXd>& A, const Ref<const MatrixXd>& B);

/// A' B
MatrixXd transposed_product(const Ref<const MatrixXd>& A,
                            const Ref<const MatrixXd>& B);

/// M += A A'
void add_square(const Ref<const MatrixXd>& A, MatrixXd& M);

}  // namespace ffcontact
