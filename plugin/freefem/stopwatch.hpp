// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace ffcontact::plugin {

/// Seconds on a wall clock, with fractions: FreeFEM's time() counts whole seconds, its
/// clock() and CPUtime() add up those of all threads.
inline double wallclock() {
  return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// Seconds since it was made.
class Stopwatch {
 public:
  double seconds() const { return wallclock() - start_; }

 private:
  double start_ = wallclock();
};

}  // namespace ffcontact::plugin
