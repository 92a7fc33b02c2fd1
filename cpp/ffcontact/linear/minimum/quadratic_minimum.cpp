// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/minimum/quadratic_minimum.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ffcontact/linear/dense/cholesky.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// A condition whose part outside the span of the active ones is below this (of its
/// length 1) depends on them.
constexpr double dependent = 1e-11;

/// Conditions are met to this part of the terms they consist of; where as many as there
/// are unknowns say where z is, and more would have it nearly there, to this one.
constexpr double condition_rounding = 1e-14, corner_rounding = 1e-12;

/// What rounding may make of z.
constexpr double lost_digits = 1e-13;

/// The smallest z with G z >= h, rows of G of length 1, by the dual method: z is at any
/// time the smallest one for the active conditions alone, and the multipliers u >= 0 of z
/// = sum of u_j g_j.
class LeastDistance {
 public:
  /// @param scale  of the terms in each h
  LeastDistance(const MatrixXd& G, const VectorXd& h, const VectorXd& scale)
      : G_(G), h_(h), scale_(scale), z_(VectorXd::Zero(G.cols())) {}

  /// @return whether all conditions can be met
  bool solve() {
    // far above what rounding could make of a finite method
    const Index most = 20 * (h_.size() + 1);
    for (Index round = 0; round < most; ++round) {
      Index violated = 0;
      const double rounding =
          active_.size() < static_cast<std::size_t>(z_.size())
              ? condition_rounding
              : corner_rounding;
      const VectorXd missing = h_ - G_ * z_ - rounding * scale_;
      if (missing.maxCoeff(&violated) <= rounding * z_.norm() ||
          is_active(violated))
        return true;
      if (!activate(violated)) return false;
    }
    return false;
  }

  const VectorXd& z() const { return z_; }

  /// The smallest z with G z = h for the active conditions.
  VectorXd on_active(const VectorXd& h) const {
    if (active_.empty()) return VectorXd::Zero(z_.size());
    return least_squares(active_normals().transpose(), h(active_));
  }

 private:
  bool is_active(Index row) const {
    return std::find(active_.begin(), active_.end(), row) != active_.end();
  }

  MatrixXd active_normals() const {
    return G_(active_, Eigen::all).transpose();
  }

  /// Moves z until a condition is met; active ones whose multiplier reaches 0 on the way
  /// are dropped.
  bool activate(Index row) {
    double own = 0;  // multiplier of the row
    for (;;) {
      const MatrixXd normals = active_normals();
      const VectorXd g = G_.row(row).transpose();
      const VectorXd share =
          active_.empty() ? VectorXd() : least_squares(normals, g);
      const VectorXd direction =
          active_.empty() ? g : VectorXd(g - normals * share);
      const bool free = direction.norm() > dependent;
      const double full =
          free ? std::max(0.0, h_[row] - g.dot(z_)) / direction.squaredNorm()
               : infinity;
      double step = full;
      Index dropped = -1;
      for (Index k = 0; k < share.size(); ++k)
        if (share[k] > 0 && multipliers_[k] <= step * share[k]) {
          step = multipliers_[k] / share[k];
          dropped = k;
        }
      if (!std::isfinite(step)) return false;
      for (Index k = 0; k < share.size(); ++k)
        multipliers_[k] = std::max(0.0, multipliers_[k] - step * share[k]);
      own += step;
      if (free) z_ += step * direction;
      if (dropped < 0) break;
      active_.erase(active_.begin() + dropped);
      multipliers_.erase(multipliers_.begin() + dropped);
    }
    active_.push_back(row);
    multipliers_.push_back(own);
    place_on_active();
    return true;
  }

  /// z from the active conditions anew: the steps' rounding is forgotten.
  void place_on_active() { z_ = on_active(h_); }

  const MatrixXd& G_;
  const VectorXd& h_;
  const VectorXd& scale_;
  VectorXd z_;
  std::vector<Index> active_;
  std::vector<double> multipliers_;
};

}  // namespace

std::optional<VectorXd> quadratic_minimum(const MatrixXd& H, const VectorXd& g,
                                          const MatrixXd& C,
                                          const VectorXd& d) {
  const Cholesky cholesky(H);
  if (!cholesky.is_positive_definite()) return std::nullopt;
  const VectorXd free = -cholesky.solve(g);
  if (d.size() == 0 || (d - C * free).maxCoeff() <= 0) return free;

  // Rows scaled to length 1: least distance does not care, its rounding does.
  MatrixXd G = cholesky.half_solve(C.transpose()).transpose();
  VectorXd per_length = G.rowwise().norm();
  for (double& length : per_length) length = length > 0 ? 1 / length : 1;
  G = per_length.asDiagonal() * G;
  const VectorXd h = per_length.cwiseProduct(d - C * free),
                 scale = per_length.cwiseProduct(
                     C.cwiseAbs() * free.cwiseAbs() + d.cwiseAbs());
  LeastDistance least(G, h, scale);
  if (!least.solve()) return std::nullopt;
  VectorXd y = free + cholesky.other_half_solve(least.z());
  // The digits that free has more than y, unless conditions that nearly depend on each
  // other would make more of them.
  const VectorXd lost = least.on_active(per_length.cwiseProduct(d - C * y));
  if (lost.norm() <= lost_digits * least.z().norm())
    y += cholesky.other_half_solve(lost);
  return y;
}

}  // namespace ffcontact
