// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/cone_correction.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "ffcontact/base/require.hpp"
#include "ffcontact/interface/curve_directions.hpp"

namespace ffcontact {

namespace {

/// Violations below this, relative to the largest traction, are rounding of the solver
/// and left in peace.
constexpr double traction_rounding = 1e-13;

void require_fitting(const ContactLine& line, const std::string& name,
                     const Matrix2Xd& values) {
  require_size(name + " densities", values.cols(), line.edge_count());
  require_finite(name + " density", values.reshaped());
}

void require_fixed_direction(const ContactLine& line) {
  for (int e = 0; e < line.edge_count(); ++e)
    if (turns(line, e))
      refuse("the contact direction turns along contact edge ", e,
             ": its tractions need a fixed normal=");
}

/// The largest |r_t,i + r_t,j| that any shift brings into the cone.
double largest_sum(const ConesAtEnds& cones, const Vector2d& normal) {
  const Vector2d p = (-normal).cwiseMax(0.0);
  const double ends = cones[0].bound(normal[0]) + cones[1].bound(normal[1]);
  if (cones[0].friction == cones[1].friction) return ends;
  const double middle = cones[0].cohesion + cones[1].cohesion +
                        cones[0].friction * p[1] + cones[1].friction * p[0];
  return std::min(ends, middle);
}

/// d of (4.1) [MPa]: 0 where none is needed, nothing where there is none.
std::optional<double> smallest_shift(const ConesAtEnds& cones,
                                     const Vector2d& normal,
                                     const Vector2d& tangential,
                                     double tolerance) {
  const double ti = tangential[0], tj = tangential[1];
  const double ci = cones[0].bound(normal[0]), cj = cones[1].bound(normal[1]);
  const bool tensile = normal.maxCoeff() > tolerance;
  if (tensile || std::abs(ti + tj) > largest_sum(cones, normal) + tolerance)
    return std::nullopt;
  if (std::abs(ti) <= ci + tolerance && std::abs(tj) <= cj + tolerance)
    return 0;
  // d must lie in [ti - ci, ti + ci] and in [-tj - cj, -tj + cj]; the point of their
  // intersection nearest to 0 is taken.
  const double low = std::max(ti - ci, -tj - cj),
               high = std::min(ti + ci, -tj + cj);
  const double d = low > high ? 0.5 * (low + high) : std::clamp(0.0, low, high);
  return d;
}

}  // namespace

int ConeCorrection::corrected_count() const {
  return static_cast<int>((shift.array() != 0).count());
}

ConeCorrection correct_to_cone(const ContactLine& line,
                               const ContactLaw<2>& law,
                               const ContactDensities& densities) {
  require_fitting(line, "normal", densities.normal);
  require_fitting(line, "tangential", densities.tangential);
  require_fixed_direction(line);
  ConeCorrection result{densities, VectorXd::Zero(line.edge_count()), {}};
  const double tolerance = traction_rounding * largest_traction(densities);
  for (int e = 0; e < line.edge_count(); ++e) {
    const auto d =
        smallest_shift(least_cones(line, law, e), densities.normal.col(e),
                       densities.tangential.col(e), tolerance);
    if (!d) result.uncorrected.push_back(e);
    if (!d || *d == 0) continue;
    result.shift[e] = *d;
    result.densities.tangential.col(e) += Vector2d(-*d, *d);
  }
  return result;
}

}  // namespace ffcontact
