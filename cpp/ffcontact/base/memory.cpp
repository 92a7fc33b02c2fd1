// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/memory.hpp"

#include <unistd.h>

#include <fstream>
#include <limits>
#include <string>

namespace ffcontact {

double memory_of_the_machine() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<double>(sysconf(_SC_PAGESIZE));
}

double available_memory() {
  constexpr double unit = 1024;
  std::ifstream file("/proc/meminfo");
  std::string name, rest;
  double sum = 0, value = 0;
  while (file >> name >> value && std::getline(file, rest))
    if (name == "MemAvailable:" || name == "SwapFree:") sum += unit * value;
  return sum > 0 ? sum : std::numeric_limits<double>::infinity();
}

}  // namespace ffcontact
