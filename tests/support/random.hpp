// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Core>
#include <cstdlib>
#include <ostream>
#include <random>

namespace ffcontact::test {

/// RapidCheck takes its seed from the clock unless told otherwise; what the environment says goes first.
inline const bool seed_is_fixed = setenv("RC_PARAMS", "seed=20010323 max_success=60", 0) == 0;

/// Random numbers that tell their seed.
struct Random : std::mt19937 {
  explicit Random(unsigned start) : std::mt19937(start), seed(start) {}
  unsigned seed;
};
inline std::ostream& operator<<(std::ostream& out, const Random& random) {
  return out << "Random(" << random.seed << ")";
}

/// Real numbers in [low, high], in steps of a thousandth of the range; they shrink towards low.
inline rc::Gen<double> real(double low, double high) {
  return rc::gen::map(rc::gen::inRange(0, 1001), [=](int step) { return low + (high - low) * step / 1000; });
}

/// Entries uniform in [-1, 1].
inline Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index cols, std::mt19937& random) {
  std::uniform_real_distribution<double> entry(-1, 1);
  return Eigen::MatrixXd::NullaryExpr(rows, cols, [&] { return entry(random); });
}

inline Eigen::VectorXd random_vector(Eigen::Index size, std::mt19937& random) { return random_matrix(size, 1, random); }

}  // namespace ffcontact::test

template <>
struct rc::Arbitrary<ffcontact::test::Random> {
  static Gen<ffcontact::test::Random> arbitrary() {
    return gen::map(gen::noShrink(gen::inRange(0, 1 << 30)), [](int seed) { return ffcontact::test::Random(seed); });
  }
};
