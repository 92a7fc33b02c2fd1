// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/multigrid/step_multigrid.hpp"

#include <algorithm>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/linear/iterative/gmres.hpp"

namespace ffcontact {

namespace {

/// w is at most this much of c, and s of K: a node that hardly slips nearly sticks.
constexpr double stiffest = 1e4;
/// Of w, by which it may differ from what multigrid knows of it.
constexpr double stale = 0.5;
/// Beside c, w is nothing.
constexpr double weak = 1e-2;
constexpr int most_products = 150;
/// Residual of GMRES that is of no use.
constexpr double useless_residual = 0.5;

/// Is this much of what multigrid knows, or of c, another one?
bool differs(const MatrixXd& known, const MatrixXd& now, double c) {
  const double size = std::max(known.norm(), now.norm());
  return (now - known).norm() > std::max(stale * size, weak * c);
}

}  // namespace

StepMultigrid::StepMultigrid(const ElasticSystem& system,
                             const Matrix3Xd& vertices,
                             const SurfaceUnknowns& unknowns)
    : unknowns_(unknowns),
      vertex_(unknowns.of_row.size() / 3, -1),
      diagonal_(vertex_.size(), SingleBlock<3, 3>::Zero()),
      known_(vertex_.size()),
      known_shared_(unknowns.shared.size()),
      multigrid_(body_grid<3>(system, vertices, unknowns.frames)) {
  for (int row = 0; row < unknowns.of_row.size(); ++row)
    if (unknowns.of_row[row] >= 0) vertex_[row / 3] = unknowns.of_row[row] / 3;
  for (int i = 0; i < node_count(); ++i)
    if (vertex_[i] >= 0)
      diagonal_[i] = multigrid_.matrix().block(vertex_[i], vertex_[i]);
  for (const SharedVertex& shared : unknowns.shared)
    shared_diagonal_.push_back(
        multigrid_.matrix().block(shared.vertex, shared.vertex));
  diagonal_of_all_.resize(system.dof_count());
  for (int v = 0; v < multigrid_.matrix().rows(); ++v)
    block_of<3>(diagonal_of_all_, v) =
        multigrid_.matrix().block(v, v).diagonal();
}

double StepMultigrid::stiffness(int row) const {
  return diagonal_[row / 3](row % 3, row % 3);
}

double StepMultigrid::spring(int row) const {
  return std::min(1 / unknowns_.compliance[row], stiffest * stiffness(row));
}

Matrix2d StepMultigrid::slip_stiffness(const SurfaceEquations& equations,
                                       int node) const {
  const NodeState& state = equations.state(node);
  if (!state.slips || state.share == 0) return Matrix2d::Zero();
  const double c = equations.stiffness(node);
  const double w =
      std::min(state.share / std::max(1 - state.share, 1e-300), stiffest) * c;
  const double gamma = unknowns_.compliance.segment<2>(3 * node + 1).maxCoeff();
  return w / (1 + gamma * w) *
         (Matrix2d::Identity() - state.e * state.e.transpose());
}

SingleBlock<3, 3> StepMultigrid::Node::springs() const {
  Matrix3d sum = layer.asDiagonal();
  sum.bottomRightCorner<2, 2>() += slip;
  return sum.cast<float>();
}

StepMultigrid::Change StepMultigrid::change_of(int node,
                                               const Node& state) const {
  const int v = vertex_[node];
  SingleBlock<3, 3> block = diagonal_[node] + state.springs();
  auto motions = motions_along<3>(unknowns_.frames.of(v));
  for (int c = 0; c < 3; ++c) {
    if (state.layer[c] > 0)  // bodies hardly move what a stiff layer holds
      motions.row(c) *= diagonal_[node](c, c) / block(c, c);
    if (state.moves[c]) continue;
    block.row(c).setZero();
    block.col(c).setZero();
    motions.row(c).setZero();
  }
  return {v, block, motions};
}

StepMultigrid::Node StepMultigrid::node_of(const SurfaceEquations& equations,
                                           int node) const {
  Node state;
  for (int c = 0; c < 3; ++c)
    if (const int row = 3 * node + c; is_sprung(equations, row))
      state.layer[c] = spring(row);
    else
      state.moves[c] = unknowns_.of_row[row] >= 0 && !equations.is_fixed(row);
  state.slip = slip_stiffness(equations, node);
  return state;
}

bool StepMultigrid::is_stale(int node, const Node& now, double c) const {
  const Node& known = known_[node];
  return now.moves != known.moves || now.layer != known.layer ||
         differs(known.slip, now.slip, c);
}

void StepMultigrid::follow_nodes(const SurfaceEquations& equations,
                                 std::vector<Change>& changes) {
  for (int i = 0; i < node_count(); ++i) {
    if (vertex_[i] < 0) continue;
    const Node now = node_of(equations, i);
    if (!is_stale(i, now, equations.stiffness(i))) continue;
    known_[i] = now;
    changes.push_back(change_of(i, now));
  }
}

bool StepMultigrid::Shared::is_stale(const Shared& now, double c) const {
  return now.moves != moves || differs(springs, now.springs, c);
}

void StepMultigrid::follow_shared(const SharedRows& shared,
                                  std::vector<Change>& changes) {
  for (int i = 0; i < shared.count(); ++i) {
    const Shared now{shared.moves(i), shared.springs(i)};
    const Matrix3d K = shared_diagonal(i);
    if (!known_shared_[i].is_stale(now, K.maxCoeff())) continue;
    known_shared_[i] = now;
    changes.push_back(change_of(shared.vertex(i), K, now));
  }
}

StepMultigrid::Change StepMultigrid::change_of(const SharedVertex& shared,
                                               const Matrix3d& K,
                                               const Shared& state) const {
  const auto moves = state.moves.asDiagonal();
  const Matrix3d block = moves * K * moves + state.springs;
  const SingleBlock<3, 1> mask = state.moves.cast<float>();
  return {shared.vertex, block.cast<float>(),
          mask.asDiagonal() * motions_along<3>(shared.T)};
}

void StepMultigrid::follow(const SurfaceEquations& equations,
                           const SharedRows& shared) {
  std::vector<Change> changes;
  follow_nodes(equations, changes);
  follow_shared(shared, changes);
  multigrid_.put(changes);
}

SingleBlock<3, 1> StepMultigrid::rows_of(int node,
                                         const SurfaceEquations& equations,
                                         const SingleBlock<3, 1>& K_y,
                                         const SingleBlock<3, 1>& y) const {
  SingleBlock<3, 1> rows = K_y + node_of(equations, node).springs() * y;
  const NodeState& state = equations.state(node);
  if (state.slips)
    rows.tail<2>() +=
        static_cast<float>(state.ratio) * K_y[0] * state.e.cast<float>();
  for (int c = 0; c < 3; ++c)
    if (!known_[node].moves[c]) rows[c] = 0;
  return rows;
}

SingleBlock<3, 1> StepMultigrid::at(int vertex, const SingleBlock<3, 3>& D,
                                    const VectorXf& y,
                                    const VectorXf& product) const {
  const SingleBlock<3, 3> other = D - multigrid_.matrix().block(vertex, vertex);
  return block_of<3>(product, vertex) + other * block_of<3>(y, vertex);
}

VectorXf StepMultigrid::of_nodes(const SurfaceEquations& equations,
                                 const VectorXf& y) const {
  VectorXf result = ffcontact::product(multigrid_.matrix(), y);
#pragma omp parallel for
  for (int i = 0; i < node_count(); ++i)
    if (const int v = vertex_[i]; v >= 0)
      block_of<3>(result, v) = rows_of(
          i, equations, at(v, diagonal_[i], y, result), block_of<3>(y, v));
  return result;
}

VectorXf StepMultigrid::product(const SurfaceEquations& equations,
                                const SharedRows& shared,
                                const VectorXf& x) const {
  const Index dofs = diagonal_of_all_.size(), beyond = x.size() - dofs;
  const VectorXf y = x.head(dofs);
  VectorXf forces = of_nodes(equations, y), result(x.size());
  for (int i = 0; i < shared.count(); ++i) {
    const int v = shared.vertex(i).vertex;
    block_of<3>(forces, v) = at(v, shared_diagonal_[i], y, forces);
  }
  result.tail(beyond) = shared.change(y, x.tail(beyond), forces);
  result.head(dofs) = forces;
  return result;
}

VectorXf StepMultigrid::preconditioned(const SharedRows& shared,
                                       const VectorXf& right) const {
  VectorXf x = right, forces = right.head(diagonal_of_all_.size());
  shared.add_forces(right.tail(right.size() - forces.size()), forces);
  x.head(forces.size()) = multigrid_(forces);
  return x;
}

std::optional<VectorXd> StepMultigrid::change(const SurfaceEquations& equations,
                                              const SharedRows& shared,
                                              const VectorXd& missed,
                                              double residual) {
  follow(equations, shared);
  const double size = missed.norm();
  if (!(size > 0)) return VectorXd::Zero(missed.size());
  const GmresResult found =
      gmres([&](const VectorXf& y) { return product(equations, shared, y); },
            [&](const VectorXf& r) { return preconditioned(shared, r); },
            (-missed / size).cast<float>(), {residual, most_products});
  products_ += found.steps;
  if (!(found.residual < useless_residual) || !found.x.allFinite()) return {};
  return size * found.x.cast<double>();
}

}  // namespace ffcontact
