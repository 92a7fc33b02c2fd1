// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/iterative/conjugate_gradients.hpp"

namespace ffcontact {

std::optional<VectorXd> conjugate_gradients(
    const LinearMap& A, const LinearMap& M, const VectorXd& b,
    const ConjugateGradientLimits& limits) {
  const double wanted = limits.tolerance * b.norm();
  VectorXd x = VectorXd::Zero(b.size()), residual = b, direction = x;
  double last = 1;
  for (int step = 0; !(residual.norm() <= wanted); ++step) {
    if (step == limits.steps) return std::nullopt;
    const VectorXd next = M(residual);
    const double product = residual.dot(next);
    direction = next + product / last * direction;
    const VectorXd image = A(direction);
    const double length = product / direction.dot(image);
    x += length * direction;
    residual -= length * image;
    last = product;
  }
  return x;
}

}  // namespace ffcontact
