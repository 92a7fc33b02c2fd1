// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace ffcontact {

/// e^2 from step to step of a relaxation.
class RelaxationProgress {
 public:
  RelaxationProgress(double elastic, double on_contact)
      : first_(elastic + std::abs(on_contact)), square_(elastic + on_contact) {}

  /// Takes the fall of a step off. @return whether the next one is worth its time
  bool goes_on(double fall, double tightness) {
    const double e_before = e();
    square_ -= fall;
    if (fall <= rounding * first_) return false;
    return e_before - e() >= tightness * e_before;
  }

  double e() const { return std::sqrt(std::max(square_, 0.0)); }

 private:
  /// A step that lowers e^2 by less than this part of what it was at first changes no
  /// digit of it: the rest is rounding.
  static constexpr double rounding = 1e-15;

  double first_, square_;
};

}  // namespace ffcontact
