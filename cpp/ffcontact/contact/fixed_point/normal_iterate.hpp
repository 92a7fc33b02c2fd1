// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// g of the fixed point [CHH01, Definition 3.1]: 0, then moved towards its images,
/// g + theta (Phi_h(g) - g). theta is 1 and halved, down to 1/32, whenever a step has
/// changed more than the one before.
class NormalIterate {
 public:
  explicit NormalIterate(Index nodes) : g_(VectorXd::Zero(nodes)) {}

  const VectorXd& value() const { return g_; }
  /// |Phi_h(g) - g| of each step, relative to the largest normal multiplier.
  const std::vector<double>& history() const { return history_; }
  void move_towards(const VectorXd& image);
  /// A step after which g does not matter.
  void stay() { history_.push_back(0); }

 private:
  VectorXd g_;
  double damping_ = 1;
  std::vector<double> history_;
};

}  // namespace ffcontact
