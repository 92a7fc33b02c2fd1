// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/serial_blas.hpp"

#include <mutex>

namespace ffcontact {

namespace {

std::mutex mutex;
int living = 0;   // guarded by mutex, as the next
int threads = 1;  // of OpenBLAS before the first and after the last

}  // namespace

SerialBlas::SerialBlas() {
  const std::lock_guard<std::mutex> lock(mutex);
  if (living++ > 0) return;
  threads = openblas_get_num_threads();
  if (threads > 1) openblas_set_num_threads(1);
}

SerialBlas::~SerialBlas() {
  const std::lock_guard<std::mutex> lock(mutex);
  if (--living == 0 && threads > 1) openblas_set_num_threads(threads);
}

}  // namespace ffcontact
