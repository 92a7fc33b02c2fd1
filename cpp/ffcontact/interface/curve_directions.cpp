// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/curve_directions.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

using Nodes = std::vector<int>;

/// The nodes of each smooth curve in order.
std::vector<Nodes> curves_of(const ContactLine& line) {
  std::vector<Nodes> curves;
  for (int e = 0; e < line.edge_count(); ++e) {
    if (!turns(line, e)) continue;
    if (curves.empty() || curves.back().back() != line.edge_node(0, e))
      curves.push_back({line.edge_node(0, e)});
    curves.back().push_back(line.edge_node(1, e));
  }
  return curves;
}

/// Where the gap of a curve is the smallest: its node, and the direction there.
struct Spot {
  int node;
  Vector2d direction;
};

Vector2d snapped_to_axis(const Vector2d& direction, double angle) {
  for (int c = 0; c < 2; ++c)
    if (std::abs(direction[c]) < angle)
      return std::copysign(1.0, direction[1 - c]) * Vector2d::Unit(1 - c);
  return direction;
}

/// The place on a curve, by the number of its node, where the gap is the smallest.
std::size_t lowest_place(const Nodes& curve, const Ref<const VectorXd>& gap) {
  const auto lower = [&](int a, int b) { return gap[a] < gap[b]; };
  return std::min_element(curve.begin(), curve.end(), lower) - curve.begin();
}

/// Where the parabola through (a, f_a), (0, 0) and (b, f_b), a < 0 < b, is the lowest.
std::optional<double> lowest_of_parabola(double a, double f_a, double b,
                                         double f_b) {
  // slopes of chords
  const double left = f_a / a, right = f_b / b;
  const double bend = (right - left) / (b - a);
  if (!(a < 0 && b > 0 && bend > 0)) return std::nullopt;
  return -(left - bend * a) / (2 * bend);
}

Spot smallest_gap(const ContactLine& line, const Nodes& curve,
                  const Ref<const VectorXd>& gap) {
  const std::size_t k = lowest_place(curve, gap);
  const int node = curve[k];
  const Vector2d n = line.normal.col(node);
  if (k == 0 || k + 1 == curve.size()) return {node, n};
  const int before = curve[k - 1], after = curve[k + 1];
  const double a = line.abscissa[before] - line.abscissa[node],
               b = line.abscissa[after] - line.abscissa[node];
  const auto s =
      lowest_of_parabola(a, gap[before] - gap[node], b, gap[after] - gap[node]);
  if (!s) return {node, n};
  const Vector2d other = line.normal.col(*s < 0 ? before : after);
  const Vector2d direction =
      (n + *s / (*s < 0 ? a : b) * (other - n)).normalized();
  return {node, snapped_to_axis(direction, 0.05 * (other - n).norm())};
}

/// The straight line that shares an end with a curve gives its normal; of two with
/// different normals neither does.
std::optional<Spot> neighbouring_line(const ContactLine& line,
                                      const Nodes& curve) {
  std::optional<Spot> found;
  for (int e = 0; e < line.edge_count(); ++e)
    for (int node : line.edge_node.col(e))
      if (!turns(line, e) && (node == curve.front() || node == curve.back())) {
        if (found && found->direction != line.normal.col(node))
          return Spot{-1, Vector2d::Zero()};
        found = Spot{node, line.normal.col(node)};
      }
  return found;
}

bool stands_for_all(const Mesh& mesh, const ContactLine& line,
                    const Nodes& curve, const Spot& spot,
                    const Ref<const VectorXd>& gap) {
  if (spot.node < 0) return false;
  const Vector2d x0 = mesh.vertices.col(line.vertex[spot.node]);
  const double g0 = gap[spot.node];
  bool falls_back = false;
  for (int node : curve) {
    const double fall = (x0 - mesh.vertices.col(line.vertex[node]))
                            .dot(spot.direction),
                 opened = gap[node] - g0;
    if (!(line.normal.col(node).dot(spot.direction) > 0.5)) return false;
    // Beside a spot between two nodes the curve may reach beyond x_0.
    if (fall > 0 && opened < 0.5 * fall - 1.5 * line.precision) return false;
    falls_back = falls_back || fall > 1.5 * line.precision;
  }
  return falls_back;
}

}  // namespace

bool turns(const ContactLine& line) {
  for (int e = 0; e < line.edge_count(); ++e)
    if (turns(line, e)) return true;
  return false;
}

ContactLine with_one_direction_a_curve(const Mesh& mesh, ContactLine line,
                                       const Ref<const VectorXd>& gap) {
  require_size("gap", gap.size(), line.node_count());
  for (const Nodes& curve : curves_of(line)) {
    const Spot spot =
        neighbouring_line(line, curve).value_or(smallest_gap(line, curve, gap));
    if (!stands_for_all(mesh, line, curve, spot, gap)) continue;
    for (int node : curve) line.normal.col(node) = spot.direction;
  }
  return line;
}

}  // namespace ffcontact
