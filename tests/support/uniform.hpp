// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

/// What std::uniform_real_distribution and std::shuffle make of the numbers that a
/// generator draws depends on the standard library; these do not.
namespace ffcontact::test {

/// Real numbers in [low, high), each of two draws of 32 bits.
struct Uniform {
  double low, high;
  double operator()(std::mt19937& random) const {
    const double first = random(), second = random();
    const double fraction =
        std::min((first + 0x1p32 * second) * 0x1p-64, 1 - 0x1p-53);
    return low + (high - low) * fraction;
  }
};

template <class Value>
void shuffle(std::vector<Value>& values, std::mt19937& random) {
  for (std::size_t left = values.size(); left > 1; --left)
    std::swap(values[left - 1], values[random() % left]);
}

}  // namespace ffcontact::test
