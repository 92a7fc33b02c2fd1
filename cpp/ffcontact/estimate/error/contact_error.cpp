// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/contact_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"

namespace ffcontact {

namespace {

/// Largest mu of traction_costs.
constexpr double most_cost = 1e4;

/// A function that is linear on an edge, by its end values.
struct Linear {
  double first, second;
  double at(double x) const { return first + x * (second - first); }
  /// Where it changes sign on (0, 1), or 0.
  double zero() const {
    return first * second < 0 ? first / (first - second) : 0;
  }
};

/// Of a x^2 + b x + c, without differences of nearly equal numbers.
std::array<double, 2> roots(double a, double b, double c) {
  const double root = std::sqrt(std::max(0.0, b * b - 4 * a * c));
  const double q = -0.5 * (b + std::copysign(root, b));
  return {q / a, c / q};
}

/// Where a quadratic vanishes within (0, 1).
template <class Quadratic>
std::vector<double> zeros(Quadratic&& f) {
  const double start = f(0.0), middle = f(0.5), end = f(1.0);
  const double a = 2 * (start - 2 * middle + end),
               b = -3 * start + 4 * middle - end;
  std::vector<double> inside;
  for (double x : roots(a, b, start))
    if (x > 0 && x < 1) inside.push_back(x);
  return inside;
}

struct EdgeFields {
  Linear rn, rt, wn, wt;  ///< wn: normal displacement less the gap
  Linear cohesion, friction;
  bool limited;
  Linear limit;  ///< the shear limit of Coulomb's law, if it is limited

  double density(double x) const {
    return bound(x) * std::abs(wt.at(x)) + rt.at(x) * wt.at(x) +
           rn.at(x) * wn.at(x);
  }
  double bound(double x) const {
    if (at_limit(x)) return limit.at(x);
    return cohesion.at(x) + friction.at(x) * std::abs(rn.at(x));
  }
  /// Slope of the density in r_n.
  double normal_slope(double x) const {
    const double mu = at_limit(x) ? 0 : friction.at(x);
    return wn.at(x) - mu * std::abs(wt.at(x));
  }
  bool at_limit(double x) const {
    return limited && friction.at(x) * std::abs(rn.at(x)) > limit.at(x);
  }

  /// Where the bound has a kink, or where w_t and with it |w_t| changes sign.
  std::vector<double> breaks() const {
    std::vector<double> places{wt.zero(), rn.zero()};
    if (limited) add_limits(places);
    return places;
  }
  /// Where mu |r_n| = k.
  void add_limits(std::vector<double>& places) const {
    for (const int sign : {1, -1})
      for (double x : zeros([&](double s) {
             return sign * friction.at(s) * rn.at(s) - limit.at(s);
           }))
        places.push_back(x);
  }
};

/// Distance of two Gauss points from the middle, as a part of the width.
const double gauss = 0.5 / std::sqrt(3.0);

/// Integral of a cubic, for which two Gauss points are exact.
template <class Function>
double gauss_integral(double from, double to, Function&& f) {
  const double width = to - from, middle = 0.5 * (from + to);
  return 0.5 * width * (f(middle - gauss * width) + f(middle + gauss * width));
}

/// Integral over (0, 1) of a function that is a cubic between its breaks.
template <class Function>
double integral(std::vector<double> breaks, Function&& f) {
  breaks.insert(breaks.end(), {0, 1});
  std::sort(breaks.begin(), breaks.end());
  double sum = 0;
  for (std::size_t piece = 1; piece < breaks.size(); ++piece)
    sum += gauss_integral(breaks[piece - 1], breaks[piece], f);
  return sum;
}

/// (w_n - gap, w_t - previous), w_t 0 where it is rounding [2 x p].
Matrix2Xd motions_at_nodes(const ContactLine& line, const ContactLaw& law,
                           const Ref<const VectorXd>& displacement) {
  Matrix2Xd w = displacement_against_foundation(line, law, displacement);
  const double least = rounding_of_slip(law, displacement);
  for (double& slip : w.row(1)) slip = slip_beyond(least, slip);
  return w;
}

Linear linear(const Vector2d& ends) { return {ends[0], ends[1]}; }

EdgeFields edge_fields(const ContactLine& line, const ContactLaw& law,
                       const ContactDensities& densities, const Matrix2Xd& w,
                       int e) {
  const int i = line.edge_node(0, e), j = line.edge_node(1, e);
  EdgeFields edge{};
  edge.wn = {w(0, i), w(0, j)};
  edge.wt = {w(1, i), w(1, j)};
  edge.rn = linear(densities.normal.col(e));
  edge.rt = linear(densities.tangential.col(e));
  const ConesAtEnds most = most_cones(line, law, e);
  edge.cohesion = {most[0].cohesion, most[1].cohesion};
  edge.friction = {most[0].friction, most[1].friction};
  edge.limit = {most[0].limit, most[1].limit};
  edge.limited = law.limited();
  return edge;
}

/// int phi (w_n - mu |w_t|), without the second term where the limit counts.
double normal_cost(const EdgeFields& edge, const Linear& phi) {
  return integral(edge.breaks(),
                  [&](double x) { return phi.at(x) * edge.normal_slope(x); });
}

/// int phi w_t
double tangential_cost(const EdgeFields& edge, const Linear& phi) {
  return integral({}, [&](double x) { return phi.at(x) * edge.wt.at(x); });
}

/// On one edge, where r_hat has the frame of its first node.
FacetFields<2> fields_on_edge(const ContactLine& line, const ContactLaw& law,
                              const ContactDensities& densities,
                              const Matrix2Xd& w, int e) {
  const ConesAtEnds most = most_cones(line, law, e);
  const Matrix2d r = end_values(densities, e).reshaped(2, 2);
  const Matrix2d none = Matrix2d::Zero();
  FacetFields<2> fields{
      none, edge_frame(line, e).transpose() * r, none, {most[0], most[1]}};
  for (int end = 0; end < 2; ++end) {
    const int node = line.edge_node(end, e);
    fields.normal.col(end) = line.normal.col(node);
    fields.motion.col(end) = line.frame(node) * w.col(node);
  }
  return fields;
}

}  // namespace

VectorXd contact_error(const ContactLine& line, const ContactLaw& law,
                       const ContactDensities& densities,
                       const Ref<const VectorXd>& displacement) {
  const Matrix2Xd w = motions_at_nodes(line, law, displacement);
  VectorXd error(line.edge_count());
  for (int e = 0; e < line.edge_count(); ++e) {
    const EdgeFields edge = edge_fields(line, law, densities, w, e);
    error[e] = 2 * line.length[e] * integral(edge.breaks(), [&](double x) {
                 return edge.density(x);
               });
  }
  return error;
}

TractionCosts traction_costs(const ContactLine& line, const ContactLaw& law,
                             const ContactDensities& densities,
                             const Ref<const VectorXd>& displacement) {
  const Matrix2Xd w = motions_at_nodes(line, law, displacement);
  TractionCosts costs{Matrix2Xd(2, line.edge_count()),
                      Matrix2Xd(2, line.edge_count())};
  for (int e = 0; e < line.edge_count(); ++e) {
    EdgeFields edge = edge_fields(line, law, densities, w, e);
    edge.friction = {std::min(edge.friction.first, most_cost),
                     std::min(edge.friction.second, most_cost)};
    for (int end = 0; end < 2; ++end) {
      const Linear phi = linear(Vector2d::Unit(end));
      costs.normal(end, e) = 2 * line.length[e] * normal_cost(edge, phi);
      costs.tangential(end, e) =
          2 * line.length[e] * tangential_cost(edge, phi);
    }
  }
  return costs;
}

BetweenNodes between_nodes(const ContactLine& line, const ContactLaw& law,
                           const ContactDensities& densities,
                           const Ref<const VectorXd>& displacement) {
  const Matrix2Xd w = motions_at_nodes(line, law, displacement);
  BetweenNodes found;
  for (int e = 0; e < line.edge_count(); ++e) {
    const FacetFields<2> fields = fields_on_edge(line, law, densities, w, e);
    note<2>(fields, fields.normal, e, found);
  }
  return found;
}

}  // namespace ffcontact
