// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <vector>

#include "ffcontact/equilibrium/star_solves.hpp"

namespace ffcontact {

/// Conjugate gradients for the Airy function x of the least energy x'Kx + 2 g'x
/// (AiryEnergy), from zero, with the additive solves of all stars: with r = -(g + K x) and
/// the last direction p,
///     z = StarSolves r,   p <- z - (z'Kp / p'Kp) p,   x <- x + (r'p / p'Kp) p.
/// Sums are over parts of fixed size and each unknown gathers what the triangles beside it
/// have for it: the digits do not depend on the number of threads.
class StarDescent {
 public:
  /// @param setting  stays where it is
  explicit StarDescent(const StarSetting& setting);

  /// One step; returns by how much the energy fell.
  double step();

  /// Lets `change` alter unknowns of these triangles alone; returns what it returns.
  double changed(const std::set<int>& triangles,
                 const std::function<double(VectorXd&)>& change);

  const VectorXd& airy() const { return airy_; }

 private:
  /// y += factor times the sum of what triangles have for each unknown.
  template <class OfTriangle>
  void gather(double factor, const OfTriangle& of_triangle, VectorXd& y) const;
  /// Sum over the triangles.
  template <class OfTriangle>
  double sum(const OfTriangle& of_triangle) const;
  /// z'Kp
  double product_with_image(const VectorXd& z) const;
  void turn_direction();
  double square_of_direction();
  /// r for x + added, which is 0 but on one triangle.
  void note(int triangle, const LocalAiry& added);

  const StarSetting& setting_;
  StarSolves solves_;
  VectorXd airy_, residual_, direction_;
  std::unique_ptr<LocalAiry[]> image_;  ///< K p per triangle
  double square_ = 0;                   ///< p'Kp; 0: no direction yet
};

}  // namespace ffcontact
