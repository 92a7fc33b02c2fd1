// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/sizing/optimal_size.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <vector>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

/// What is asked for, in parts of the target: far from it, and at it.
constexpr double part_far = 0.92, part_at = 0.85;
/// A mesh is far from the target when it is off by more than this, as a part of it.
constexpr double closeness = 0.15;

/// area of the equilateral triangle of size 1
const double equilateral = std::sqrt(3.0) / 4;

/// Size of a triangle: edge length of the equilateral triangle of its area, which is what
/// meshers call its size.
double triangle_size(double area) { return std::sqrt(area / equilateral); }

/// Zero of an increasing function, bracketed outwards from 0 and halved.
double increasing_zero(const std::function<double(double)>& f) {
  double low = 0, high = 0;
  for (double step = 1; f(high) < 0; step *= 2) high += step;
  for (double step = 1; f(low) > 0; step *= 2) low -= step;
  while (high - low > 1e-14 * (1 + std::abs(low))) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (f(middle) < 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

void require_rates(const Mesh& mesh, const VectorXd& rate) {
  require_size("rate", rate.size(), mesh.cell_count());
  for (Index t = 0; t < rate.size(); ++t)
    if (!(rate[t] > 0) || !std::isfinite(rate[t]))
      refuse("rate[", t, "] must be positive, got ", rate[t]);
}

void require_target(double target) {
  if (!(target > 0) || !std::isfinite(target))
    refuse("target must be positive, got ", target);
  if (target >= 1)
    refuse("target is a part of the solution, 0.02 for 2 %, got ", target);
}

void require_bounds(double smallest, double largest) {
  if (!(smallest >= 0)) refuse("hmin must not be negative, got ", smallest);
  if (!(largest >= 0)) refuse("hmax must not be negative, got ", largest);
  if (largest > 0 && smallest > largest)
    refuse("hmin ", smallest, " exceeds hmax ", largest);
}

void require_valid(const SizeSettings& settings) {
  require_target(settings.target);
  if (!(settings.largest_step > 1))
    refuse("the largest step must exceed 1, got ", settings.largest_step);
  if (!(settings.gradation > 0))
    refuse("gradation must be positive, got ", settings.gradation);
  require_bounds(settings.smallest, settings.largest);
}

/// Vertex sizes that keep the density of elements: h^-2 is the mean of (r_E h_E)^-2 over
/// the star, weighted by area.
VectorXd vertex_sizes(const Mesh& mesh, const VectorXd& ratio) {
  VectorXd density = VectorXd::Zero(mesh.vertices.cols()), weight = density;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const double area = signed_area(mesh, t),
                 h = ratio[t] * triangle_size(area);
    for (const int v : mesh.cells.col(t)) {
      density[v] += area / (h * h);
      weight[v] += area;
    }
  }
  const auto has_triangles = weight.array() > 0;
  return has_triangles.select(weight.cwiseQuotient(density).cwiseSqrt(), 0);
}

/// Mean of h^-2 on a triangle.
double density(const Mesh& mesh, const VectorXd& size, int t) {
  double sum = 0;
  for (int k = 0; k < 3; ++k)
    sum += 1 / (3 * std::pow(size[mesh.cells(k, t)], 2));
  return sum;
}

double predicted_triangles(const Mesh& mesh, const VectorXd& size) {
  double count = 0;
  for (int t = 0; t < mesh.cell_count(); ++t)
    count += signed_area(mesh, t) * density(mesh, size, t) / equilateral;
  return count;
}

/// Mean size on a triangle in parts of its own.
double size_ratio(const Mesh& mesh, const VectorXd& size, int t) {
  return 1 / (triangle_size(signed_area(mesh, t)) *
              std::sqrt(density(mesh, size, t)));
}

/// (sum eps_E^2 r^(2 q_E))^(1/2) for the sizes that bounds and gradation have left.
double predicted_error(const Mesh& mesh, const VectorXd& size,
                       const VectorXd& local_error, const VectorXd& rate) {
  double square = 0;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const double ratio = size_ratio(mesh, size, t);
    square += std::pow(local_error[t] * std::pow(ratio, rate[t]), 2);
  }
  return std::sqrt(square);
}

double sum_of_squared_sides(const Mesh& mesh, int t) {
  double squares = 0;
  for (int k = 0; k < 3; ++k)
    squares += (mesh.corner(t, (k + 1) % 3) - mesh.corner(t, k)).squaredNorm();
  return squares;
}

/// Vertices that an edge joins with each vertex, and its length.
using Neighbours = std::vector<std::vector<std::pair<int, double>>>;

Neighbours neighbours_of(const Mesh& mesh, const Edges& edges) {
  Neighbours neighbours(mesh.vertices.cols());
  for (int e = 0; e < edges.count(); ++e) {
    const int i = edges.vertices(0, e), j = edges.vertices(1, e);
    const double length = edge_vector(mesh, edges, e).norm();
    neighbours[i].emplace_back(j, length);
    neighbours[j].emplace_back(i, length);
  }
  return neighbours;
}

double extent_of(const Mesh& mesh) {
  const Vector2d extents =
      mesh.vertices.rowwise().maxCoeff() - mesh.vertices.rowwise().minCoeff();
  return extents.maxCoeff();
}

/// Sizes between hmin and hmax; within the body's extent where these are not given.
VectorXd bounded_size(const VectorXd& size, double extent,
                      const SizeSettings& settings) {
  const double largest = settings.largest > 0 ? settings.largest : extent;
  const double smallest = std::max(settings.smallest, 1e-9 * extent);
  return size.cwiseMax(smallest).cwiseMin(largest);
}

/// The error to ask for on the way to the target.
double wanted_error(double now, const SizeSettings& settings) {
  const double distance =
      std::min(1.0, std::abs(now / settings.target - 1) / closeness);
  const double part = part_at + distance * (part_far - part_at);
  return std::max(part * settings.target, now / settings.largest_step);
}

}  // namespace

VectorXd size_ratios(const Ref<const VectorXd>& local_error,
                     const Ref<const VectorXd>& rate, double wanted) {
  const Eigen::ArrayXd squared = local_error.array().square(), q = rate.array();
  const double largest = squared.maxCoeff();
  if (largest == 0) return VectorXd::Ones(squared.size());
  // elements without error coarsen by a finite ratio
  const Eigen::ArrayXd bounded = squared.max(1e-12 * largest);
  const auto ratios = [&](double inverse_lambda) -> Eigen::ArrayXd {
    return (inverse_lambda / (q * bounded)).pow(1 / (2 * q + 2));
  };
  const double log_root = increasing_zero([&](double log_inverse) {
    const double inverse_lambda = std::exp(log_inverse);
    return (squared * ratios(inverse_lambda).pow(2 * q)).sum() /
               (wanted * wanted) -
           1;
  });
  VectorXd result = ratios(std::exp(log_root));
  const double coarsest = (squared > 0).select(result.array(), 0).maxCoeff();
  return (squared > 0).select(result.array(), coarsest);
}

VectorXd graded_size(const Mesh& mesh, const Edges& edges, VectorXd size,
                     double gradation) {
  const auto neighbours = neighbours_of(mesh, edges);
  // Dijkstra's algorithm: the smallest size is final and bounds its neighbours.
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (Index v = 0; v < size.size(); ++v)
    queue.emplace(size[v], static_cast<int>(v));
  while (!queue.empty()) {
    const auto [h, v] = queue.top();
    queue.pop();
    if (h > size[v]) continue;
    for (const auto& [w, length] : neighbours[v]) {
      const double most = h + gradation * length;
      if (size[w] <= most) continue;
      size[w] = most;
      queue.emplace(most, w);
    }
  }
  return size;
}

VectorXd shape_quality(const Mesh& mesh) {
  VectorXd quality(mesh.cells.cols());
  for (int t = 0; t < mesh.cell_count(); ++t)
    quality[t] = std::sqrt(16 * equilateral * signed_area(mesh, t) /
                           sum_of_squared_sides(mesh, t));
  return quality;
}

OptimalSize optimal_size(const Mesh& mesh, const Edges& edges,
                         const Ref<const VectorXd>& local_error,
                         const VectorXd& rate, const SizeSettings& settings) {
  require_size("eps_E", local_error.size(), mesh.cell_count());
  const VectorXd rates =
      rate.size() > 0 ? rate : VectorXd::Ones(local_error.size());
  require_rates(mesh, rates);
  require_nonnegative("eps_E", local_error);
  require_valid(settings);
  const VectorXd error = local_error.cwiseProduct(shape_quality(mesh));
  OptimalSize result;
  result.wanted = wanted_error(local_error.norm(), settings);
  result.ratio = size_ratios(error, rates, result.wanted);

  result.size = graded_size(
      mesh, edges,
      bounded_size(vertex_sizes(mesh, result.ratio), extent_of(mesh), settings),
      settings.gradation);
  result.predicted_count = predicted_triangles(mesh, result.size);
  result.predicted_error = predicted_error(mesh, result.size, error, rates);
  return result;
}

}  // namespace ffcontact
