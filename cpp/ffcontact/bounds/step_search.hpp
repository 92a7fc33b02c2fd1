// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

namespace ffcontact {

/// Looks for the step s at which bounds are the narrowest. Their width is near A / s + B s, and
/// grows faster where s changes what is in contact; it has one minimum, but where contact
/// tractions oscillate (BoundPair) it may have others, on much longer steps.
class StepSearch {
 public:
  /// @param longest  that is of use
  /// @param error    A, that of u itself: widths go to A / s as s goes to 0; if it is known
  explicit StepSearch(double longest, double error = 0)
      : longest_(longest), error_(error) {}

  void add(double s, double width) { width_[s] = width; }
  /// The next step to be tried: a quarter of the first one; that at which A / s + B s through
  /// the best one and its neighbour is least, which is the shorter one if there is; before
  /// that, where it is nearer to the longer neighbour, that at which a parabola through the
  /// logarithms of the best one and both neighbours is; in the end that at which A / s + B s
  /// with the known A and the width of the shortest one is, far below it.
  /// @return 0 where none promises what is worth it
  double next() const;

 private:
  double nearby() const;
  double far_below() const;

  double longest_, error_;
  std::map<double, double> width_;  ///< of each step, none of them 0
};

}  // namespace ffcontact
