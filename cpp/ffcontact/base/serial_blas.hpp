// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

extern "C" {
int openblas_get_num_threads();
void openblas_set_num_threads(int threads);
}

namespace ffcontact {

/// While it lives, OpenBLAS does not use threads of its own.
class SerialBlas {
 public:
  SerialBlas() { openblas_set_num_threads(1); }
  ~SerialBlas() { openblas_set_num_threads(threads_); }
  SerialBlas(const SerialBlas&) = delete;
  SerialBlas& operator=(const SerialBlas&) = delete;

 private:
  const int threads_ = openblas_get_num_threads();
};

}  // namespace ffcontact
