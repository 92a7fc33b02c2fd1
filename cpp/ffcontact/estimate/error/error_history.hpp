// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace ffcontact {

/// e^2 from its contact part and the sum of its others: what is below 0, by rounding or in a
/// pair that is not admissible, does not lower it.
inline double square_of_error(double others, double contact) {
  return others + std::max(0.0, contact);
}

/// e before the first and after every step from the last square and what every step took
/// off.
inline std::vector<double> error_history(double last_square,
                                         const std::vector<double>& falls) {
  std::vector<double> squares(falls.size() + 1, last_square);
  for (std::size_t k = falls.size(); k > 0; --k)
    squares[k - 1] = squares[k] + falls[k - 1];
  for (double& square : squares) square = std::sqrt(std::max(0.0, square));
  return squares;
}

}  // namespace ffcontact
