// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/iterative/gmres.hpp"

#include <Eigen/Jacobi>
#include <cmath>
#include <vector>

namespace ffcontact {

namespace {

/// Arnoldi's basis V, and H of A M V = V H made triangular by rotations.
class Space {
 public:
  Space(const VectorXf& b, double norm, int most)
      : basis_{b / static_cast<float>(norm)},
        H_(MatrixXd::Zero(most + 1, most)),
        right_(VectorXd::Zero(most + 1)) {
    right_[0] = norm;
  }

  int steps() const { return static_cast<int>(rotations_.size()); }
  const VectorXf& last() const { return basis_.back(); }
  /// |b - A x|
  double residual() const { return std::abs(right_[steps()]); }

  /// @param product  A M of the last vector of the basis
  /// @return is there more to be had?
  bool extend(VectorXf product) {
    const int k = steps();
    orthogonalise(product);
    const double length = product.cast<double>().norm();
    H_(k + 1, k) = length;
    rotate(k);
    basis_.push_back(product / static_cast<float>(length));
    return length > 0 && H_(k, k) != 0;
  }

  /// V y of the least residual.
  VectorXf combination() const {
    const int k = steps();
    const VectorXd y =
        H_.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(
            right_.head(k));
    VectorXf sum = VectorXf::Zero(basis_[0].size());
    for (int i = 0; i < k; ++i) sum += static_cast<float>(y[i]) * basis_[i];
    return sum;
  }

 private:
  void orthogonalise(VectorXf& product) {
    for (int pass = 0; pass < 2; ++pass)
      for (int i = 0; i <= steps(); ++i) {
        const double part =
            basis_[i].cast<double>().dot(product.cast<double>());
        H_(i, steps()) += part;
        product -= static_cast<float>(part) * basis_[i];
      }
  }

  void rotate(int k) {
    auto column = H_.col(k);
    for (int i = 0; i < k; ++i)
      column.applyOnTheLeft(i, i + 1, rotations_[i].adjoint());
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(column[k], column[k + 1]);
    column.applyOnTheLeft(k, k + 1, rotation.adjoint());
    right_.applyOnTheLeft(k, k + 1, rotation.adjoint());
    rotations_.push_back(rotation);
  }

  std::vector<VectorXf> basis_;
  std::vector<Eigen::JacobiRotation<double>> rotations_;
  MatrixXd H_;
  VectorXd right_;
};

}  // namespace

GmresResult gmres(const SingleMap& A, const SingleMap& M, const VectorXf& b,
                  const GmresLimits& limits) {
  const double norm = b.cast<double>().norm();
  if (norm == 0) return {b};
  Space space(b, norm, limits.steps);
  while (space.steps() < limits.steps &&
         space.residual() > limits.tolerance * norm)
    if (!space.extend(A(M(space.last())))) break;
  return {M(space.combination()), space.steps(), space.residual() / norm};
}

}  // namespace ffcontact
