// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/sizing/edge_rates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ffcontact/equilibrium/tractions/wrench_basis.hpp"
#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A block (0, 2) x (0, 1) x (0, 1) all of whose boundary tractions are known.
struct Block {
  Topology<3> topology;
  KnownComponents known;
  std::vector<char> is_contact;

  explicit Block(const SolidMesh& mesh) : topology(topology_of(mesh)) {
    known.setConstant(3, topology.facets.count(), true);
    is_contact.assign(topology.facets.count(), 0);
  }
  explicit Block(int cells)
      : Block(brick({2 * cells, cells, cells}, {2, 1, 1})) {}

  /// For a stress of the size d^(alpha - 1), d the distance to the x axis, and a larger one
  /// beside the ends.
  std::vector<SingularLine> singular(double alpha) const {
    const SolidMesh& mesh = topology.mesh;
    CellStresses<3> stress(6, mesh.cell_count());
    for (int t = 0; t < mesh.cell_count(); ++t) {
      const Vector3d x = corners_of(mesh, t).rowwise().mean();
      Vector6d size;
      size << 1, -0.5, 0.3, 0.2, 0.1, -0.4;
      const bool beside_end = std::abs(x.x() - 1) > 0.55;
      stress.col(t) =
          (beside_end ? 100 : std::pow(x.tail<2>().norm(), alpha - 1)) * size;
    }
    return singular_lines(
        topology, HookeTensors<3>(mesh.cell_count(), isotropic<3>(1, 1)),
        stress, known, is_contact);
  }
};

bool is_on_axis(const Block& block, const SingularLine& line) {
  return std::all_of(line.edges.begin(), line.edges.end(), [&](int e) {
    for (int v : block.topology.ridges.vertices.col(e))
      if (block.topology.mesh.vertices.col(v).tail<2>().norm() > 0)
        return false;
    return true;
  });
}

TEST(SingularLines, have_the_exponent_of_the_energy_about_them) {
  std::mt19937 random(7);
  const Block regular(12),
      irregular(shuffled(
          moved(brick({24, 12, 12}, {2, 1, 1}), 1.0 / 12, 0.15, random),
          random));
  for (const Block* block : {&regular, &irregular})
    for (double alpha : {0.4, 0.5, 0.7, 1.0}) {
      const std::vector<SingularLine> found = block->singular(alpha);
      EXPECT_EQ(found.size(), 12u);
      int on_axis = 0;
      for (const SingularLine& line : found) {
        if (is_on_axis(*block, line)) {
          ++on_axis;
          EXPECT_EQ(line.edges.size(), 24u);
          std::printf("alpha %.1f: %.3f\n", alpha, line.exponent);
          EXPECT_NEAR(line.exponent, alpha, 0.1);
        } else {
          EXPECT_GT(line.exponent, 0.85);
        }
      }
      EXPECT_EQ(on_axis, 1);
    }
}

TEST(SingularLines, have_the_exponent_one_where_the_mesh_is_too_coarse) {
  for (const SingularLine& line : Block(4).singular(0.5))
    EXPECT_EQ(line.exponent, 1);
}

TEST(SingularLines, are_the_edges_and_where_the_boundary_condition_changes) {
  Block block(4);
  EXPECT_EQ(block.singular(1).size(), 12u);
  // the lower side is in contact left of x = 1: two of its edges break there, and one
  // line crosses it
  const Topology<3>& topology = block.topology;
  for (int f = 0; f < topology.facets.count(); ++f) {
    const Matrix3d x =
        topology.mesh.vertices(Eigen::all, topology.facets.vertices.col(f));
    block.is_contact[f] = x.row(2).maxCoeff() == 0 && x.row(0).maxCoeff() <= 1;
  }
  EXPECT_EQ(block.singular(1).size(), 15u);
  block = Block(4);
  for (int f = 0; f < topology.facets.count(); ++f) {
    const Matrix3d x = block.topology.mesh.vertices(
        Eigen::all, block.topology.facets.vertices.col(f));
    if (x.row(2).maxCoeff() == 0 && x.row(0).maxCoeff() <= 1)
      block.known(1, f) = false;
  }
  EXPECT_EQ(block.singular(1).size(), 15u);
}

/// A cylinder has two edges, of one closed line each.
TEST(SingularLines, go_on_around_a_blunt_polygon) {
  SolidMesh mesh = brick({24, 2, 2}, {2 * M_PI, 1, 1});
  // rolled up: x is the angle, its first and last vertices are one
  std::vector<int> number(mesh.vertex_count());
  std::vector<Vector3d> places;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const Vector3d x = mesh.vertices.col(v);
    if (x.x() > 2 * M_PI - 1e-9) {
      number[v] = number[v - 24];
      continue;
    }
    number[v] = static_cast<int>(places.size());
    places.emplace_back((2 - x.z()) * std::cos(x.x()),
                        (2 - x.z()) * std::sin(x.x()), -x.y());
  }
  mesh.vertices.resize(3, static_cast<Index>(places.size()));
  for (std::size_t v = 0; v < places.size(); ++v)
    mesh.vertices.col(static_cast<Index>(v)) = places[v];
  for (int& v : mesh.cells.reshaped()) v = number[v];
  add_boundary(mesh);
  const std::vector<SingularLine> found = Block(mesh).singular(1);
  EXPECT_EQ(found.size(), 4u);  // a ring's: inside and outside, at both ends
  for (const SingularLine& line : found) EXPECT_EQ(line.edges.size(), 24u);
}

TEST(SingularLines, rates_are_the_exponents_around_them_and_one_elsewhere) {
  const Block block(4);
  std::vector<SingularLine> lines = block.singular(1);
  lines.resize(2);
  lines[0].exponent = 0.7;
  lines[1].exponent = 0.4;
  const VectorXd rates = local_rates(block.topology, lines);
  const auto touches = [&](int t, const SingularLine& line) {
    for (int e : line.edges)
      for (int v : block.topology.ridges.vertices.col(e))
        if ((block.topology.mesh.cells.col(t).array() == v).any()) return true;
    return false;
  };
  for (int t = 0; t < rates.size(); ++t)
    EXPECT_EQ(rates[t], touches(t, lines[1])   ? 0.4
                        : touches(t, lines[0]) ? 0.7
                                               : 1);
}

}  // namespace
}  // namespace ffcontact
