// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/minimum/bounded_minimum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/over.hpp"
#include "ffcontact/linear/dense/cholesky.hpp"

namespace ffcontact {

namespace {

/// A gradient below this part of the terms it consists of is rounding.
constexpr double gradient_rounding = 1e-14;
/// Least part of the slope by which a clamped step must lower the function.
constexpr double sufficient = 1e-4;

class FaceByFace {
 public:
  FaceByFace(const MatrixXd& H, const VectorXd& h, const VectorXd& low,
             const VectorXd& high, const VectorXd& start, int most_steps)
      : H_(H),
        h_(h),
        low_(low),
        high_(high),
        most_steps_(most_steps),
        fixed_(start.size(), 0) {
    move_to(clamped(start));
  }

  BoundedMinimum solve() {
    while (leave_bounds() && steps_ < most_steps_) {
      const double before = value();
      while (steps_ < most_steps_ && !step_on_face()) {
      }
      if (!(value() < before)) break;  // what is left is rounding
    }
    return {x_, steps_};
  }

 private:
  VectorXd clamped(const VectorXd& x) const {
    return x.cwiseMax(low_).cwiseMin(high_);
  }
  double value() const { return 0.5 * x_.dot(gradient_ + h_); }

  void move_to(const VectorXd& x) {
    x_ = x;
    gradient_ = H_ * x + h_;
    tolerance_ =
        gradient_rounding *
        (H_.diagonal().cwiseProduct(x_.cwiseAbs()) + h_.cwiseAbs()).maxCoeff();
  }

  /// Fixes the unknowns that their gradient holds at a bound. @return whether another one
  /// can lower the function
  bool leave_bounds() {
    bool any = false;
    for (Index i = 0; i < x_.size(); ++i) {
      fixed_[i] = (x_[i] <= low_[i] && gradient_[i] >= -tolerance_) ||
                  (x_[i] >= high_[i] && gradient_[i] <= tolerance_);
      any = any || (!fixed_[i] && std::abs(gradient_[i]) > tolerance_);
    }
    return any;
  }

  std::vector<int> free_unknowns() const {
    return numbers_where(x_.size(), [&](int i) { return !fixed_[i]; });
  }

  /// To the minimum over the free unknowns [all].
  VectorXd newton_step() {
    const std::vector<int> free = free_unknowns();
    VectorXd step = VectorXd::Zero(x_.size());
    if (free.empty()) return step;
    ++steps_;
    step(free) = solved(free);
    return step;
  }

  VectorXd solved(const std::vector<int>& free) const {
    const MatrixXd part = H_(free, free);
    const VectorXd right = -gradient_(free);
    return Cholesky(part).solve(right);
  }

  bool is_blocked(Index i, double step) const {
    return (x_[i] <= low_[i] && step < 0) || (x_[i] >= high_[i] && step > 0);
  }

  /// Fixes unknowns at a bound that a step would move out of it.
  bool fix_blocked(const VectorXd& step) {
    bool any = false;
    for (Index i = 0; i < x_.size(); ++i)
      if (is_blocked(i, step[i])) {
        fixed_[i] = 1;
        any = true;
      }
    return any;
  }

  double room(Index i, double step) const {
    return step < 0 ? low_[i] - x_[i] : high_[i] - x_[i];
  }

  /// Along a step up to the first bound.
  VectorXd at_first_bound(const VectorXd& step) const {
    Index first = -1;
    double part = 1;
    for (Index i = 0; i < x_.size(); ++i)
      if (step[i] != 0 && room(i, step[i]) / step[i] < part) {
        part = room(i, step[i]) / step[i];
        first = i;
      }
    VectorXd x = clamped(x_ + part * step);
    if (first >= 0) x[first] = step[first] < 0 ? low_[first] : high_[first];
    return x;
  }

  bool lowers(const VectorXd& by) const {
    const double slope = gradient_.dot(by);
    return slope + 0.5 * by.dot(H_ * by) <= sufficient * std::min(slope, 0.0);
  }

  void fix_at_bounds() {
    for (Index i = 0; i < x_.size(); ++i)
      if (x_[i] <= low_[i] || x_[i] >= high_[i]) fixed_[i] = 1;
  }

  /// @return whether the minimum of the face is reached
  bool step_on_face() {
    const VectorXd step = newton_step();
    if (!step.allFinite()) return true;
    if (fix_blocked(step)) return false;
    const VectorXd whole = x_ + step, inside = clamped(whole);
    if (inside == whole) {
      move_to(whole);
      return true;
    }
    move_to(lowers(inside - x_) ? inside : at_first_bound(step));
    fix_at_bounds();
    return false;
  }

  const MatrixXd& H_;
  const VectorXd &h_, &low_, &high_;
  const int most_steps_;
  VectorXd x_, gradient_;
  Flags fixed_;
  double tolerance_ = 0;
  int steps_ = 0;
};

}  // namespace

BoundedMinimum bounded_minimum(const MatrixXd& H, const VectorXd& h,
                               const VectorXd& low, const VectorXd& high,
                               const VectorXd& start, int most_steps) {
  return FaceByFace(H, h, low, high, start, most_steps).solve();
}

}  // namespace ffcontact
