// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/multigrid/surface_unknowns.hpp"
#include "ffcontact/linear/norms.hpp"
#include "support/by_multigrid.hpp"
#include "support/cut_solids.hpp"
#include "support/solid_bodies.hpp"

/// Contact surfaces whose vertices are nodes of several sheets.
namespace ffcontact::test {

/// The block of block_problem on its bottom, one or two of its sides between rigid walls.
inline SolidProblem block_in_a_corner(const SolidMesh& mesh, int walls,
                                      double mu) {
  std::vector<int> labels{low_z, low_x, low_y};
  labels.resize(1 + walls);
  SolidProblem problem(mesh, mu, labels);
  problem.load(high_z, {0, 0, -5});
  problem.load(high_x, {-3, 0.3, 0});
  problem.load(high_y, {0, -2, 0});
  if (walls < 2) problem.guide(low_y, 1);
  if (walls < 1) problem.guide(low_x, 0);
  return problem;
}

/// A brick that lies on another one, beside one or two more, or in the corner of an L.
struct SolidCorner {
  JoinedSolids joined;
  SolidProblem problem;

  /// Of bodies whose meshes do not match.
  SolidCorner(int walls, double mu, Random& random, int n = 2)
      : SolidCorner(bodies(n, random), mu) {
    face({{low_z, 1, high_z}, {low_x, 2, high_x}, {low_y, 3, high_y}},
         1 + walls, mu);
    constexpr int held[] = {low_z, low_x, low_y};
    for (int k = 0; k < 3; ++k) hold(1 + k, held[k]);
    if (walls < 2) problem.guide(label(0, low_y), 1);
  }

  static SolidCorner of_matching_meshes(double mu) {
    const SolidMesh whole = brick({6, 2, 4}, {3, 1, 2});
    std::vector<int> piece;
    for (int t = 0; t < whole.cell_count(); ++t) {
      const Vector3d x =
          whole.vertices(Eigen::all, whole.cells.col(t)).rowwise().mean();
      piece.push_back(x.x() > 1 && x.z() > 1 ? 0 : 1);
    }
    SolidCorner corner({piece_of(whole, piece, 0), piece_of(whole, piece, 1)},
                       mu);
    corner.face({{low_z, 1, high_z}, {low_x, 1, high_x}}, 2, mu);
    corner.hold(1, low_z);
    for (const int body : {0, 1})
      corner.problem.guide(corner.label(body, low_y), 1);
    return corner;
  }

  int label(int body, int side) const { return joined.label(body, side); }

 private:
  SolidCorner(const std::vector<SolidMesh>& meshes, double mu)
      : joined(joined_mesh(meshes)),
        problem(joined.mesh, mu, {label(0, low_z)}) {
    problem.load(label(0, high_z), {0.3, 0.2, -5});
    problem.load(label(0, high_x), {-3, 0, 0});
    problem.load(label(0, high_y), {0, -2, 0});
  }

  static std::vector<SolidMesh> bodies(int n, Random& random) {
    const int m = n + n / 2;
    return {random_brick({2 * n, n, n}, {0, 0, 0}, {2, 1, 1}, random),
            random_brick({2 * m, m, n}, {-1, -1, -1}, {4, 3, 1}, random),
            random_brick({n, m, n}, {-1, -1, 0}, {1, 3, 2}, random),
            random_brick({m, n, n}, {0, -1, 0}, {3, 1, 2}, random)};
  }

  void hold(int body, int side) {
    problem.move(label(body, side),
                 [](const Vector3d&) { return Vector3d::Zero(); });
  }

  struct Side {
    int own, body, other;
  };
  void face(const std::vector<Side>& sides, int count, double mu) {
    std::vector<ContactSurface> surfaces;
    std::vector<double> gap;
    for (int k = 0; k < count; ++k) {
      const auto& [own, body, other] = sides[k];
      const FacingSurface pair = facing(problem.mesh, problem.faces,
                                        label(0, own), label(body, other));
      surfaces.push_back(pair.surface);
      gap.insert(gap.end(), pair.gap.begin(), pair.gap.end());
    }
    problem.surface = joined_contact<3>(surfaces);
    const int nodes = problem.surface.node_count();
    problem.law.friction = VectorXd::Constant(nodes, mu);
    problem.law.gap = Map<VectorXd>(gap.data(), nodes);
  }
};

/// A brick on a larger one, a side of it moved, which holds a part of its contact surface.
inline SolidStack brick_with_a_moved_side(double mu, double stiffness) {
  SolidStack stack = brick_on_a_larger_one(mu, stiffness);
  SolidProblem& problem = stack.problem;
  problem.move(stack.label(0, low_x),
               [](const Vector3d&) { return Vector3d(2e-3, 1e-3, -1e-3); });
  problem.load(stack.label(0, high_z), {0, 0, -5});
  return stack;
}

/// The unknowns of multigrid for a problem, which outlives them.
struct ProblemUnknowns {
  const SolidProblem& problem;
  ElasticSystem system = problem.system();
  SurfaceTrace trace = surface_trace(problem.surface, problem.law, system);
  SurfaceUnknowns unknowns =
      surface_unknowns(problem.surface, trace, problem.law.layer, system);
};

/// Is the vertex of a node one of another node, too?
inline std::vector<bool> shares_its_vertex(const ContactSurface& surface) {
  std::vector<bool> shares;
  for (const int v : surface.vertex)
    shares.push_back((surface.vertex.array() == v).count() > 1);
  return shares;
}

/// The same displacement, forces and states, where nodes of one vertex may share their force
/// in another way.
inline void expect_same_but_shares(const SolidProblem& problem,
                                   const ContactSolution<3>& one,
                                   const ContactSolution<3>& other) {
  ASSERT_TRUE(one.accepted({}));
  ASSERT_TRUE(other.accepted({}));
  EXPECT_LE(max_norm(one.displacement - other.displacement),
            1e-8 * max_norm(other.displacement));
  const auto load = [&](const ContactSolution<3>& found) {
    return on_free_dofs(
        problem.system(),
        nodal_load(problem.surface, found.force, problem.b.size()));
  };
  EXPECT_LE(max_norm(load(one) - load(other)), 1e-8 * max_norm(load(other)));
  const std::vector<bool> shares = shares_its_vertex(problem.surface);
  for (std::size_t i = 0; i < shares.size(); ++i)
    EXPECT_TRUE(shares[i] || one.state[i] == other.state[i]);
}
inline void expect_same_but_shares(const SolidProblem& problem) {
  const ContactSolution<3> one = problem.solve(by(LinearSolver::multigrid)),
                           other = problem.solve(by(LinearSolver::direct));
  EXPECT_EQ(one.multigrid, Multigrid::used);
  expect_same_but_shares(problem, one, other);
}

}  // namespace ffcontact::test
