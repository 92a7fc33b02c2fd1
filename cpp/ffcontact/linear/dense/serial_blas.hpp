// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

extern "C" {
int openblas_get_num_threads();
void openblas_set_num_threads(int threads);
}

namespace ffcontact {

/// While one lives, OpenBLAS does not use threads of its own, which would split sums by
/// their number: digits do not depend on it. Any thread may make one.
class SerialBlas {
 public:
  SerialBlas();
  ~SerialBlas();
  SerialBlas(const SerialBlas&) = delete;
  SerialBlas& operator=(const SerialBlas&) = delete;
};

}  // namespace ffcontact
