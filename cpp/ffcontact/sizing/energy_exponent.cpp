// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/sizing/energy_exponent.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

namespace {

/// a bound on what a fit on a coarse mesh can say
constexpr double weakest_exponent = 0.1;
constexpr int least_radii = 4;
constexpr double spacing = 1.25;

double energy_within(double r, const Neighbourhood& near) {
  double W = 0;
  for (const auto& [distance, energy] : near)
    if (distance <= r) W += energy;
  return W;
}

/// Of the line nearest to some points, halved.
double half_slope(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<Index>(x.size());
  const Map<const Eigen::ArrayXd> X(x.data(), n), Y(y.data(), n);
  const Eigen::ArrayXd dx = X - X.mean();
  return 0.5 * (dx * (Y - Y.mean())).sum() / dx.square().sum();
}

}  // namespace

double fitted_exponent(const Neighbourhood& near, double smallest,
                       double largest) {
  std::vector<double> x, y;
  for (double r = smallest; r <= largest; r *= spacing) {
    const double W = energy_within(r, near);
    if (!(W > 0)) continue;
    x.push_back(std::log(r));
    y.push_back(std::log(W));
  }
  if (x.size() < least_radii) return 1;
  return std::clamp(half_slope(x, y), weakest_exponent, 1.0);
}

}  // namespace ffcontact
