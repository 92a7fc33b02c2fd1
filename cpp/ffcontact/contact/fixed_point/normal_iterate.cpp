// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/fixed_point/normal_iterate.hpp"

#include <algorithm>

#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

constexpr double smallest_damping = 1.0 / 32;

double relative_change(const VectorXd& g, const VectorXd& image) {
  const double scale = max_norm(image);
  return scale > 0 ? max_norm(image - g) / scale : max_norm(g);
}

}  // namespace

void NormalIterate::move_towards(const VectorXd& image) {
  const double change = relative_change(g_, image);
  if (!history_.empty() && change > history_.back())
    damping_ = std::max(damping_ / 2, smallest_damping);
  history_.push_back(change);
  g_ += damping_ * (image - g_);
}

}  // namespace ffcontact
