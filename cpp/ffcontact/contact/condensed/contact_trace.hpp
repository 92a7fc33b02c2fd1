// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// How the free dofs of the contact boundary and of what it faces move it.
struct ContactTrace {
  int dimension = 2;  ///< rows of a node
  /// free dofs of the contact and opposite vertices, the unknowns of CondensedStiffness
  std::vector<int> kept_dofs;
  /// displacement of the kept dofs = to_kept (w, w_o) [kept x f + o]
  SparseMatrix to_kept;
  SparseMatrix A;  ///< v of all rows = A (w, w_o) + v_prescribed [rows x f + o]
  /// v of the prescribed values, gap and previous displacement included [rows]
  VectorXd v_prescribed;
  /// loads on w_o beside those of the body [o]; empty: none
  VectorXd opposite_load{};
  /// 1 / c of the springs of a compliant layer, the last of w_o, each of which moves one row
  /// [l]; empty: none (add_layer)
  VectorXd layer_stiffness{};
  /// unheld_motions of the kept dofs [kept x k]; none: S may have stiffness of rounding
  /// against them
  MatrixXd free_motions{};
};

}  // namespace ffcontact
