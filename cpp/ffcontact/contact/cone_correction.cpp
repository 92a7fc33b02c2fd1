// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/cone_correction.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

/// Violations below this, relative to the largest traction, are rounding of the solver and left in peace.
constexpr double rounding = 1e-13;

double largest_traction(const ContactDensities& densities) {
  if (densities.normal.size() == 0) return 0;
  return std::max(densities.normal.cwiseAbs().maxCoeff(), densities.tangential.cwiseAbs().maxCoeff());
}

}  // namespace

ContactDensities edge_densities(const ContactLine& line, const Eigen::Ref<const Eigen::Matrix2Xd>& pressure) {
  ContactDensities densities{Eigen::Matrix2Xd(2, line.edge_count()), Eigen::Matrix2Xd(2, line.edge_count())};
  for (int e = 0; e < line.edge_count(); ++e)
    for (int end = 0; end < 2; ++end) {
      densities.normal(end, e) = pressure(0, line.edge_node(end, e));
      densities.tangential(end, e) = pressure(1, line.edge_node(end, e));
    }
  return densities;
}

Eigen::Matrix2Xd slip_limits(const ContactLine& line, const ContactLaw& law, const Eigen::Matrix2Xd& normal) {
  Eigen::Matrix2Xd limits(2, line.edge_count());
  for (int e = 0; e < line.edge_count(); ++e)
    for (int end = 0; end < 2; ++end) {
      const int node = line.edge_node(end, e);
      limits(end, e) = law.tresca() ? law.slip_bound[node] : -law.friction[node] * normal(end, e);
    }
  return limits;
}

ConeCorrection correct_to_cone(const ContactLine& line, const ContactLaw& law, const ContactDensities& densities) {
  require_size("normal densities", densities.normal.cols(), line.edge_count());
  require_size("tangential densities", densities.tangential.cols(), line.edge_count());
  require_finite("normal density", densities.normal.reshaped());
  require_finite("tangential density", densities.tangential.reshaped());

  for (int e = 0; e < line.edge_count(); ++e)
    if (line.normal.col(line.edge_node(0, e)) != line.normal.col(line.edge_node(1, e)))
      refuse("the contact direction turns along contact edge ", e, ": its tractions need a fixed normal=");

  ConeCorrection result{densities, Eigen::VectorXd::Zero(line.edge_count()), {}};
  const Eigen::Matrix2Xd limits = slip_limits(line, law, densities.normal);
  const double tolerance = rounding * largest_traction(densities);
  for (int e = 0; e < line.edge_count(); ++e) {
    const double ti = densities.tangential(0, e), tj = densities.tangential(1, e);
    const double ci = std::max(0.0, limits(0, e)), cj = std::max(0.0, limits(1, e));
    const bool tensile = densities.normal.col(e).maxCoeff() > tolerance;
    if (tensile || std::abs(ti + tj) > ci + cj + tolerance) {
      result.uncorrected.push_back(e);
      continue;
    }
    if (std::abs(ti) <= ci + tolerance && std::abs(tj) <= cj + tolerance) continue;
    // d must lie in [ti - ci, ti + ci] and in [-tj - cj, -tj + cj]; the point of their intersection nearest to 0 is taken.
    const double low = std::max(ti - ci, -tj - cj), high = std::min(ti + ci, -tj + cj);
    const double d = low > high ? 0.5 * (low + high) : std::clamp(0.0, low, high);
    result.shift[e] = d;
    result.densities.tangential(0, e) = ti - d;
    result.densities.tangential(1, e) = tj + d;
  }
  return result;
}

double cone_defect(const ContactLine& line, const ContactLaw& law, const ContactDensities& densities) {
  const double scale = largest_traction(densities);
  if (scale == 0) return 0;
  const Eigen::Matrix2Xd limits = slip_limits(line, law, densities.normal);
  const double tension = densities.normal.maxCoeff();
  const double excess = (densities.tangential.cwiseAbs() - limits.cwiseMax(0.0)).maxCoeff();
  return std::max({0.0, tension, excess}) / scale;
}

}  // namespace ffcontact
