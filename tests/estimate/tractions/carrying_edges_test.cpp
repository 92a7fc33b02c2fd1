// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/carrying_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "support/problems.hpp"

namespace ffcontact {
namespace {

using namespace test;

constexpr double length = 8;

/// A line of edges of 1 mm that does not move and is so far from its foundation.
Problem on_foundation(const std::function<double(double)>& gap) {
  Problem problem = body(rectangle(8, 1, length, 1), material(1, 0));
  const VectorXi& vertex = problem.line.vertex;
  problem.law.gap = VectorXd::NullaryExpr(vertex.size(), [&](Index i) {
    return gap(problem.mesh.vertices(0, vertex[i]));
  });
  return problem;
}

/// What edges carry, from left to right, where such pressures gain their own number of
/// millimetres.
std::vector<Carrying> carried(const Problem& problem,
                              const std::function<double(double)>& pressure) {
  const Mesh& mesh = problem.mesh;
  const ContactLine& line = problem.line;
  Matrix2Xd traction = Matrix2Xd::Zero(2, line.node_count());
  for (int i = 0; i < line.node_count(); ++i)
    traction(0, i) = -pressure(mesh.vertices(0, line.vertex[i]));
  const std::vector<Carrying> of_edges =
      carrying_edges(line, problem.law, VectorXd::Zero(2 * mesh.vertex_count()),
                     VectorXd::Ones(line.edge_count()), traction);
  std::vector<Carrying> result(of_edges.size());
  for (int e = 0; e < line.edge_count(); ++e)
    result[static_cast<int>(mesh.vertices(
        0, line.vertex[line.edge_node.col(e).minCoeff()]))] = of_edges[e];
  return result;
}

std::vector<Carrying> any_up_to(int edges) {
  std::vector<Carrying> result(static_cast<std::size_t>(length),
                               Carrying::nothing);
  std::fill_n(result.begin(), edges, Carrying::any);
  return result;
}

/// The foundation is so much lower beyond x = 3.5 mm.
std::vector<Carrying> carried_beside_a_step(double depth) {
  const auto closed = [](double x) { return x < 3.5; };
  return carried(on_foundation([&](double x) { return closed(x) ? 0 : depth; }),
                 closed);
}

TEST(CarryingEdges, beside_a_step_carry_nothing_that_the_closed_ones_can) {
  // the edge over the step is open by half of it
  EXPECT_EQ(carried_beside_a_step(2.9), any_up_to(8));
  EXPECT_EQ(carried_beside_a_step(5.9), any_up_to(4));
  EXPECT_EQ(carried_beside_a_step(6.1), any_up_to(3));
  EXPECT_EQ(carried_beside_a_step(1e30), any_up_to(3));
}

TEST(CarryingEdges, that_open_little_keep_what_no_others_carry) {
  const auto end = [](double x) { return x == 0; };
  const auto around_a_ridge = [&](double depth) {
    return carried(on_foundation([&](double x) { return end(x) ? 0 : depth; }),
                   end);
  };
  EXPECT_EQ(around_a_ridge(6.1), any_up_to(1));
  EXPECT_EQ(around_a_ridge(19.9), any_up_to(1));
  EXPECT_EQ(around_a_ridge(20.1), any_up_to(0));
}

TEST(CarryingEdges, all_may_carry_if_none_does) {
  EXPECT_EQ(carried(on_foundation([](double) { return 1e30; }),
                    [](double) { return 0; }),
            any_up_to(8));
}

}  // namespace
}  // namespace ffcontact
