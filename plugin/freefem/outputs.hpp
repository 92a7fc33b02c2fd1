// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact::plugin {

/// What a call puts into the script's parameters, by their names.
struct Outputs {
  std::map<std::string, VectorXd> arrays;
  std::map<std::string, std::vector<long>> integers;
  std::map<std::string, double> numbers;
  std::map<std::string, long> counts;
  std::map<std::string, bool> flags;
};

}  // namespace ffcontact::plugin
