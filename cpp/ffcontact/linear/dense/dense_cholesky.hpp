// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// H = L L' of a large dense symmetric matrix by LAPACK, as DenseLu; for some dozen
/// unknowns Cholesky is faster.
/// @tparam Scalar  double or float
template <class Scalar>
class LapackCholesky {
 public:
  using Square = Matrix<Scalar, Dynamic, Dynamic>;
  using Column = Matrix<Scalar, Dynamic, 1>;

  LapackCholesky() = default;
  /// @param H  square; its lower triangle is read
  explicit LapackCholesky(Square H);

  int size() const { return static_cast<int>(factor_.rows()); }

  bool is_positive_definite() const { return is_positive_definite_; }

  /// H^-1 b, for a matrix that is positive definite.
  Column solve(Column right) const;

 private:
  Square factor_;
  bool is_positive_definite_ = false;
};

using DenseCholesky = LapackCholesky<double>;

}  // namespace ffcontact
