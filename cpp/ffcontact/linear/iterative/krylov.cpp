// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/iterative/krylov.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "ffcontact/linear/dense/blas.hpp"
#include "ffcontact/linear/dense/serial_blas.hpp"
#include "ffcontact/linear/dense/symmetric_eigen.hpp"

namespace ffcontact {

namespace {

constexpr Index most_steps = 200;
/// Ritz values are looked at after so many steps, then after a quarter more than before.
constexpr Index first_look = 12;
/// What is left of A q beside its norm when the space is invariant.
constexpr double invariant = 1e-13;
/// Ritz value beside the norm of H below which it is a rounded 0.
constexpr double rounded = 1e-12;
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

  bool is_accurate(double tolerance) const {
    return residual <= tolerance * std::abs(value);
  }
};

/// The Ritz values that count, in descending order.
using RitzValues = std::vector<RitzValue>;

/// Steps until the first of the wanted Ritz values is as accurate as asked; where no
/// further step is possible, the first one that is, or else the first.
RitzValue first_accurate(
    const LinearMap& A, Index size, double tolerance,
    const std::function<RitzValues(const KrylovSpace&)>& wanted) {
  if (size == 0) return {};
  KrylovSpace space(A, size);
  const auto is_accurate = [tolerance](const RitzValue& ritz) {
    return ritz.is_accurate(tolerance);
  };
  for (Index k = 1, look = first_look;; ++k) {
    space.step();
    if (k < look && !space.is_full()) continue;
    look += look / 4;
    const RitzValues ritz = wanted(space);
    if (!ritz.empty() && is_accurate(ritz.front())) return ritz.front();
    if (!space.is_full()) continue;
    const auto found = std::find_if(ritz.begin(), ritz.end(), is_accurate);
    if (found != ritz.end()) return *found;
    return ritz.empty() ? RitzValue{} : ritz.front();
  }
}

/// An eigenvalue of H, and the modulus of the last component of its unit vector.
struct HessenbergEigen {
  double real, imaginary, last;
};

std::vector<HessenbergEigen> eigenvalues(MatrixXd H) {
  const int n = static_cast<int>(H.rows()), work_size = 34 * n, one = 1;
  VectorXd values(n), imaginary(n), work(work_size);
  MatrixXd vectors(n, n);
  int info = 0;
  const SerialBlas serial;
  Blas<double>::geev("N", "V", &n, H.data(), &n, values.data(),
                     imaginary.data(), nullptr, &one, vectors.data(), &n,
                     work.data(), &work_size, &info);
  std::vector<HessenbergEigen> eigen;
  for (int k = 0; k < n;) {
    // a complex pair has the real and the imaginary part of its vectors side by side
    const int parts = imaginary[k] == 0 ? 1 : 2;
    const auto vector = vectors.middleCols(k, parts);
    const double last = vector.row(n - 1).norm() / vector.norm();
    for (int part = 0; part < parts; ++part, ++k)
      eigen.push_back({values[k], imaginary[k], last});
  }
  return eigen;
}

}  // namespace

double largest_eigenvalue(const LinearMap& A, Index size) {
  const auto wanted = [](const KrylovSpace& space) {
    const SymmetricEigen ritz = symmetric_eigen(space.projection());
    const Index last = ritz.values.size() - 1;
    return RitzValues{{std::max(0.0, ritz.values[last]),
                       space.remainder() * std::abs(ritz.vectors(last, last))}};
  };
  const RitzValue ritz = first_accurate(A, size, 1e-8, wanted);
  return ritz.value + ritz.residual;
}

double largest_real_eigenvalue(const LinearMap& A, Index size, double below) {
  constexpr double tolerance = 1e-9;
  const auto wanted = [below](const KrylovSpace& space) {
    RitzValues values;
    const MatrixXd H = space.projection();
    const double least = rounded * H.norm();
    for (const HessenbergEigen& theta : eigenvalues(H))
      if (std::abs(theta.imaginary) <=
              real * std::hypot(theta.real, theta.imaginary) &&
          theta.real < below && theta.real > least)
        values.push_back({theta.real, space.remainder() * theta.last});
    std::sort(values.begin(), values.end(),
              [](const RitzValue& a, const RitzValue& b) {
                return a.value > b.value;
              });
    return values;
  };
  const RitzValue ritz = first_accurate(A, size, tolerance, wanted);
  return ritz.is_accurate(tolerance) ? ritz.value : 0;
}

}  // namespace ffcontact
