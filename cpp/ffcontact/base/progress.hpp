// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace ffcontact {

/// What a long computation has come to: a phase that begins (step 0, with its size), or a
/// step of it that has ended.
struct Progress {
  const char* phase;    ///< "factorisation", "Newton", "relaxation", ...
  int step;             ///< from 1, or 0
  const char* measure;  ///< what `value` is: "dofs", "violation", "e", ...
  double value;
};

/// Is called from the thread that called the library, and must not throw.
using ProgressReport = std::function<void(const Progress&)>;

inline void tell(const ProgressReport& report, const Progress& progress) {
  if (report) report(progress);
}

}  // namespace ffcontact
