// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/step_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// What a further step has to promise of the width: where contact changes, it
/// finds more.
constexpr double worthwhile = 0.005;

/// Of the width that a step far below has to promise.
constexpr double far_worth = 0.5;

/// The first step is left by this, the shortest and the longest one by no more
/// and no less than these.
constexpr double first_change = 4, most_change = 8, least_change = 2;

using Widths = std::map<double, double>;
using Width = Widths::value_type;

Widths::const_iterator narrowest(const Widths& widths) {
  return std::min_element(
      widths.begin(), widths.end(),
      [](const auto& a, const auto& b) { return a.second < b.second; });
}

/// A / s + B s through two widths.
struct Branch {
  double A, B;

  Branch(const Width& a, const Width& b) {
    const double slope = a.second * a.first - b.second * b.first;
    B = slope / (a.first * a.first - b.first * b.first);
    A = a.first * (a.second - B * a.first);
  }
  /// Where it has its minimum; 0 or infinite where it falls or rises on.
  double least() const {
    if (A <= 0) return 0;
    return B > 0 ? std::sqrt(A / B) : infinity;
  }
  /// Is it there, and worth it?
  bool leads_between(double from, double to, const Width& best) const {
    const double s = least();
    return from < s && s < to && A / s + B * s < (1 - worthwhile) * best.second;
  }
};

/// Where a parabola through the logarithms of three widths has its minimum, the
/// one in the middle is the least; 0 where that is not worth it.
double least_of(const Width& before, const Width& best, const Width& after) {
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

/// Is it nearer to the best step than to the next one?
bool is_near(double s, const Width& best, const Width& after) {
  return s * s < best.first * after.first;
}

double beside_the_shortest(const Width& best, const Width& after) {
  const Branch branch(best, after);
  const double s = best.first, least = branch.least();
  if (branch.leads_between(s, after.first, best) && is_near(least, best, after))
    return least;
  return std::clamp(least, s / most_change, s / least_change);
}

double beside_the_longest(const Width& before, const Width& best,
                          double longest) {
  const Branch branch(before, best);
  const double s = best.first, least = branch.least();
  if (s < longest)
    return std::min(std::clamp(least, s * least_change, s * most_change),
                    longest);
  return branch.leads_between(before.first, s, best) ? least : 0;
}

double between(const Width& before, const Width& best, const Width& after) {
  const Branch branch(before, best);
  const double least = branch.least(),
               of_parabola = least_of(before, best, after);
  const bool leads = branch.leads_between(best.first, after.first, best),
             comes_first = of_parabola == 0 || is_near(least, best, after);
  return leads && comes_first ? least : of_parabola;
}

}  // namespace

double StepSearch::next() const {
  const double s = nearby();
  return s > 0 ? s : far_below();
}

double StepSearch::nearby() const {
  const auto best = narrowest(width_), after = std::next(best);
  if (best->second <= 0) return 0;
  if (width_.size() == 1) return best->first / first_change;
  if (best == width_.begin()) return beside_the_shortest(*best, *after);
  const auto before = std::prev(best);
  return after == width_.end() ? beside_the_longest(*before, *best, longest_)
                               : between(*before, *best, *after);
}

double StepSearch::far_below() const {
  const auto& [s, width] = *width_.begin();
  const double B = (width - error_ / s) / s;
  if (B <= 0) return 0;
  const double least = std::sqrt(error_ / B),
               promised = 2 * std::sqrt(error_ * B);
  const bool pays = least < s / first_change &&
                    promised < far_worth * narrowest(width_)->second;
  return pays ? least : 0;
}

}  // namespace ffcontact
