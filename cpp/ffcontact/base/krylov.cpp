// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/krylov.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>

namespace ffcontact {

namespace {

constexpr Index most_steps = 200;
/// Ritz values are looked at every so many steps.
constexpr Index between_looks = 10;
/// What is left of A q beside its norm when the space is invariant.
constexpr double invariant = 1e-13;
/// Imaginary part, beside the modulus, below which a Ritz value is real.
constexpr double real = 1e-8;

/// An orthonormal basis Q of the Krylov space of a start without symmetry, and H = Q' A Q.
class KrylovSpace {
 public:
  KrylovSpace(const LinearMap& A, Index size)
      : A_(A), most_(std::min(size, most_steps)), Q_(size, most_ + 1) {
    H_ = MatrixXd::Zero(most_ + 1, most_);
    std::minstd_rand random;
    for (Index i = 0; i < size; ++i)
      Q_(i, 0) = static_cast<double>(random()) / std::minstd_rand::max() - 0.5;
    Q_.col(0).normalize();
  }

  /// Is there nothing to be had from further steps?
  bool is_full() const { return full_ || steps_ == most_; }
  /// |A Q y - theta Q y| = remainder |y_last| for an eigenvector y of H.
  double remainder() const { return full_ ? 0 : H_(steps_, steps_ - 1); }
  MatrixXd projection() const { return H_.topLeftCorner(steps_, steps_); }

  void step() {
    const Index k = steps_++;
    VectorXd next = A_(Q_.col(k));
    const double length = next.norm();
    // twice is enough
    for (int pass = 0; pass < 2; ++pass) {
      const VectorXd along = Q_.leftCols(k + 1).transpose() * next;
      next -= Q_.leftCols(k + 1) * along;
      H_.col(k).head(k + 1) += along;
    }
    H_(k + 1, k) = next.norm();
    full_ = H_(k + 1, k) <= invariant * length || k + 1 == Q_.rows();
    Q_.col(k + 1) = full_ ? VectorXd(VectorXd::Zero(next.size()))
                          : VectorXd(next / H_(k + 1, k));
  }

 private:
  const LinearMap& A_;
  Index most_, steps_ = 0;
  MatrixXd Q_, H_;
  bool full_ = false;
};

struct RitzValue {
  double value = 0, residual = 0;
};

/// Steps until the wanted Ritz value is as accurate as asked, or no further one helps.
template <class Wanted>
double converged(const LinearMap& A, Index size, double tolerance,
                 Wanted wanted) {
  if (size == 0) return 0;
  KrylovSpace space(A, size);
  for (Index k = 1;; ++k) {
    space.step();
    if (k % between_looks != 0 && !space.is_full()) continue;
    const RitzValue ritz = wanted(space);
    if (space.is_full()) return ritz.value;
    if (ritz.value > 0 && ritz.residual <= tolerance * ritz.value)
      return ritz.value;
  }
}

}  // namespace

double largest_eigenvalue(const LinearMap& A, Index size) {
  return converged(A, size, 1e-8, [](const KrylovSpace& space) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> ritz(space.projection());
    const Index last = ritz.eigenvalues().size() - 1;
    return RitzValue{
        std::max(0.0, ritz.eigenvalues()[last]),
        space.remainder() * std::abs(ritz.eigenvectors()(last, last))};
  });
}

double largest_real_eigenvalue(const LinearMap& A, Index size, double below) {
  return converged(A, size, 1e-6, [below](const KrylovSpace& space) {
    const Eigen::EigenSolver<MatrixXd> ritz(space.projection());
    const Eigen::VectorXcd theta = ritz.eigenvalues();
    Index largest = -1;
    for (Index k = 0; k < theta.size(); ++k)
      if (std::abs(theta[k].imag()) <= real * std::abs(theta[k]) &&
          theta[k].real() < below &&
          theta[k].real() > (largest < 0 ? 0 : theta[largest].real()))
        largest = k;
    if (largest < 0) return RitzValue{};
    const Eigen::VectorXcd y = ritz.eigenvectors().col(largest);
    return RitzValue{theta[largest].real(),
                     space.remainder() * std::abs(y[y.size() - 1]) / y.norm()};
  });
}

}  // namespace ffcontact
