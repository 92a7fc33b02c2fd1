// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <ostream>
#include <random>
#include <string>

#include "ffcontact/base/eigen.hpp"
#include "support/uniform.hpp"

namespace ffcontact::test {

#ifdef __SANITIZE_ADDRESS__
constexpr int cases_a_property = 20;
#else
constexpr int cases_a_property = 60;
#endif

/// RapidCheck draws a new seed for every run and prints it beside the number of cases a
/// property; with both of them in the environment, RC_PARAMS="seed=... max_success=...",
/// the run is replayed. Of what is said twice the last counts.
inline const bool cases_are_set = [] {
  const char* given = std::getenv("RC_PARAMS");
  const std::string parameters =
      "max_success=" + std::to_string(cases_a_property) + " " +
      (given ? given : "");
  return setenv("RC_PARAMS", parameters.c_str(), 1) == 0;
}();

/// Random numbers that tell their seed.
struct Random : std::mt19937 {
  explicit Random(unsigned start) : std::mt19937(start), seed(start) {}
  unsigned seed;
};
inline std::ostream& operator<<(std::ostream& out, const Random& random) {
  return out << "Random(" << random.seed << ")";
}

/// Real numbers in [low, high], in steps of a thousandth of the range; they shrink
/// towards low.
inline rc::Gen<double> real(double low, double high) {
  return rc::gen::map(rc::gen::inRange(0, 1001), [=](int step) {
    return low + (high - low) * step / 1000;
  });
}

/// Entries uniform in [-1, 1].
inline MatrixXd random_matrix(Index rows, Index cols, std::mt19937& random) {
  const Uniform entry{-1, 1};
  return MatrixXd::NullaryExpr(rows, cols, [&] { return entry(random); });
}

inline VectorXd random_vector(Index size, std::mt19937& random) {
  return random_matrix(size, 1, random);
}

}  // namespace ffcontact::test

template <>
struct rc::Arbitrary<ffcontact::test::Random> {
  static Gen<ffcontact::test::Random> arbitrary() {
    return gen::map(gen::noShrink(gen::inRange(0, 1 << 30)),
                    [](int seed) { return ffcontact::test::Random(seed); });
  }
};
