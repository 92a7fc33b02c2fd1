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

/// Where A / s + B s through two widths has its minimum; 0 or infinite where that falls or
/// rises on.
double least_of(const Widths::value_type& a, const Widths::value_type& b) {
  const double slope = a.second * a.first - b.second * b.first,
               B = slope / (a.first * a.first - b.first * b.first),
               A = a.first * (a.second - B * a.first);
  if (A <= 0) return 0;
  return B > 0 ? std::sqrt(A / B) : infinity;
}

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
  const auto best = narrowest(width_);
  const double s = best->first;
  if (best->second <= 0) return 0;
  if (width_.size() == 1) return s / 2;
  if (best == width_.begin())
    return std::clamp(least_of(*best, *std::next(best)), s / most_change,
                      s / least_change);
  if (std::next(best) != width_.end())
    return least_of(*std::prev(best), *best, *std::next(best));
  const double longer = std::clamp(least_of(*std::prev(best), *best),
                                   s * least_change, s * most_change);
  return s < longest_ ? std::min(longer, longest_) : 0;
}

}  // namespace ffcontact
