// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

namespace ffcontact {

/// Looks for the step s at which bounds are the narrowest. Their width has one minimum: it is
/// near A / s + B s, and grows faster where s changes what is in contact.
class StepSearch {
 public:
  /// @param longest  that is of use
  explicit StepSearch(double longest) : longest_(longest) {}

  void add(double s, double width) { width_[s] = width; }
  /// The next step to be tried: a quarter of the first one; that at which A / s + B s through
  /// the best one and its neighbour is least, which is the shorter one if there is; before
  /// that, where it is nearer to the longer neighbour, that at which a parabola through the
  /// logarithms of the best one and both neighbours is.
  /// @return 0 where none promises what is worth it
  double next() const;

 private:
  double longest_;
  std::map<double, double> width_;  ///< of each step, none of them 0
};

}  // namespace ffcontact
