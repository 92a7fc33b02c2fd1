// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/condensed/condensed_contact.hpp"
#include "ffcontact/linear/dense/cholesky.hpp"

namespace ffcontact {

/// How the constant of Coulomb's law sees the slip phi of a line or a surface: as
///     v_n = weight phi,    |v|^2 = v_n' S_nn v_n                    for v with v_t = 0 on it,
///     |phi|^2 = phi' G phi,   G = S_tt - S_tn S_nn^-1 S_nt          with u_n left free,
/// where phi are the tangential components that may differ between two solutions. With
/// the factor of S, normal rows first, S = L L', these are S_nn = L_nn L_nn', G = L_tt
/// L_tt'. Bodies that only contact holds make S singular; 1e-10 of its diagonal is added.
class SlipForms {
 public:
  /// @param weight       of each node what one unit of phi along t, or t1 and t2, adds to
  ///                     v_n there [dim - 1 x p]
  /// @param is_left_out  1 for nodes where phi is 0 [p]
  /// @return nothing where no v of finite energy exists: a node with a weight whose
  ///         normal dof is prescribed, or at a corner (two nodes on one vertex)
  static std::optional<SlipForms> of(const CondensedContact& contact,
                                     const MatrixXd& weight,
                                     const Flags& is_left_out);

  /// max over phi of |v| / |phi|; infinite where a motion without energy changes phi so
  /// that v has some.
  double largest_ratio() const;

  /// max over phi of b' phi / |phi|.
  /// @param moments  b, of all nodes [dim - 1 x p]
  double dual_norm(const MatrixXd& moments) const;

 private:
  SlipForms() = default;

  std::vector<int> row_;  ///< of each phi: (dim - 1) node + component
  SparseMatrix weight_;   ///< [normal rows x phi]
  Cholesky factor_;       ///< of S, normal rows first
};

}  // namespace ffcontact
