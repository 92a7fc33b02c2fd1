// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace ffcontact::fuzz {

/// Random numbers that are the same on every machine (splitmix64; Steele, Lea, Flood,
/// OOPSLA 2014).
class Dice {
 public:
  Dice(std::uint64_t seed, std::uint64_t index)
      : state_(seed * 0x9e3779b97f4a7c15 + index * 0xd1342543de82ef95) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  /// In [low, high).
  double real(double low, double high) {
    return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
  }
  /// In [low, high), each power of ten as likely as the next.
  double decades(double low, double high) {
    return std::pow(10.0, real(std::log10(low), std::log10(high)));
  }
  /// In [low, high].
  int integer(int low, int high) {
    return low + static_cast<int>(bits() %
                                  static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(double probability) { return real(0, 1) < probability; }
  template <class Value>
  Value pick(const std::vector<Value>& values) {
    return values[static_cast<std::size_t>(
        integer(0, static_cast<int>(values.size()) - 1))];
  }
  template <class Value>
  void shuffle(std::vector<Value>& values) {
    for (int k = static_cast<int>(values.size()) - 1; k > 0; --k)
      std::swap(values[k], values[integer(0, k)]);
  }

 private:
  std::uint64_t state_;
};

}  // namespace ffcontact::fuzz
