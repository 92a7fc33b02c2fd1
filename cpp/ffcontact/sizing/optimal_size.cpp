// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/sizing/optimal_size.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "ffcontact/base/over.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ffcontact/sizing/cell_shape.hpp"
#include "ffcontact/sizing/graded_size.hpp"

namespace ffcontact {

namespace {

/// What is asked for, in parts of the target: far from it, and of a mesh just above it.
constexpr double part_far = 0.975, part_at = 0.92;
/// A mesh is far from the target when it is off by more than this, as a part of it.
constexpr double closeness = 0.15;

/// eps above which cells grow by this factor at most
constexpr double too_large = 0.5, most_growth = 2;

/// Means of steep sizes on coarse cells, bounds and gradation change the error that is
/// predicted: all sizes are scaled, by this at most, until it is the wanted one.
constexpr double most_scaled = 1.3;
constexpr int passes = 4;

/// shape_quality of the cells that meshers make
template <int dim>
constexpr double usual_quality = dim == 2 ? 0.97 : 0.9;

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

void require_rates(const VectorXd& rate, int cells) {
  require_size("rate", rate.size(), cells);
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
  if (!(settings.part >= 0) || !std::isfinite(settings.part))
    refuse("part must not be negative, got ", settings.part);
  if (!(settings.largest_step > 1))
    refuse("the largest step must exceed 1, got ", settings.largest_step);
  if (!(settings.gradation > 0))
    refuse("gradation must be positive, got ", settings.gradation);
  require_bounds(settings.smallest, settings.largest);
}

/// Vertex sizes that keep the density of elements: h^-dim is the mean of (r_E h_E)^-dim
/// over the star, weighted by volume.
template <int dim>
VectorXd vertex_sizes(const SimplexMesh<dim>& mesh, const VectorXd& ratio) {
  VectorXd density = VectorXd::Zero(mesh.vertices.cols()), weight = density;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const double volume = signed_volume(mesh, t),
                 h = ratio[t] * size_of_cell(mesh, t);
    for (const int v : mesh.cells.col(t)) {
      density[v] += volume * std::pow(h, -dim);
      weight[v] += volume;
    }
  }
  const auto has_cells = weight.array() > 0;
  return has_cells.select(weight.cwiseQuotient(density).array().pow(1.0 / dim),
                          0);
}

/// Mean of h^-dim on a cell.
template <int dim>
double density(const SimplexMesh<dim>& mesh, const VectorXd& size, int t) {
  double sum = 0;
  for (const int v : mesh.cells.col(t)) sum += std::pow(size[v], -dim);
  return sum / (dim + 1);
}

template <int dim>
double predicted_cells(const SimplexMesh<dim>& mesh, const VectorXd& size) {
  return sum_over(mesh.cell_count(),
                  [&](int t) {
                    return signed_volume(mesh, t) * density(mesh, size, t);
                  }) /
         (regular_volume<dim>() * std::pow(usual_quality<dim>, dim));
}

/// Standard deviation of log r_E over the new cells.
template <int dim>
double spread_of(const VectorXd& ratio) {
  const Eigen::ArrayXd log_ratio = ratio.array().log(),
                       weight = ratio.array().pow(-dim) /
                                ratio.array().pow(-dim).sum();
  const double mean = (weight * log_ratio).sum();
  return std::sqrt((weight * (log_ratio - mean).square()).sum());
}

double square_of(double x) { return x * x; }

/// Mean of h^2 on a cell, where h is linear: what the squared error goes with. Where sizes
/// are steep it is more than the square of the mean size.
template <int dim>
double mean_square(const SimplexMesh<dim>& mesh, const VectorXd& size, int t) {
  const Matrix<double, dim + 1, 1> h = size(mesh.cells.col(t));
  return (h.squaredNorm() + square_of(h.sum())) / ((dim + 1) * (dim + 2));
}

/// (sum eps_E^2 r^(2 q_E))^(1/2) for the sizes that bounds and gradation have left.
template <int dim>
double predicted_error(const SimplexMesh<dim>& mesh, const VectorXd& size,
                       const VectorXd& local_error, const VectorXd& rate) {
  double square = 0;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const double ratio =
        mean_square(mesh, size, t) / square_of(size_of_cell(mesh, t));
    square += square_of(local_error[t]) * std::pow(ratio, rate[t]);
  }
  return std::sqrt(square);
}

/// Sizes between hmin and hmax; within the body's extent where these are not given.
VectorXd bounded_size(const VectorXd& size, double extent,
                      const SizeSettings& settings) {
  const double largest = settings.largest > 0 ? settings.largest : extent;
  const double smallest = std::max(settings.smallest, 1e-9 * extent);
  return size.cwiseMax(smallest).cwiseMin(largest);
}

/// Of a mesh that is above the target by `miss`, as a part of it.
double part_asked(double miss) {
  if (miss < 0) return part_far;
  return part_at + std::min(1.0, miss / closeness) * (part_far - part_at);
}

/// The error to ask for on the way to the target.
double wanted_error(double now, const SizeSettings& settings) {
  const double part =
      settings.part > 0 ? settings.part : part_asked(now / settings.target - 1);
  return std::max(part * settings.target, now / settings.largest_step);
}

/// Of all sizes, so that the error that is predicted becomes the wanted one.
double next_scale(double scale, const OptimalSize& result) {
  if (result.predicted_error == 0) return scale;
  return std::clamp(scale * result.wanted / result.predicted_error,
                    1 / most_scaled, result.cautious ? 1 : most_scaled);
}

}  // namespace

template <int dim>
VectorXd size_ratios(const Ref<const VectorXd>& local_error,
                     const Ref<const VectorXd>& rate, double wanted) {
  const Eigen::ArrayXd squared = local_error.array().square(), q = rate.array();
  const double largest = squared.maxCoeff();
  if (largest == 0) return VectorXd::Ones(squared.size());
  // elements without error coarsen by a finite ratio
  const Eigen::ArrayXd bounded = squared.max(1e-12 * largest);
  const auto ratios = [&](double inverse_lambda) -> Eigen::ArrayXd {
    return (inverse_lambda / (q * bounded)).pow(1 / (2 * q + dim));
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

template <int dim>
OptimalSize optimal_size(const SimplexMesh<dim>& mesh,
                         const Ref<const Matrix2Xi>& edges,
                         const Ref<const VectorXd>& local_error,
                         const VectorXd& rate, const SizeSettings& settings) {
  require_size("eps_E", local_error.size(), mesh.cell_count());
  const VectorXd rates =
      rate.size() > 0 ? rate : VectorXd::Ones(local_error.size());
  require_rates(rates, mesh.cell_count());
  require_nonnegative("eps_E", local_error);
  require_valid(settings);
  const VectorXd error = local_error.cwiseProduct(shape_quality(mesh));
  OptimalSize result;
  result.error = local_error.norm();
  result.wanted = wanted_error(result.error, settings);
  result.ratio = size_ratios<dim>(error, rates, result.wanted);
  result.spread = spread_of<dim>(result.ratio);
  result.cautious = result.error > too_large;
  if (result.cautious) result.ratio = result.ratio.cwiseMin(most_growth);

  const VectorXd sizes = vertex_sizes(mesh, result.ratio);
  const double extent = box_sides(mesh.vertices).maxCoeff();
  double scale = 1;
  for (int pass = 0; pass < passes; ++pass) {
    result.size =
        graded_size(mesh, edges, bounded_size(scale * sizes, extent, settings),
                    settings.gradation);
    result.predicted_error = predicted_error(mesh, result.size, error, rates);
    scale = next_scale(scale, result);
  }
  result.predicted_count = predicted_cells(mesh, result.size);
  return result;
}

template VectorXd size_ratios<FFCONTACT_DIMENSION>(const Ref<const VectorXd>&,
                                                   const Ref<const VectorXd>&,
                                                   double);
template OptimalSize optimal_size(const SimplexMesh<FFCONTACT_DIMENSION>&,
                                  const Ref<const Matrix2Xi>&,
                                  const Ref<const VectorXd>&, const VectorXd&,
                                  const SizeSettings&);

}  // namespace ffcontact
