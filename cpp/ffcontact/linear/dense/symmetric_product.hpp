// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// S x of a symmetric S of some thousand rows, whose lower triangle is read once. The
/// threads of OpenMP share the columns, the digits do not depend on them, as they do with
/// dsymv of BLAS.
VectorXd symmetric_product(const MatrixXd& S, const VectorXd& x);

}  // namespace ffcontact
