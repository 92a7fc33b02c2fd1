// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/words.hpp"

/// Refusals: every bad input ends in one sentence that names what was wrong and where.
namespace ffcontact {

/// Input that cannot be used, in one sentence for the user.
struct Refusal : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// A method that cannot go on, in one sentence for the user. Any other exception than
/// these two and std::bad_alloc is a mistake of this library.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The sentence of an exception; what is no sentence of this library is said to be an
/// error of its own, to be reported.
std::string sentence_of(const std::exception& error);

/// @throws Refusal  always
[[noreturn]] void refuse_by(const std::ostringstream& sentence);

/// @throws Refusal  always, with the parts joined into one sentence
template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream sentence;
  sentence.precision(digits_of_refusals);
  (sentence << ... << parts);
  refuse_by(sentence);
}

/// @throws std::invalid_argument  if `actual` differs from `expected`
void require_size(const std::string& name, Index actual, Index expected);

/// @throws std::invalid_argument  naming the first value that is NaN or infinite
void require_finite(const std::string& name, const Ref<const VectorXd>& values);

/// @throws std::invalid_argument  naming the first value below zero or not finite
void require_nonnegative(const std::string& name,
                         const Ref<const VectorXd>& values);

}  // namespace ffcontact
