// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/step_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// What a further step has to gain of the width.
constexpr double worthwhile = 0.02;

/// The best step is left by no more and no less than this.
constexpr double most_change = 8, least_change = 2;

using Widths = std::map<double, double>;

Widths::const_iterator narrowest(const Widths& widths) {
  return std::min_element(
      widths.begin(), widths.end(),
      [](const auto& a, const auto& b) { return a.second < b.second; });
}

/// A / s + B s through two widths.
struct Branch {
  double A, B;

  Branch(const Widths::value_type& a, const Widths::value_type& b) {
    const double slope = a.second * a.first - b.second * b.first;
    B = slope / (a.first * a.first - b.first * b.first);
    A = a.first * (a.second - B * a.first);
  }
  /// Where it has its minimum; 0 or infinite where it falls or rises on.
  double least() const {
    if (A <= 0) return 0;
    return B > 0 ? std::sqrt(A / B) : infinity;
  }
  double at(double s) const { return A / s + B * s; }
};

/// Where a parabola through the logarithms of three widths has its minimum, the one in the
/// middle is the least; 0 where that is not worth it.
double least_of(const Widths::value_type& before,
                const Widths::value_type& best,
                const Widths::value_type& after) {
  const double left = std::log(before.first / best.first),
               right = std::log(after.first / best.first),
               above_left = std::log(before.second / best.second),
               above_right = std::log(after.second / best.second);
  // above = a x^2 + b x
  const double a = (above_right / right - above_left / left) / (right - left),
               b = above_left / left - a * left;
  if (b * b / (4 * a) < worthwhile) return 0;
  return best.first * std::exp(-b / (2 * a));
}

}  // namespace

double StepSearch::next() const {
  const auto best = narrowest(width_), after = std::next(best);
  const double s = best->first, width = best->second;
  if (width <= 0) return 0;
  if (width_.size() == 1) return s / 2;
  if (best == width_.begin())
    return std::clamp(Branch(*best, *after).least(), s / most_change,
                      s / least_change);
  const Branch branch(*std::prev(best), *best);
  const double least = branch.least();
  if (after == width_.end())
    return s < longest_
               ? std::min(std::clamp(least, s * least_change, s * most_change),
                          longest_)
               : 0;
  if (least > s && least < after->first &&
      branch.at(least) < (1 - worthwhile) * width)
    return least;
  return least_of(*std::prev(best), *best, *after);
}

}  // namespace ffcontact
