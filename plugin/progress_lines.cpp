// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress_lines.hpp"

#include <chrono>

#include "freefem.hpp"

namespace ffcontact::plugin {

namespace {

constexpr double between_lines = 2;  ///< seconds
constexpr double long_phase = 3e5;   ///< dofs

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point moment) {
  return std::chrono::duration<double>(Clock::now() - moment).count();
}

/// The lines of one call of a function.
class Lines {
 public:
  explicit Lines(const char* function) : function_(function) {}

  void operator()(const Progress& progress) {
    const bool begins = progress.step == 0 && progress.value >= long_phase;
    if (!begins && seconds_since(last_) < between_lines) return;
    last_ = Clock::now();
    cout << function_ << ": " << progress.phase;
    if (progress.step > 0) cout << " " << progress.step;
    cout << ", " << progress.measure << " " << progress.value << ", "
         << seconds_since(start_) << " s so far" << endl;
  }

 private:
  const char* function_;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace

ProgressReport progress_lines(const char* function, long verbosity) {
  if (verbosity < 1 || mpirank != 0) return {};
  return Lines(function);
}

}  // namespace ffcontact::plugin
