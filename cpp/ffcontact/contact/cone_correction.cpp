// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/cone_correction.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

/// Violations below this, relative to the largest traction, are rounding of the solver
/// and left in peace.
constexpr double rounding = 1e-13;

/// The smallest linear bound of r_t at the ends of an edge: c = m p (Coulomb) or m
/// (Tresca), and what it lets their sum be.
struct SlipLimits {
  double first, second, sum;
};
SlipLimits slip_limits(const ContactLine& line, const ContactLaw& law,
                       const Vector2d& normal, int edge) {
  const Vector2d m = least_coefficient(line, law, edge), p = (-normal).cwiseMax(0.0);
  if (law.tresca()) return {m[0], m[1], m[0] + m[1]};
  const Vector2d k = least_shear_limit(line, law, edge);
  const double first = std::min(m[0] * p[0], k[0]), second = std::min(m[1] * p[1], k[1]),
               ends = first + second;
  return {first, second, m[0] == m[1] ? ends : std::min(ends, m[0] * p[1] + m[1] * p[0])};
}

/// Largest |r_t| - k at the ends of an edge, for a limit that is linear.
double largest_excess(const Vector2d& limit, const Vector2d& tangential) {
  return (tangential.cwiseAbs() - limit).maxCoeff();
}

/// Largest |r_t| - m p on an edge, both linear or the last one quadratic: at an end or
/// where its slope vanishes.
double largest_excess(const Vector2d& coefficient, const Vector2d& normal,
                      const Vector2d& tangential, bool tresca) {
  double largest = 0;
  for (const int sign : {1, -1}) {
    const auto excess = [&](double s) {
      const double m = coefficient[0] + s * (coefficient[1] - coefficient[0]);
      const double p = -(normal[0] + s * (normal[1] - normal[0]));
      const double t = tangential[0] + s * (tangential[1] - tangential[0]);
      return sign * t - (tresca ? m : m * std::max(p, 0.0));
    };
    largest = std::max({largest, excess(0), excess(1)});
    const double start = excess(0), middle = excess(0.5), end = excess(1);
    const double bend = start - 2 * middle + end,
                 // of 2 bend s^2 + slope s + start
        slope = -3 * start + 4 * middle - end;
    if (bend < 0 && slope > 0 && slope < -4 * bend)
      largest = std::max(largest, excess(-slope / (4 * bend)));
  }
  return largest;
}

double largest_traction(const ContactDensities& densities) {
  if (densities.normal.size() == 0) return 0;
  return std::max(densities.normal.cwiseAbs().maxCoeff(),
                  densities.tangential.cwiseAbs().maxCoeff());
}

}  // namespace

ContactDensities edge_densities(const ContactLine& line,
                                const Ref<const Matrix2Xd>& pressure) {
  ContactDensities densities{Matrix2Xd(2, line.edge_count()),
                             Matrix2Xd(2, line.edge_count())};
  for (int e = 0; e < line.edge_count(); ++e)
    for (int end = 0; end < 2; ++end) {
      densities.normal(end, e) = pressure(0, line.edge_node(end, e));
      densities.tangential(end, e) = pressure(1, line.edge_node(end, e));
    }
  return densities;
}

EdgeCone edge_cone(const ContactLine& line, const ContactLaw& law, int edge) {
  const Vector2d m = least_coefficient(line, law, edge);
  const Vector2d k = least_shear_limit(line, law, edge);
  EdgeCone cone{m.array() == 0 || k.array() == 0,
                Matrix<double, Dynamic, 4>::Zero(EdgeCone::most_rows, 4),
                VectorXd::Zero(EdgeCone::most_rows)};
  Index rows = 0;
  for (int end = 0; end < 2; ++end) {
    // For Coulomb's law |r_t| <= m p implies r_n <= 0, but in a thin cone their rounding
    // divided by m is its.
    cone.C(rows++, 2 * end) = -1;
    if (cone.frictionless[end]) continue;
    for (const int sign : {1, -1}) {
      cone.C(rows, 2 * end + 1) = sign;
      cone.C(rows, 2 * end) = law.tresca() ? 0 : -m[end];
      cone.d[rows++] = law.tresca() ? -m[end] : 0;
      if (!law.limited()) continue;
      cone.C(rows, 2 * end + 1) = sign;
      cone.d[rows++] = -k[end];
    }
  }
  if (!law.tresca() && m[0] != m[1])
    for (const int sign : {1, -1}) cone.C.row(rows++) << -m[1], sign, -m[0], sign;
  cone.C.conservativeResize(rows, Eigen::NoChange);
  cone.d.conservativeResize(rows);
  return cone;
}

Vector4d clamped_to_cone(const ContactLine& line, const ContactLaw& law, int edge,
                         const Vector4d& r) {
  const Vector2d normal(std::min(r[0], 0.0), std::min(r[2], 0.0));
  const auto [first, second, sum] = slip_limits(line, law, normal, edge);
  Vector2d tangential(std::clamp(r[1], -first, first), std::clamp(r[3], -second, second));
  // sum >= 2 min(first, second)
  if (std::abs(tangential.sum()) > sum) tangential *= sum / std::abs(tangential.sum());
  return interleaved(normal, tangential);
}

ConeCorrection correct_to_cone(const ContactLine& line, const ContactLaw& law,
                               const ContactDensities& densities) {
  require_size("normal densities", densities.normal.cols(), line.edge_count());
  require_size("tangential densities", densities.tangential.cols(), line.edge_count());
  require_finite("normal density", densities.normal.reshaped());
  require_finite("tangential density", densities.tangential.reshaped());

  for (int e = 0; e < line.edge_count(); ++e)
    if (line.normal.col(line.edge_node(0, e)) != line.normal.col(line.edge_node(1, e)))
      refuse("the contact direction turns along contact edge ", e,
             ": its tractions need a fixed normal=");

  ConeCorrection result{densities, VectorXd::Zero(line.edge_count()), {}};
  const double tolerance = rounding * largest_traction(densities);
  for (int e = 0; e < line.edge_count(); ++e) {
    const double ti = densities.tangential(0, e), tj = densities.tangential(1, e);
    const auto [ci, cj, most] = slip_limits(line, law, densities.normal.col(e), e);
    const bool tensile = densities.normal.col(e).maxCoeff() > tolerance;
    if (tensile || std::abs(ti + tj) > most + tolerance) {
      result.uncorrected.push_back(e);
      continue;
    }
    if (std::abs(ti) <= ci + tolerance && std::abs(tj) <= cj + tolerance) continue;
    // d must lie in [ti - ci, ti + ci] and in [-tj - cj, -tj + cj]; the point of their
    // intersection nearest to 0 is taken.
    const double low = std::max(ti - ci, -tj - cj), high = std::min(ti + ci, -tj + cj);
    const double d = low > high ? 0.5 * (low + high) : std::clamp(0.0, low, high);
    result.shift[e] = d;
    result.densities.tangential(0, e) = ti - d;
    result.densities.tangential(1, e) = tj + d;
  }
  return result;
}

double cone_defect(const ContactLine& line, const ContactLaw& law,
                   const ContactDensities& densities) {
  const double scale = largest_traction(densities);
  if (scale == 0) return 0;
  const double tension = densities.normal.maxCoeff();
  double excess = 0;
  for (int e = 0; e < line.edge_count(); ++e)
    excess = std::max(
        {excess,
         largest_excess(least_shear_limit(line, law, e), densities.tangential.col(e)),
         largest_excess(least_coefficient(line, law, e), densities.normal.col(e),
                        densities.tangential.col(e), law.tresca())});
  return std::max({0.0, tension, excess}) / scale;
}

}  // namespace ffcontact
