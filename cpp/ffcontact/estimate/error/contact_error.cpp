// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/contact_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"
#include "ffcontact/estimate/bodies/edge_motions.hpp"
#include "ffcontact/mesh/turns.hpp"

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
  Linear rn, rt;
  EdgeMotions w;  ///< normal: less the gap
  Linear cohesion, friction;
  bool limited;
  Linear limit;  ///< the shear limit of Coulomb's law, if it is limited

  double density(double x) const {
    const double wt = w.tangential(x);
    return bound(x) * std::abs(wt) + rt.at(x) * wt + rn.at(x) * w.normal(x);
  }
  double bound(double x) const {
    if (at_limit(x)) return limit.at(x);
    return cohesion.at(x) + friction.at(x) * std::abs(rn.at(x));
  }
  /// Slope of the density in r_n.
  double normal_slope(double x) const {
    const double mu = at_limit(x) ? 0 : friction.at(x);
    return w.normal(x) - mu * std::abs(w.tangential(x));
  }
  bool at_limit(double x) const {
    return limited && friction.at(x) * std::abs(rn.at(x)) > limit.at(x);
  }

  /// Where the bound has a kink, or where w_t and with it |w_t| changes sign.
  std::vector<double> breaks() const {
    std::vector<double> places = zeros(w.tangential);
    places.push_back(rn.zero());
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

/// Integral of a polynomial of degree 5, for which three Gauss points are exact.
template <class Function>
double gauss_integral(double from, double to, Function&& f) {
  const double width = to - from, middle = 0.5 * (from + to),
               off = 0.5 * std::sqrt(0.6) * width;
  return width / 18 * (5 * (f(middle - off) + f(middle + off)) + 8 * f(middle));
}

/// Integral over (0, 1) of a function that is such a polynomial between its breaks.
template <class Function>
double integral(std::vector<double> breaks, Function&& f) {
  breaks.insert(breaks.end(), {0, 1});
  std::sort(breaks.begin(), breaks.end());
  double sum = 0;
  for (std::size_t piece = 1; piece < breaks.size(); ++piece)
    sum += gauss_integral(breaks[piece - 1], breaks[piece], f);
  return sum;
}

/// |t(s)| is nowhere below it.
double least_length_of_directions(const ContactLine& line, int e) {
  return turns(line, e) ? (line.normal.col(line.edge_node(0, e)) +
                           line.normal.col(line.edge_node(1, e)))
                                  .norm() /
                              2
                        : 1;
}

Linear linear(const Vector2d& ends) { return {ends[0], ends[1]}; }

/// The fields of r_hat and a displacement along the edges.
class LineFields {
 public:
  LineFields(const ContactLine& line, const ContactLaw<2>& law,
             const ContactDensities& densities,
             const Ref<const VectorXd>& displacement)
      : line_(line),
        law_(law),
        densities_(densities),
        motions_(line, law, displacement),
        least_slip_(rounding_of_slip(law, displacement)) {}

  EdgeFields on(int e) const {
    EdgeFields edge{};
    edge.w = motions_.on(e);
    auto& [first, middle, second] = edge.w.tangential;
    for (double* slip : {&first, &middle, &second})
      *slip = slip_beyond(least_slip_, *slip);
    if (!turns(line_, e)) middle = (first + second) / 2;
    edge.rn = linear(densities_.normal.col(e));
    edge.rt = linear(densities_.tangential.col(e));
    const ConesAtEnds most = most_cones(line_, law_, e);
    const double length = least_length_of_directions(line_, e);
    edge.cohesion = {most[0].cohesion / length, most[1].cohesion / length};
    edge.friction = {most[0].friction, most[1].friction};
    edge.limit = {most[0].limit / length, most[1].limit / length};
    edge.limited = law_.limited();
    return edge;
  }

 private:
  const ContactLine& line_;
  const ContactLaw<2>& law_;
  const ContactDensities& densities_;
  LineMotions motions_;
  double least_slip_;
};

/// int phi (w_n - mu |w_t|), without the second term where the limit counts.
double normal_cost(const EdgeFields& edge, const Linear& phi) {
  return integral(edge.breaks(),
                  [&](double x) { return phi.at(x) * edge.normal_slope(x); });
}

/// int phi w_t
double tangential_cost(const EdgeFields& edge, const Linear& phi) {
  return integral({},
                  [&](double x) { return phi.at(x) * edge.w.tangential(x); });
}

/// The least density at the ends, at the quarters, and in the middle. With a large mu what
/// carries r_t may be less than the rounding of r_n: its bound is that of r_n less that.
double least_density(const EdgeFields& edge) {
  constexpr double rounding = 1e-15;
  constexpr int parts = 4;
  double least = 0;
  for (int k = 0; k <= parts; ++k) {
    const double x = static_cast<double>(k) / parts,
                 size = std::hypot(edge.rn.at(x), edge.rt.at(x)),
                 wider = edge.friction.at(x) * rounding * size;
    least = std::min(least,
                     edge.density(x) + wider * std::abs(edge.w.tangential(x)));
  }
  return least;
}

/// Does an edge carry tractions, or does u_hat penetrate there?
bool matters(const EdgeFields& edge) {
  const QuadraticOnEdge& wn = edge.w.normal;
  return edge.rn.first != 0 || edge.rn.second != 0 || edge.rt.first != 0 ||
         edge.rt.second != 0 || std::max({wn.first, wn.middle, wn.second}) > 0;
}

}  // namespace

VectorXd contact_error(const ContactLine& line, const ContactLaw<2>& law,
                       const ContactDensities& densities,
                       const Ref<const VectorXd>& displacement) {
  const LineFields fields(line, law, densities, displacement);
  VectorXd error(line.edge_count());
  for (int e = 0; e < line.edge_count(); ++e) {
    const EdgeFields edge = fields.on(e);
    error[e] = 2 * line.length[e] * integral(edge.breaks(), [&](double x) {
                 return edge.density(x);
               });
  }
  return error;
}

void add_to_cells(const Edges& edges, const ContactLine& line,
                  const VectorXd& of_edges, VectorXd& local) {
  for (int e = 0; e < line.edge_count(); ++e) {
    const int facing = facing_edge(line, e);
    local[edges.cells(0, line.edge[e])] += (facing < 0 ? 1 : 0.5) * of_edges[e];
    if (facing >= 0) local[edges.cells(0, facing)] += 0.5 * of_edges[e];
  }
}

TractionCosts traction_costs(const ContactLine& line, const ContactLaw<2>& law,
                             const ContactDensities& densities,
                             const Ref<const VectorXd>& displacement) {
  const LineFields fields(line, law, densities, displacement);
  TractionCosts costs{Matrix2Xd(2, line.edge_count()),
                      Matrix2Xd(2, line.edge_count())};
  for (int e = 0; e < line.edge_count(); ++e) {
    EdgeFields edge = fields.on(e);
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

BetweenNodes between_nodes(const ContactLine& line, const ContactLaw<2>& law,
                           const ContactDensities& densities,
                           const Ref<const VectorXd>& displacement) {
  const LineFields fields(line, law, densities, displacement);
  BetweenNodes found;
  for (int e = 0; e < line.edge_count(); ++e) {
    const EdgeFields edge = fields.on(e);
    found.note_integrand(least_density(edge), e);
    const Vector2d first = line.normal.col(line.edge_node(0, e)),
                   second = line.normal.col(line.edge_node(1, e));
    if (first.dot(second) <= 0 && matters(edge))
      found.note_turn(angle_between(first, second), e);
  }
  return found;
}

}  // namespace ffcontact
