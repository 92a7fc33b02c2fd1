// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/words.hpp"

/// Refusals: every bad input ends in one sentence that names what was wrong and where.
namespace ffcontact {

/// @throws std::invalid_argument  always, with the parts joined into one sentence
template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream sentence;
  sentence.precision(digits_of_refusals);
  (sentence << ... << parts);
  throw std::invalid_argument(sentence.str());
}

/// @throws std::invalid_argument  if `actual` differs from `expected`
inline void require_size(const std::string& name, Index actual,
                         Index expected) {
  if (actual != expected)
    refuse(name, " has ", actual, " values where ", expected, " are needed");
}

/// @throws std::invalid_argument  naming the first value that is NaN or infinite
inline void require_finite(const std::string& name,
                           const Ref<const VectorXd>& values) {
  if (values.allFinite()) return;
  for (Index k = 0; k < values.size(); ++k)
    if (!std::isfinite(values[k]))
      refuse(name, "[", k, "] is ", values[k], ", not a finite number");
}

/// @throws std::invalid_argument  naming the first value below zero or not finite
inline void require_nonnegative(const std::string& name,
                                const Ref<const VectorXd>& values) {
  for (Index k = 0; k < values.size(); ++k)
    if (!(values[k] >= 0) || !std::isfinite(values[k]))
      refuse(name, " must be finite and not negative, but value ", k, " is ",
             values[k]);
}

}  // namespace ffcontact
