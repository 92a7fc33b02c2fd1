// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/elastic/row_matrix.hpp"

namespace ffcontact {

/// 1 where the row of A, as FreeFEM assembles it, prescribes its dof: where it is
/// penalised (tgv = 1e30: the diagonal exceeds the rest of the row by 1e12) or has
/// nothing but a diagonal (tgv = -1 or -2). With -2 a free dof whose neighbours are all
/// prescribed has nothing but a diagonal either: its stiffness, where the others have 1.
/// @throws std::invalid_argument  if a matrix of the last kind was scaled and has free
///                                dofs without free neighbours
Flags prescribed_dofs(const RowMatrixView& A);

/// Whether A has the columns of prescribed dofs (tgv = -2 takes them away): one that
/// couples shows that the others were kept, too.
bool has_columns(const RowMatrixView& A, const Flags& prescribed);

}  // namespace ffcontact
