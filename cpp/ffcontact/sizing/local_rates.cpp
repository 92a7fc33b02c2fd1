// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/sizing/local_rates.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace ffcontact {

namespace {

constexpr double turning = 0.0175;  ///< sine of one degree
/// a bound on what a fit on a coarse mesh can say
constexpr double weakest_exponent = 0.1;
constexpr int least_radii = 4;
/// of the fit, in element sizes
constexpr double nearest_radius = 2, farthest_radius = 8;

int contact_or_not(int edge, const std::vector<int>& contact_edges) {
  return contact_edges[edge] >= 0 ? 1 : 0;
}

std::vector<int> candidates(const Topology& topology,
                            const BoundaryTractions& boundary,
                            const std::vector<int>& contact_edges) {
  const auto& [mesh, edges, stars] = topology;
  std::vector<int> result;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (stars.triangle_count(v) == 0 || !stars.on_boundary(v)) continue;
    const int out = stars.spoke[stars.spoke_start[v]],
              in = stars.spoke[stars.spoke_start[v + 1] - 1];
    const Vector2d a = edge_normal(mesh, edges, in),
                   b = edge_normal(mesh, edges, out);
    const bool turns =
        std::abs(a.x() * b.y() - a.y() * b.x()) > turning || a.dot(b) < 0;
    const bool changes =
        (boundary.known.col(in) != boundary.known.col(out)).any() ||
        contact_or_not(in, contact_edges) != contact_or_not(out, contact_edges);
    if (turns || changes) result.push_back(v);
  }
  return result;
}

double size_at(const Mesh& mesh, const Stars& stars, int v) {
  double area = 0;
  for (int s = stars.triangle_start[v]; s < stars.triangle_start[v + 1]; ++s)
    area += signed_area(mesh, stars.triangle[s]);
  return std::sqrt(2 * area / stars.triangle_count(v));
}

double reach(const Mesh& mesh, const std::vector<int>& others, int v) {
  double nearest = std::numeric_limits<double>::infinity();
  for (int w : others)
    if (w != v)
      nearest = std::min(nearest,
                         (mesh.vertices.col(w) - mesh.vertices.col(v)).norm());
  return std::isfinite(nearest) ? 0.5 * nearest : 0;
}

/// Slope of log W against log r over geometrically spaced radii, halved.
double fitted_exponent(
    const std::vector<std::pair<double, double>>& distance_and_energy,
    double smallest, double largest) {
  constexpr double spacing = 1.25;
  std::vector<double> x, y;
  for (double r = smallest; r <= largest; r *= spacing) {
    double W = 0;
    for (const auto& [distance, energy] : distance_and_energy)
      if (distance <= r) W += energy;
    if (W > 0) {
      x.push_back(std::log(r));
      y.push_back(std::log(W));
    }
  }
  if (x.size() < least_radii) return 1;
  const auto n = static_cast<Index>(x.size());
  const Map<const Eigen::ArrayXd> X(x.data(), n), Y(y.data(), n);
  const Eigen::ArrayXd dx = X - X.mean();
  return 0.5 * (dx * (Y - Y.mean())).sum() / dx.square().sum();
}

}  // namespace

std::vector<SingularVertex> singular_vertices(
    const Topology& topology, const Hooke& hooke,
    const Ref<const Matrix3Xd>& stress, const BoundaryTractions& boundary,
    const std::vector<int>& contact_edges) {
  const auto& [mesh, edges, stars] = topology;
  const std::vector<int> vertices =
      candidates(topology, boundary, contact_edges);
  VectorXd energy(mesh.cells.cols());
  Matrix2Xd centroid(2, mesh.cells.cols());
  for (int t = 0; t < mesh.cell_count(); ++t) {
    energy[t] = signed_area(mesh, t) *
                stress.col(t).dot(hooke[t].inverse() * stress.col(t));
    centroid.col(t) =
        (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
  }
  std::vector<SingularVertex> result;
  for (int v : vertices) {
    const double size = size_at(mesh, stars, v);
    const double largest =
        std::min(reach(mesh, vertices, v), farthest_radius * size);
    std::vector<std::pair<double, double>> near;
    for (int t = 0; t < mesh.cell_count(); ++t) {
      const double distance = (centroid.col(t) - mesh.vertices.col(v)).norm();
      if (distance <= largest) near.emplace_back(distance, energy[t]);
    }
    const double exponent =
        fitted_exponent(near, nearest_radius * size, largest);
    result.push_back({v, std::clamp(exponent, weakest_exponent, 1.0)});
  }
  return result;
}

VectorXd local_rates(const Topology& topology,
                     const std::vector<SingularVertex>& singular) {
  const Stars& stars = topology.stars;
  VectorXd rates = VectorXd::Ones(topology.mesh.cell_count());
  for (const SingularVertex& s : singular)
    for (int k = stars.triangle_start[s.vertex];
         k < stars.triangle_start[s.vertex + 1]; ++k)
      rates[stars.triangle[k]] = std::min(rates[stars.triangle[k]], s.exponent);
  return rates;
}

}  // namespace ffcontact
