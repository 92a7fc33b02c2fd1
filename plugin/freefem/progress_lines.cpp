// SPDX-License-Identifier: GPL-3.0-or-later
#include "freefem/progress_lines.hpp"

#include <memory>

#include "freefem/freefem.hpp"
#include "freefem/stopwatch.hpp"

namespace ffcontact::plugin {

namespace {

constexpr double between_lines = 2;  ///< seconds

/// The lines of one call of a function.
class Lines {
 public:
  Lines(const char* function, int dim) : function_(function), dim_(dim) {}

  void operator()(const Progress& progress) {
    const bool begins = progress.step == 0 && progress.value >= many_dofs(dim_);
    if (!begins && last_.seconds() < between_lines) return;
    last_ = Stopwatch();
    cout << function_ << ": " << progress.phase;
    if (progress.step > 0) cout << " " << progress.step;
    cout << ", " << progress.measure << " " << progress.value << ", "
         << start_.seconds() << " s so far" << endl;
  }

 private:
  const char* function_;
  int dim_;
  Stopwatch start_, last_;
};

}  // namespace

ProgressReport progress_lines(const char* function, long verbosity, int dim) {
  if (verbosity < 1 || mpirank != 0) return {};
  // copies of the report share what was said when
  return [lines = std::make_shared<Lines>(function, dim)](
             const Progress& progress) { (*lines)(progress); };
}

}  // namespace ffcontact::plugin
