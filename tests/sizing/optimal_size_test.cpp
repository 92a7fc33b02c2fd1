// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/sizing/optimal_size.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/mesh/edges.hpp"
#include "ffcontact/sizing/cell_shape.hpp"
#include "ffcontact/sizing/graded_size.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// sum eps_E^2 r_E^(2 q_E)
double squared_error(const VectorXd& error, const VectorXd& rate,
                     const VectorXd& ratio) {
  return (error.array().square() * ratio.array().pow(2 * rate.array())).sum();
}

/// sum r_E^-2
double element_count(const VectorXd& ratio) {
  return ratio.array().square().inverse().sum();
}

/// Positive values over two decades.
VectorXd random_errors(Index n, Random& random) {
  return (2.3 * random_vector(n, random)).array().exp() / 100;
}

VectorXd random_rates(Index n, Random& random) {
  return 0.65 + 0.35 * random_vector(n, random).array();
}

/// The ratios scaled back onto the constraint.
VectorXd made_feasible(const VectorXd& error, const VectorXd& rate,
                       VectorXd ratio, double wanted) {
  double low = 1e-3, high = 1e3;
  while (high / low > 1 + 1e-14) {
    const double middle = std::sqrt(low * high);
    (squared_error(error, rate, middle * ratio) < wanted * wanted ? low
                                                                  : high) =
        middle;
  }
  return low * ratio;
}

RC_GTEST_PROP(SizeRatios, meet_the_wanted_error, (Random random)) {
  const int n = *rc::gen::inRange(1, 60);
  const VectorXd error = random_errors(n, random),
                 rate = random_rates(n, random);
  const double wanted = *real(1e-4, 1);
  const VectorXd ratio = size_ratios(error, rate, wanted);
  RC_ASSERT(std::abs(std::sqrt(squared_error(error, rate, ratio)) / wanted -
                     1) < 1e-11);
}

RC_GTEST_PROP(SizeRatios,
              need_fewer_elements_than_any_other_sizes_of_that_error,
              (Random random)) {
  const int n = *rc::gen::inRange(2, 60);
  const VectorXd error = random_errors(n, random),
                 rate = random_rates(n, random);
  const double wanted = *real(1e-3, 1);
  const VectorXd ratio = size_ratios(error, rate, wanted);
  for (double size : {1e-3, 0.1, 1.0}) {
    const VectorXd other = ratio.cwiseProduct(
        (size * random_vector(n, random)).array().exp().matrix());
    RC_ASSERT(element_count(made_feasible(error, rate, other, wanted)) >=
              element_count(ratio) * (1 - 1e-11));
  }
}

RC_GTEST_PROP(
    SizeRatios,
    spread_the_error_evenly_over_the_new_elements_where_the_rate_is_one,
    (Random random)) {
  // r^4 = 1 / (Lambda eps^2): every new element has eps_E^2 r_E^2 / r_E^-2 = 1 / Lambda.
  const int n = *rc::gen::inRange(2, 60);
  const VectorXd error = random_errors(n, random);
  const VectorXd ratio = size_ratios(error, VectorXd::Ones(n), 0.01);
  const Eigen::ArrayXd share = error.array().square() * ratio.array().pow(4);
  RC_ASSERT(share.maxCoeff() / share.minCoeff() - 1 < 1e-10);
}

TEST(SizeRatios, of_elements_without_error_are_the_largest_of_the_others) {
  const Vector3d ratio =
      size_ratios(Vector3d(0.04, 0, 0.01), Vector3d::Ones(), 0.02);
  EXPECT_NEAR(ratio[1], ratio[2], 1e-12 * ratio[2]);
}

TEST(SizeRatios, are_one_where_there_is_no_error) {
  EXPECT_EQ(size_ratios(Vector2d::Zero(), Vector2d::Ones(), 0.1),
            Vector2d::Ones());
}

RC_GTEST_PROP(GradedSize, has_no_steeper_slope_and_is_the_largest_such_field,
              (Random random)) {
  const Mesh mesh = irregular(4, 3, 4, 3, random);
  const Edges edges = edges_of(mesh);
  const double gradation = *real(0.05, 1);
  const VectorXd size = random_errors(mesh.vertex_count(), random) * 100;
  const VectorXd graded = graded_size(mesh, edges.vertices, size, gradation);
  RC_ASSERT((size - graded).minCoeff() >= 0);
  std::vector<char> held(mesh.vertex_count(),
                         0);  // by its own size or by a neighbour
  for (int v = 0; v < mesh.vertex_count(); ++v) held[v] = graded[v] == size[v];
  for (int e = 0; e < edges.count(); ++e) {
    const double rise = gradation * edge_vector(mesh, edges, e).norm();
    const int v = edges.vertices(0, e), w = edges.vertices(1, e);
    RC_ASSERT(std::abs(graded[v] - graded[w]) <= rise * (1 + 1e-14));
    if (std::abs(graded[v] - graded[w] - rise) < 1e-14) held[v] = 1;
    if (std::abs(graded[w] - graded[v] - rise) < 1e-14) held[w] = 1;
  }
  RC_ASSERT(
      std::all_of(held.begin(), held.end(), [](char h) { return h != 0; }));
}

/// A square of n x n cells with a random error on every triangle.
struct Sized {
  Mesh mesh;
  Edges edges;
  VectorXd error;
  explicit Sized(Random& random)
      : mesh(irregular(6, 6, 10, 10, random)), edges(edges_of(mesh)) {
    error = random_errors(mesh.cell_count(), random);
  }
  OptimalSize size(const SizeSettings& settings) const {
    return optimal_size(mesh, edges.vertices, error, {}, settings);
  }
};

SizeSettings target(double wanted) {
  SizeSettings settings;
  settings.target = wanted;
  return settings;
}

RC_GTEST_PROP(OptimalSize, is_bounded_and_graded, (Random random)) {
  const Sized sized(random);
  SizeSettings settings = target(0.3 * sized.error.norm());
  settings.smallest = 0.2;
  settings.largest = 1.5;
  settings.gradation = 0.4;
  const OptimalSize result = sized.size(settings);
  RC_ASSERT(result.size.minCoeff() >= 0.2);
  RC_ASSERT(result.size.maxCoeff() <= 1.5);
  RC_ASSERT((graded_size(sized.mesh, sized.edges.vertices, result.size, 0.4) -
             result.size)
                .isZero(1e-14));
}

RC_GTEST_PROP(OptimalSize, goes_to_far_targets_in_steps, (Random random)) {
  const Sized sized(random);
  const double now = sized.error.norm();
  RC_ASSERT(std::abs(sized.size(target(now / 2)).wanted - 0.975 * now / 2) <
            1e-14);
  RC_ASSERT(std::abs(sized.size(target(now / 100)).wanted - now / 3) < 1e-14);
}

RC_GTEST_PROP(OptimalSize, of_an_eps_above_a_half_does_not_coarsen_much,
              (Random random)) {
  Sized sized(random);
  sized.error *= 0.6 / sized.error.norm();
  sized.error[0] *= 1e-3;
  const OptimalSize large = sized.size(target(0.5));
  RC_ASSERT(large.cautious);
  RC_ASSERT(large.ratio.maxCoeff() == 2);
  sized.error *= 0.4 / 0.6;
  const OptimalSize small = sized.size(target(0.3));
  RC_ASSERT(!small.cautious);
  RC_ASSERT(small.ratio.maxCoeff() > 2);
}

TEST(OptimalSize,
     of_an_even_mesh_counts_equilateral_triangles_of_the_wanted_error) {
  const Mesh mesh = rectangle(8, 8, 8, 8);
  const Edges edges = edges_of(mesh);
  const VectorXd error = VectorXd::Constant(128, 0.01);
  for (double part : {1.0, 0.5, 0.35}) {
    const OptimalSize result = optimal_size(mesh, edges.vertices, error, {},
                                            target(part * error.norm()));
    EXPECT_NEAR(result.predicted_error / result.wanted, 1, 1e-9);
    // For one area eps goes with the quality, (sqrt(3) / 2)^(1/2) for half a square and
    // 0.97 for new triangles; the count goes with eps^-2.
    const double expected = 128 * std::sqrt(3.0) / 2 / std::pow(0.97, 2) *
                            std::pow(error.norm() / result.wanted, 2);
    EXPECT_NEAR(result.predicted_count / expected, 1, 1e-9);
    EXPECT_NEAR(result.size.maxCoeff() / result.size.minCoeff(), 1, 1e-9);
    EXPECT_NEAR(result.spread, 0, 1e-12);
  }
}

TEST(OptimalSize, spread_is_the_deviation_of_the_logarithms_over_new_cells) {
  // r goes with eps_E^(-1/2): a quarter of the error has twice the size and a quarter of
  // the new triangles.
  const Mesh mesh = rectangle(8, 8, 8, 8);
  VectorXd error = VectorXd::Constant(128, 0.01);
  error.head(64) /= 4;
  const double share = 1.0 / 5;
  EXPECT_NEAR(optimal_size(mesh, edges_of(mesh).vertices, error, {},
                           target(0.5 * error.norm()))
                  .spread,
              std::log(2) * std::sqrt(share * (1 - share)), 1e-12);
}

/// int of h^2, h linear on each triangle, by the midpoints of its sides.
double squared_error_of_sizes(const Sized& sized, const VectorXd& size) {
  double sum = 0;
  for (int t = 0; t < sized.mesh.cell_count(); ++t) {
    const Eigen::Vector3d h = size(sized.mesh.cells.col(t));
    double mean = 0;
    for (int i = 0; i < 3; ++i)
      mean += std::pow((h[i] + h[(i + 1) % 3]) / 2, 2) / 3;
    const double edge = mean_edges(sized.mesh)[t];
    sum += std::pow(sized.error[t] / edge, 2) * mean;
  }
  return sum;
}

RC_GTEST_PROP(OptimalSize, has_the_wanted_error_though_sizes_are_steep,
              (Random random)) {
  Sized sized(random);
  sized.error = sized.error.array().pow(0.4);
  sized.error *= 0.5 / sized.error.norm();
  const OptimalSize result = sized.size(target(0.2));
  RC_ASSERT(std::abs(result.predicted_error / result.wanted - 1) < 0.01);
  RC_ASSERT(std::abs(squared_error_of_sizes(sized, result.size) /
                         std::pow(result.predicted_error, 2) -
                     1) < 1e-10);
}

TEST(OptimalSize, of_a_mesh_without_error_is_that_of_its_cells) {
  const Mesh mesh = rectangle(4, 4, 4, 4);
  const OptimalSize result = optimal_size(mesh, edges_of(mesh).vertices,
                                          VectorXd::Zero(32), {}, target(0.1));
  const double h = size_of_cell(mesh, 0);
  EXPECT_NEAR(result.size.minCoeff(), h, 1e-12);
  EXPECT_NEAR(result.size.maxCoeff(), h, 1e-12);
  EXPECT_EQ(result.error, 0);
}

TEST(OptimalSize, asks_for_the_part_of_the_target_that_is_given) {
  Random random(3);
  const Sized sized(random);
  SizeSettings settings = target(0.5 * sized.error.norm());
  settings.part = 1.25;
  EXPECT_NEAR(sized.size(settings).wanted, 1.25 * settings.target, 1e-14);
}

TEST(OptimalSize,
     the_closer_a_mesh_has_missed_the_target_the_less_is_asked_for) {
  Random random(3);
  const Sized sized(random);
  const double now = sized.error.norm();
  const auto part = [&](double miss) {
    return sized.size(target(now / miss)).wanted / (now / miss);
  };
  EXPECT_NEAR(part(1), 0.92, 1e-12);
  EXPECT_NEAR(part(1.075), 0.9475, 1e-12);
  EXPECT_NEAR(part(1.15), 0.975, 1e-12);
  EXPECT_NEAR(part(2), 0.975, 1e-12);
  EXPECT_NEAR(part(0.5), 0.975, 1e-12);
}

TEST(OptimalSize,
     loops_end_though_every_mesh_has_more_error_than_was_asked_for) {
  Random random(3);
  Sized sized(random);
  for (double more : {1.0, 1.02, 1.05, 1.08})
    for (double first : {1.01, 1.3, 2.0, 8.0}) {
      const double wanted = sized.error.norm() / first;
      Sized next = sized;
      int meshes = 0;
      for (; next.error.norm() > wanted && meshes < 10; ++meshes)
        next.error *=
            more * next.size(target(wanted)).wanted / next.error.norm();
      EXPECT_LE(meshes, first > 3 ? 5 : 3)
          << more << " times, from " << first << " times the target";
    }
}

TEST(ShapeQuality, is_one_for_equilateral_triangles_and_093_for_half_a_square) {
  Mesh mesh = rectangle(1, 1, 1, 1);
  EXPECT_NEAR(shape_quality(mesh)[0], std::sqrt(std::sqrt(3.0) / 2), 1e-14);
  mesh.vertices.col(3) << 0.5, std::sqrt(0.75);
  mesh.cells = (Matrix3Xi(3, 1) << 0, 1, 3).finished();
  EXPECT_NEAR(shape_quality(mesh)[0], 1, 1e-14);
}

TEST(OptimalSize, refuses_bad_errors_and_settings) {
  Random random(1);
  const Sized good(random);
  const auto refusal_of = [&](auto spoil) {
    Sized sized = good;
    SizeSettings settings = target(0.01);
    spoil(sized.error, settings);
    return refusal([&] { sized.size(settings); });
  };
  using Vector = VectorXd;
  EXPECT_EQ(refusal_of([](Vector&, SizeSettings&) {}), "accepted");
  EXPECT_TRUE(says(refusal_of([](Vector& e, SizeSettings&) { e[2] = -1; }),
                   "eps_E must be finite and not negative, but value 2"));
  EXPECT_TRUE(
      says(refusal_of([](Vector& e, SizeSettings&) { e[2] = std::nan(""); }),
           "eps_E must be finite"));
  EXPECT_TRUE(says(
      refusal_of([](Vector& e, SizeSettings&) { e.conservativeResize(3); }),
      "eps_E has 3 values"));
  EXPECT_EQ(refusal_of([](Vector&, SizeSettings& s) { s.target = 0; }),
            "target must be positive, got 0");
  EXPECT_EQ(
      refusal_of([](Vector&, SizeSettings& s) { s.target = std::nan(""); }),
      "target must be positive, got nan");
  EXPECT_EQ(refusal_of([](Vector&, SizeSettings& s) { s.target = 2; }),
            "target is a part of the solution, 0.02 for 2 %, got 2");
  EXPECT_EQ(refusal_of([](Vector&, SizeSettings& s) { s.gradation = 0; }),
            "gradation must be positive, got 0");
  EXPECT_EQ(refusal_of([](Vector&, SizeSettings& s) { s.part = -1; }),
            "part must not be negative, got -1");
  EXPECT_EQ(refusal_of([](Vector&, SizeSettings& s) {
              s.smallest = 3, s.largest = 2;
            }),
            "hmin 3 exceeds hmax 2");
}

}  // namespace
}  // namespace ffcontact
