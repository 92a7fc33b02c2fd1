// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/row_matrix.hpp"

namespace ffcontact {

/// Refuses a matrix whose dofs are not numbered as in dofs.hpp, but component by component,
/// as blocks of scalar spaces are: all u first, then all v. Entries of A couple vertices of
/// one cell. It is the order by components if vertices that A couples are less than 0.8
/// times as far from each other by it as by dofs.hpp, on average over (at most 10000) rows:
/// 0.75 times on 18 vertices and more, more than once where the order is right.
/// @param A         of one body [d n x d n]
/// @param vertices  of that body [mm, d x n]
/// @throws std::invalid_argument  naming the space to take
void require_order_of_vertices(const RowMatrixView& A,
                               const Ref<const MatrixXd>& vertices);

}  // namespace ffcontact
