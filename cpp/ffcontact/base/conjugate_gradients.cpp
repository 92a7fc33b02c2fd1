// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/conjugate_gradients.hpp"

namespace ffcontact {

std::optional<VectorXd> conjugate_gradients(
    const LinearMap& A, const LinearMap& M, const VectorXd& b,
    const ConjugateGradientLimits& limits) {
  const double wanted = limits.tolerance * b.norm();
  VectorXd x = VectorXd::Zero(b.size()), residual = b, direction = M(b);
  double product = residual.dot(direction);
  for (int step = 0; step < limits.steps; ++step) {
    if (residual.norm() <= wanted) return x;
    const VectorXd image = A(direction);
    const double length = product / direction.dot(image);
    x += length * direction;
    residual -= length * image;
    const VectorXd next = M(residual);
    const double last = product;
    product = residual.dot(next);
    direction = next + product / last * direction;
  }
  if (residual.norm() <= wanted) return x;
  return std::nullopt;
}

}  // namespace ffcontact
