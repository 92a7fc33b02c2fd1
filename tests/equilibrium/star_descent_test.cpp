// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_descent.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "ffcontact/base/least_squares.hpp"
#include "ffcontact/equilibrium/boundary_corrections.hpp"
#include "support/cases.hpp"
#include "support/estimates.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Numbers of a triangle's unknowns among all, as LocalAiry holds them.
std::vector<Index> unknowns_of(const AirySpace& space, int triangle) {
  std::vector<Index> result;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      result.push_back(space.of_vertex(space.mesh.cells(r, triangle)) + c);
  for (int r = 0; r < 3; ++r)
    result.push_back(space.of_edge(space.edges.of_cell(r, triangle)));
  return result;
}

VectorXd as_vector(const LocalAiry& x) {
  VectorXd result(12);
  result << x.at_vertices.reshaped(), x.on_edges;
  return result;
}

/// What relaxation starts from, and its energy x'Kx + 2 g'x as a dense form.
struct Dense {
  Problem problem;
  Equilibrated fields = equilibrated(problem, solved(problem));
  StarSetting setting =
      star_setting(fields.topology, problem.hooke, fields.boundary,
                   fields.loads, fields.difference);
  Index n = setting.space.unknowns();
  MatrixXd K = MatrixXd::Zero(n, n);
  VectorXd g = VectorXd::Zero(n);

  explicit Dense(Problem made) : problem(std::move(made)) {
    for (int t = 0; t < problem.mesh.cell_count(); ++t) {
      const std::vector<Index> at = unknowns_of(setting.space, t);
      const AiryEnergy& energy = setting.energies[t];
      g(at) += as_vector(energy.slope);
      for (Index j : at) {
        const VectorXd unit = VectorXd::Unit(n, j);
        K(at, std::vector<Index>{j}) +=
            as_vector(energy.times(local_airy(setting.space, unit, t)));
      }
    }
  }
  Dense(const Dense&) = delete;

  double energy(const VectorXd& x) const { return x.dot(K * x + 2 * g); }

  /// The corrections of one star [n x own].
  MatrixXd corrections(int vertex) const {
    const Stars& stars = setting.stars;
    const MatrixXd Z =
        stars.on_boundary(vertex)
            ? admissible_corrections(StarGroup(setting, {vertex}),
                                     setting.boundary, nullptr)
            : MatrixXd(MatrixXd::Identity(star_unknowns(stars, vertex),
                                          star_unknowns(stars, vertex)));
    MatrixXd result = MatrixXd::Zero(n, Z.cols());
    for (int c = 0; c < 3; ++c)
      result.row(setting.space.of_vertex(vertex) + c) = Z.row(c);
    for (int k = 0; k < stars.spoke_count(vertex); ++k)
      result.row(setting.space.of_edge(
          stars.spoke[stars.spoke_start[vertex] + k])) = Z.row(3 + k);
    return result;
  }

  /// The least energy that corrections of all stars reach.
  double least() const {
    MatrixXd Z(n, 0);
    for (int v = 0; v < problem.mesh.vertex_count(); ++v) {
      const MatrixXd own = corrections(v);
      Z.conservativeResize(Eigen::NoChange, Z.cols() + own.cols());
      Z.rightCols(own.cols()) = own;
    }
    const VectorXd slope = Z.transpose() * g;
    return -slope.dot(least_squares(Z.transpose() * K * Z, slope));
  }
};

Problem irregular_problem(Random& random) {
  Problem problem = body(irregular(4, 3, 4, 3, random), material(1000, 0.3));
  add_traction(problem, left, {1, -2});
  clamp(problem, top);
  set_friction(problem, 0.3);
  return problem;
}

RC_GTEST_PROP(StarSolves, sums_what_every_star_does_alone, (Random random)) {
  const Dense dense(irregular_problem(random));
  const VectorXd r = random_vector(dense.n, random);
  VectorXd sum = VectorXd::Zero(dense.n);
  for (int v = 0; v < dense.problem.mesh.vertex_count(); ++v) {
    const MatrixXd Z = dense.corrections(v);
    if (Z.cols() > 0)
      sum += Z * (Z.transpose() * dense.K * Z).llt().solve(Z.transpose() * r);
  }
  const VectorXd z = StarSolves(dense.setting)(r);
  RC_ASSERT((z - sum).norm() < 1e-4 * sum.norm());
}

RC_GTEST_PROP(StarDescent, falls_by_what_the_energy_falls, (Random random)) {
  const Dense dense(irregular_problem(random));
  StarDescent descent(dense.setting);
  const double scale = -dense.least();
  for (int step = 0; step < 5; ++step) {
    const double before = dense.energy(descent.airy()), fall = descent.step();
    RC_ASSERT(fall >= 0);
    RC_ASSERT(std::abs(before - fall - dense.energy(descent.airy())) <
              1e-11 * scale);
  }
}

RC_GTEST_PROP(StarDescent, ends_at_the_least_energy_of_all_stars,
              (Random random)) {
  const Dense dense(irregular_problem(random));
  StarDescent descent(dense.setting);
  for (int step = 0; step < 300; ++step) descent.step();
  const double least = dense.least();
  RC_ASSERT(std::abs(dense.energy(descent.airy()) - least) <
            1e-6 * std::abs(least));
}

RC_GTEST_PROP(StarDescent, goes_on_from_what_others_have_changed,
              (Random random)) {
  const Dense dense(irregular_problem(random));
  StarDescent descent(dense.setting);
  descent.step();
  const Stars& stars = dense.setting.stars;
  const int vertex = dense.problem.mesh.cells(0, 5);
  const std::set<int> beside(
      stars.triangle.begin() + stars.triangle_start[vertex],
      stars.triangle.begin() + stars.triangle_start[vertex + 1]);
  const MatrixXd Z = dense.corrections(vertex);
  RC_PRE(Z.cols() > 0);
  const VectorXd change = 10 * Z * random_vector(Z.cols(), random);
  RC_ASSERT(descent.changed(beside, [&](VectorXd& airy) {
    airy += change;
    return 7.0;
  }) == 7);
  const double scale = dense.energy(descent.airy()) - dense.least();
  for (int step = 0; step < 300; ++step) {
    const double before = dense.energy(descent.airy()), fall = descent.step();
    RC_ASSERT(std::abs(before - fall - dense.energy(descent.airy())) <
              1e-10 * scale);
  }
  RC_ASSERT(dense.energy(descent.airy()) - dense.least() < 1e-6 * scale);
}

/// Leaves NaN in small pieces of memory that are allocated next.
void spoil_the_heap() {
  std::vector<std::vector<float>> pieces;
  for (std::size_t size = 1; size <= 256; ++size)
    pieces.emplace_back(size, std::numeric_limits<float>::quiet_NaN());
}

TEST(StarDescent, leaves_vertices_without_triangles_alone) {
  Mesh mesh = rectangle(1, 1, 3, 3);
  mesh.vertices.conservativeResize(Eigen::NoChange, mesh.vertex_count() + 1);
  mesh.vertices.rightCols<1>() << 9, 9;
  const Topology topology = topology_of(mesh);
  const EdgeLoadsOfAll difference =
      EdgeLoadsOfAll::Random(12, mesh.cell_count());
  const BoundaryTractions boundary{
      Eigen::Array<bool, 2, Dynamic>::Constant(2, topology.edges.count(),
                                               false),
      EdgeMoments::Zero(4, topology.edges.count())};
  const StarSetting setting = star_setting(
      topology, Hooke(mesh.cell_count(), material(1000, 0.3).hooke()), boundary,
      BodyLoadsOfAll::Zero(6, mesh.cell_count()), difference);
  const VectorXd r = VectorXd::Ones(setting.space.unknowns());
  spoil_the_heap();
  const VectorXd z = StarSolves(setting)(r);
  EXPECT_TRUE(z.allFinite());
  EXPECT_TRUE(
      z.segment<3>(setting.space.of_vertex(mesh.vertex_count() - 1)).isZero(0));
}

}  // namespace
}  // namespace ffcontact
