// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <omp.h>

#include "ffcontact/linear/dense/serial_blas.hpp"

namespace ffcontact::test {

/// While it lives, OpenMP and OpenBLAS have so many threads.
class Threads {
 public:
  explicit Threads(int count) { set(count, count); }
  ~Threads() { set(openmp_, openblas_); }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

 private:
  static void set(int openmp, int openblas) {
    omp_set_num_threads(openmp);
    openblas_set_num_threads(openblas);
  }

  const int openmp_ = omp_get_max_threads(),
            openblas_ = openblas_get_num_threads();
};

/// What f answers with so many threads.
template <class Function>
auto on_threads(int count, Function&& f) {
  const Threads threads(count);
  return f();
}

}  // namespace ffcontact::test
