// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ffcontact {

/// The routines of BLAS and LAPACK for a scalar, double or float, as Fortran has them.
template <class Scalar>
struct Blas;

}  // namespace ffcontact

// clang-format off
// NOLINTBEGIN(bugprone-macro-parentheses): types need none
#define FFCONTACT_BLAS(Scalar, letter)                                                           \
  extern "C" {                                                                                   \
  void letter##gemm_(const char* transpose_a, const char* transpose_b, const int* rows,          \
                     const int* columns, const int* depth, const Scalar* alpha, const Scalar* a, \
                     const int* stride_a, const Scalar* b, const int* stride_b,                  \
                     const Scalar* beta, Scalar* c, const int* stride_c);                        \
  void letter##gemv_(const char* transpose, const int* rows, const int* columns,                 \
                     const Scalar* alpha, const Scalar* a, const int* stride_a, const Scalar* x, \
                     const int* step_x, const Scalar* beta, Scalar* y, const int* step_y);       \
  void letter##syrk_(const char* triangle, const char* transpose, const int* n,                  \
                     const int* depth, const Scalar* alpha, const Scalar* a,                     \
                     const int* stride_a, const Scalar* beta, Scalar* c, const int* stride_c);   \
  void letter##trsm_(const char* side, const char* triangle, const char* transpose,              \
                     const char* diagonal, const int* rows, const int* columns,                  \
                     const Scalar* alpha, const Scalar* a, const int* stride_a, Scalar* b,       \
                     const int* stride_b);                                                       \
  void letter##potrf_(const char* triangle, const int* n, Scalar* a, const int* stride,          \
                      int* info);                                                                \
  void letter##potrs_(const char* triangle, const int* n, const int* columns,                    \
                      const Scalar* factor, const int* stride, Scalar* b, const int* stride_b,   \
                      int* info);                                                                \
  void letter##getrf_(const int* rows, const int* columns, Scalar* a, const int* stride,         \
                      int* pivots, int* info);                                                   \
  void letter##laswp_(const int* columns, Scalar* a, const int* stride, const int* first,        \
                      const int* last, const int* pivots, const int* step);                      \
  void letter##gecon_(const char* norm, const int* n, const Scalar* lu, const int* stride,       \
                      const Scalar* norm_of_a, Scalar* rcond, Scalar* work, int* iwork,          \
                      int* info);                                                                \
  void letter##getrs_(const char* transpose, const int* n, const int* columns,                   \
                      const Scalar* lu, const int* stride, const int* pivots, Scalar* b,         \
                      const int* stride_b, int* info);                                           \
  void letter##gelsy_(const int* rows, const int* columns, const int* count, Scalar* a,          \
                      const int* stride_a, Scalar* b, const int* stride_b, int* order,           \
                      const Scalar* rcond, int* rank, Scalar* work, const int* work_size,        \
                      int* info);                                                                \
  void letter##geqrf_(const int* rows, const int* columns, Scalar* a, const int* stride,         \
                      Scalar* factors, Scalar* work, const int* work_size, int* info);           \
  void letter##orgqr_(const int* rows, const int* columns, const int* reflectors, Scalar* a,     \
                      const int* stride, const Scalar* factors, Scalar* work,                    \
                      const int* work_size, int* info);                                          \
  void letter##syev_(const char* vectors, const char* triangle, const int* n, Scalar* a,         \
                     const int* stride, Scalar* values, Scalar* work, const int* work_size,      \
                     int* info);                                                                 \
  void letter##geev_(const char* left, const char* right, const int* n, Scalar* a,               \
                     const int* stride, Scalar* real, Scalar* imaginary, Scalar* left_vectors,   \
                     const int* stride_l, Scalar* right_vectors, const int* stride_r,            \
                     Scalar* work, const int* work_size, int* info);                             \
  void letter##gesvd_(const char* left, const char* right, const int* rows,                      \
                      const int* columns, Scalar* a, const int* stride, Scalar* values,          \
                      Scalar* u, const int* stride_u, Scalar* vt, const int* stride_v,           \
                      Scalar* work, const int* work_size, int* info);                            \
  }                                                                                              \
  namespace ffcontact {                                                                          \
  template <>                                                                                    \
  struct Blas<Scalar> {                                                                          \
    static constexpr auto gemm = letter##gemm_;                                                  \
    static constexpr auto gemv = letter##gemv_;                                                  \
    static constexpr auto syrk = letter##syrk_;                                                  \
    static constexpr auto trsm = letter##trsm_;                                                  \
    static constexpr auto potrf = letter##potrf_;                                                \
    static constexpr auto potrs = letter##potrs_;                                                \
    static constexpr auto getrf = letter##getrf_;                                                \
    static constexpr auto laswp = letter##laswp_;                                                \
    static constexpr auto gecon = letter##gecon_;                                                \
    static constexpr auto getrs = letter##getrs_;                                                \
    static constexpr auto gelsy = letter##gelsy_;                                                \
    static constexpr auto geqrf = letter##geqrf_;                                                \
    static constexpr auto orgqr = letter##orgqr_;                                                \
    static constexpr auto syev = letter##syev_;                                                  \
    static constexpr auto geev = letter##geev_;                                                  \
    static constexpr auto gesvd = letter##gesvd_;                                                \
  };                                                                                             \
  }
// NOLINTEND(bugprone-macro-parentheses)
// clang-format on

FFCONTACT_BLAS(double, d)
FFCONTACT_BLAS(float, s)
#undef FFCONTACT_BLAS
