// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/contact_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ffcontact {

namespace {

/// A function that is linear on an edge, by its end values.
struct Linear {
  double first, second;
  double at(double x) const { return first + x * (second - first); }
  /// Where it changes sign on (0, 1), or 0.
  double zero() const { return first * second < 0 ? first / (first - second) : 0; }
};

struct EdgeFields {
  Linear rn, rt, wn, wt;  ///< wn: normal displacement less the gap
  Linear coefficient;     ///< mu or k
  bool tresca;

  double density(double x) const {
    const double bound = coefficient.at(x) * (tresca ? 1 : std::abs(rn.at(x)));
    return bound * std::abs(wt.at(x)) + rt.at(x) * wt.at(x) + rn.at(x) * wn.at(x);
  }
};

/// Integral over (0, 1) of a function that is a cubic between its breaks, for which two Gauss points are exact.
template <class Function>
double integral(const std::array<double, 2>& inner_breaks, Function&& f) {
  std::array<double, 4> breaks{0, inner_breaks[0], inner_breaks[1], 1};
  std::sort(breaks.begin(), breaks.end());
  const double gauss = 0.5 / std::sqrt(3.0);
  double sum = 0;
  for (int piece = 0; piece < 3; ++piece) {
    const double width = breaks[piece + 1] - breaks[piece], middle = 0.5 * (breaks[piece] + breaks[piece + 1]);
    sum += 0.5 * width * (f(middle - gauss * width) + f(middle + gauss * width));
  }
  return sum;
}

/// Displacements and law on one edge; r_n and r_t are left at zero.
EdgeFields edge_fields(const ContactLine& line, const ContactLaw& law, const Eigen::Matrix2Xd& w, int e) {
  const int i = line.edge_node(0, e), j = line.edge_node(1, e);
  EdgeFields edge{};
  edge.wn = {w(0, i), w(0, j)};
  edge.wt = {w(1, i), w(1, j)};
  const Eigen::Vector2d most = most_coefficient(line, law, e);
  edge.coefficient = {most[0], most[1]};
  edge.tresca = law.tresca();
  return edge;
}

}  // namespace

Eigen::VectorXd contact_error(const ContactLine& line, const ContactLaw& law, const ContactDensities& densities,
                              const Eigen::Ref<const Eigen::VectorXd>& displacement) {
  const Eigen::Matrix2Xd w = displacement_against_foundation(line, law, displacement);
  Eigen::VectorXd error(line.edge_count());
  for (int e = 0; e < line.edge_count(); ++e) {
    EdgeFields edge = edge_fields(line, law, w, e);
    edge.rn = {densities.normal(0, e), densities.normal(1, e)};
    edge.rt = {densities.tangential(0, e), densities.tangential(1, e)};
    error[e] =
        2 * line.length[e] * integral({edge.wt.zero(), edge.rn.zero()}, [&](double x) { return edge.density(x); });
  }
  return error;
}

TractionCosts traction_costs(const ContactLine& line, const ContactLaw& law,
                             const Eigen::Ref<const Eigen::VectorXd>& displacement) {
  const Eigen::Matrix2Xd w = displacement_against_foundation(line, law, displacement);
  TractionCosts costs{Eigen::Matrix2Xd(2, line.edge_count()), Eigen::Matrix2Xd(2, line.edge_count())};
  for (int e = 0; e < line.edge_count(); ++e) {
    const EdgeFields edge = edge_fields(line, law, w, e);
    for (int end = 0; end < 2; ++end) {
      const Linear phi{end == 0 ? 1.0 : 0.0, end == 0 ? 0.0 : 1.0};
      const auto normal = [&](double x) {
        const double slip = edge.tresca ? 0 : edge.coefficient.at(x) * std::abs(edge.wt.at(x));
        return phi.at(x) * (edge.wn.at(x) - slip);
      };
      costs.normal(end, e) = 2 * line.length[e] * integral({edge.wt.zero(), 0}, normal);
      costs.tangential(end, e) =
          2 * line.length[e] * integral({0, 0}, [&](double x) { return phi.at(x) * edge.wt.at(x); });
    }
  }
  return costs;
}

}  // namespace ffcontact
