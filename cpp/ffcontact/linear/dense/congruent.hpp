// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Q' S Q of a symmetric S, column by column: some thousand rows are not copied more than
/// once. The threads of OpenMP share the columns, the digits do not depend on them.
MatrixXd congruent(const MatrixXd& S, const SparseMatrix& Q);

/// The same of a dense Q with some dozen columns.
MatrixXd congruent(const MatrixXd& S, const MatrixXd& Q);

}  // namespace ffcontact
