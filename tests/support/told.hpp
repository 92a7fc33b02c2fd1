// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "ffcontact/base/progress.hpp"

/// What a computation told of its progress.
namespace ffcontact::test {

/// Those of one phase.
inline std::vector<Progress> of_phase(const std::vector<Progress>& told,
                                      const std::string& phase) {
  std::vector<Progress> chosen;
  for (const Progress& progress : told)
    if (progress.phase == phase) chosen.push_back(progress);
  return chosen;
}

/// Those but for the columns of a factor.
inline std::vector<Progress> without_columns(
    const std::vector<Progress>& told) {
  std::vector<Progress> chosen;
  for (const Progress& progress : told)
    if (std::string(progress.phase).find("column") == std::string::npos)
      chosen.push_back(progress);
  return chosen;
}

/// Do steps rise to the number of columns that each names?
inline bool counts_columns(const std::vector<Progress>& told) {
  int last = 0;
  for (const Progress& progress : told) {
    if (progress.step <= last || progress.step > progress.value) return false;
    last = progress.step;
  }
  return last > 0;
}

}  // namespace ffcontact::test
