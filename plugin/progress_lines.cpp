// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress_lines.hpp"

#include "freefem.hpp"
#include "stopwatch.hpp"

namespace ffcontact::plugin {

namespace {

constexpr double between_lines = 2;  ///< seconds
constexpr double long_phase = 3e5;   ///< dofs

/// The lines of one call of a function.
class Lines {
 public:
  explicit Lines(const char* function) : function_(function) {}

  void operator()(const Progress& progress) {
    const bool begins = progress.step == 0 && progress.value >= long_phase;
    if (!begins && last_.seconds() < between_lines) return;
    last_ = Stopwatch();
    cout << function_ << ": " << progress.phase;
    if (progress.step > 0) cout << " " << progress.step;
    cout << ", " << progress.measure << " " << progress.value << ", "
         << start_.seconds() << " s so far" << endl;
  }

 private:
  const char* function_;
  Stopwatch start_, last_;
};

}  // namespace

ProgressReport progress_lines(const char* function, long verbosity) {
  if (verbosity < 1 || mpirank != 0) return {};
  return Lines(function);
}

}  // namespace ffcontact::plugin
