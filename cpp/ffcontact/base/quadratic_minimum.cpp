// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/quadratic_minimum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "ffcontact/base/cholesky.hpp"
#include "ffcontact/base/least_squares.hpp"

namespace ffcontact {

namespace {

/// A condition whose part outside the span of the active ones is below this (of its length 1) depends on them.
constexpr double dependent = 1e-11;

/// Conditions are met to this part of the terms they consist of.
constexpr double rounding = 1e-14;

/// The smallest z with G z >= h, rows of G of length 1, by the dual method: z is at any time the smallest one for the active
/// conditions alone, and the multipliers u >= 0 of z = sum of u_j g_j.
class LeastDistance {
 public:
  /// @param scale  of the terms in each h
  LeastDistance(const Eigen::MatrixXd& G, const Eigen::VectorXd& h, const Eigen::VectorXd& scale)
      : G_(G), h_(h), scale_(scale), z_(Eigen::VectorXd::Zero(G.cols())) {}

  /// @return whether all conditions can be met
  bool solve() {
    const Eigen::Index most = 20 * (h_.size() + 1);  // far above what rounding could make of a finite method
    for (Eigen::Index round = 0; round < most; ++round) {
      Eigen::Index violated = 0;
      const Eigen::VectorXd missing = h_ - G_ * z_ - rounding * scale_;
      if (missing.maxCoeff(&violated) <= rounding * z_.norm() || is_active(violated)) return true;
      if (!activate(violated)) return false;
    }
    return false;
  }

  const Eigen::VectorXd& z() const { return z_; }

 private:
  bool is_active(Eigen::Index row) const { return std::find(active_.begin(), active_.end(), row) != active_.end(); }

  Eigen::MatrixXd active_normals() const {
    Eigen::MatrixXd normals(G_.cols(), static_cast<Eigen::Index>(active_.size()));
    for (std::size_t k = 0; k < active_.size(); ++k) normals.col(k) = G_.row(active_[k]).transpose();
    return normals;
  }

  /// Moves z until a condition is met; active ones whose multiplier reaches 0 on the way are dropped.
  bool activate(Eigen::Index row) {
    double own = 0;  // multiplier of the row
    for (;;) {
      const Eigen::MatrixXd normals = active_normals();
      const Eigen::VectorXd g = G_.row(row).transpose();
      const Eigen::VectorXd share = active_.empty() ? Eigen::VectorXd() : least_squares(normals, g);
      const Eigen::VectorXd direction = active_.empty() ? g : Eigen::VectorXd(g - normals * share);
      const bool free = direction.norm() > dependent;
      const double full =
          free ? std::max(0.0, h_[row] - g.dot(z_)) / direction.squaredNorm() : std::numeric_limits<double>::infinity();
      double step = full;
      Eigen::Index dropped = -1;
      for (Eigen::Index k = 0; k < share.size(); ++k)
        if (share[k] > 0 && multipliers_[k] <= step * share[k]) {
          step = multipliers_[k] / share[k];
          dropped = k;
        }
      if (!std::isfinite(step)) return false;
      for (Eigen::Index k = 0; k < share.size(); ++k)
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
  void place_on_active() {
    Eigen::VectorXd limits(static_cast<Eigen::Index>(active_.size()));
    for (std::size_t k = 0; k < active_.size(); ++k) limits[k] = h_[active_[k]];
    z_ = least_squares(active_normals().transpose(), limits);
  }

  const Eigen::MatrixXd& G_;
  const Eigen::VectorXd& h_;
  const Eigen::VectorXd& scale_;
  Eigen::VectorXd z_;
  std::vector<Eigen::Index> active_;
  std::vector<double> multipliers_;
};

}  // namespace

std::optional<Eigen::VectorXd> quadratic_minimum(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                                                 const Eigen::MatrixXd& C, const Eigen::VectorXd& d) {
  const Cholesky cholesky(H);
  if (!cholesky.is_positive_definite()) return std::nullopt;
  const Eigen::VectorXd free = -cholesky.solve(g);
  if (d.size() == 0 || (d - C * free).maxCoeff() <= 0) return free;

  // Rows scaled to length 1: least distance does not care, its rounding does.
  Eigen::MatrixXd G = cholesky.half_solve(C.transpose()).transpose();
  Eigen::VectorXd h = d - C * free;
  Eigen::VectorXd scale = Eigen::VectorXd::Zero(h.size());
  for (Eigen::Index row = 0; row < G.rows(); ++row) {
    const double length = G.row(row).norm();
    if (length == 0) continue;
    G.row(row) /= length;
    h[row] /= length;
    scale[row] = (C.row(row).cwiseAbs().dot(free.transpose().cwiseAbs()) + std::abs(d[row])) / length;
  }
  LeastDistance least(G, h, scale);
  if (!least.solve()) return std::nullopt;
  return free + cholesky.other_half_solve(least.z());
}

}  // namespace ffcontact
