// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

extern "C" {
#define FFCONTACT_BLAS(letter, Scalar)                                         \
  void letter##gemm_(const char* transpose_a, const char* transpose_b,         \
                     const int* rows, const int* columns, const int* depth,    \
                     const Scalar* alpha, const Scalar* a,                     \
                     const int* stride_a, const Scalar* b,                     \
                     const int* stride_b, const Scalar* beta, Scalar* c,       \
                     const int* stride_c);                                     \
  void letter##syrk_(const char* triangle, const char* transpose,              \
                     const int* n, const int* depth, const Scalar* alpha,      \
                     const Scalar* a, const int* stride_a, const Scalar* beta, \
                     Scalar* c, const int* stride_c);                          \
  void letter##potrf_(const char* triangle, const int* n, Scalar* a,           \
                      const int* stride, int* info);                           \
  void letter##trsm_(const char* side, const char* triangle,                   \
                     const char* transpose, const char* diagonal,              \
                     const int* rows, const int* columns, const Scalar* alpha, \
                     const Scalar* a, const int* stride_a, Scalar* b,          \
                     const int* stride_b);
FFCONTACT_BLAS(d, double)
FFCONTACT_BLAS(s, float)
#undef FFCONTACT_BLAS
}

namespace ffcontact {

/// The routines of BLAS and LAPACK for a scalar, double or float.
template <class Scalar>
struct Blas;

template <>
struct Blas<double> {
  static constexpr auto gemm = dgemm_;
  static constexpr auto syrk = dsyrk_;
  static constexpr auto potrf = dpotrf_;
  static constexpr auto trsm = dtrsm_;
};

template <>
struct Blas<float> {
  static constexpr auto gemm = sgemm_;
  static constexpr auto syrk = ssyrk_;
  static constexpr auto potrf = spotrf_;
  static constexpr auto trsm = strsm_;
};

}  // namespace ffcontact
