// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ffcontact {

/// term(0) + ... + term(count - 1) by parts of fixed size: the digits do not depend on
/// the number of threads.
template <class Term>
double parted_sum(int count, const Term& term) {
  constexpr int part = 1024;
  std::vector<double> sums((count + part - 1) / part, 0);
#pragma omp parallel for
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const int first = static_cast<int>(k) * part;
    for (int i = first; i < std::min(count, first + part); ++i)
      sums[k] += term(i);
  }
  double total = 0;
  for (double sum : sums) total += sum;
  return total;
}

}  // namespace ffcontact
