// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "ffcontact/base/eigen.hpp"

/// Sums, maxima and choices over the numbers 0 .. count - 1.
namespace ffcontact {

/// term(0) + ... + term(count - 1), in this order.
template <class Term>
double sum_over(Index count, const Term& term) {
  double sum = 0;
  for (int k = 0; k < count; ++k) sum += term(k);
  return sum;
}

/// max value(k), at least 0.
template <class Value>
double largest_over(Index count, const Value& value) {
  double largest = 0;
  for (int k = 0; k < count; ++k) largest = std::max(largest, value(k));
  return largest;
}

/// Those that meet the condition, ascending.
template <class Condition>
std::vector<int> numbers_where(Index count, const Condition& condition) {
  std::vector<int> numbers;
  for (int k = 0; k < count; ++k)
    if (condition(k)) numbers.push_back(k);
  return numbers;
}

}  // namespace ffcontact
