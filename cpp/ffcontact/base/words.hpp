// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ffcontact/base/eigen.hpp"

/// Numbers in sentences.
namespace ffcontact {

/// Significant digits of what a refusal names, and of a figure that only tells how large.
constexpr int digits_of_refusals = 10, digits_of_figures = 4;

/// "0.25"
std::string in_digits(double value, int digits = digits_of_figures);

/// The components of a point or a vector: "(0, 1)".
std::string in_words(const Ref<const VectorXd>& x,
                     int digits = digits_of_refusals);

/// The number that a word is, nothing where it is none, or too large for an int.
std::optional<int> whole_number(const std::string& word);

/// "a, b or c", with " or " before the last.
/// @param words  not empty
std::string listed(const std::vector<std::string>& words,
                   const std::string& before_last);

}  // namespace ffcontact
