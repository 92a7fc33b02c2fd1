// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// P A = L U of a dense square matrix by LAPACK, for A x = b with some thousand unknowns:
/// OpenBLAS uses all of the processor, which Eigen's own factorisation, compiled for
/// every x86-64, does not (2000 unknowns: 0.31 and 0.97 s). Eigen::PartialPivLU with
/// EIGEN_USE_BLAS is as fast, but hands empty matrices to BLAS with a stride of 0, which
/// prints an error on the host's console.
/// @tparam Scalar  double or float
template <class Scalar>
class LapackLu {
 public:
  using Square = Matrix<Scalar, Dynamic, Dynamic>;
  using Column = Matrix<Scalar, Dynamic, 1>;

  /// @param matrix  square, not empty
  explicit LapackLu(Square matrix);

  int size() const { return static_cast<int>(factors_.rows()); }

  /// Estimate of 1 / (|A| |A^-1|) in the 1-norm; 0 if A is singular or not finite.
  Scalar reciprocal_condition() const;

  /// Of the determinant, -1 or 1; rounding's where A is singular.
  int determinant_sign() const;

  /// A^-1 b, for a matrix that is not singular.
  Column solve(Column right) const;
  /// A^-T b
  Column solve_transposed(Column right) const;

 private:
  Column solved(const char* transpose, Column right) const;

  Square factors_;
  VectorXi pivots_;
  Scalar norm_;
};

using DenseLu = LapackLu<double>;

}  // namespace ffcontact
