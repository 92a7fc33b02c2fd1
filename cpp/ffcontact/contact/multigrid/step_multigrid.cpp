// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/multigrid/step_multigrid.hpp"

#include <algorithm>
#include <map>
#include <utility>

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

/// T of the contact vertices and the unknowns of the rows.
void put_frames(const ContactSurface& surface, const SurfaceTrace& trace,
                SurfaceUnknowns& unknowns) {
  const ContactTrace& moved = trace.trace;
  std::vector<Matrix3d> T(surface.node_count(), Matrix3d::Zero());
  for (int k = 0; k < count_of(trace.primary); ++k) {
    const int row = trace.primary[k], node = row / 3;
    unknowns.of_row[row] = 3 * surface.vertex[node] + row % 3;
    for (SparseMatrix::InnerIterator e(moved.to_kept, k); e; ++e)
      T[node](moved.kept_dofs[e.row()] % 3, row % 3) = e.value();
  }
  for (int i = 0; i < surface.node_count(); ++i)
    if (!T[i].isZero(0)) unknowns.frames.put(surface.vertex[i], T[i]);
}

/// By w = v - v_prescribed - A_o w_o.
void put_followed(const ContactSurface& surface, const SurfaceTrace& trace,
                  VertexFrames<3>& frames) {
  const ContactTrace& moved = trace.trace;
  std::map<std::pair<int, int>, Matrix3d> B;
  for (Index k = count_of(trace.primary); k < moved.A.cols(); ++k)
    for (SparseMatrix::InnerIterator w(moved.to_kept, k); w; ++w) {
      const int dof = moved.kept_dofs[w.row()];
      for (SparseMatrix::InnerIterator e(moved.A, k); e; ++e) {
        const int row = static_cast<int>(e.row());
        const std::pair link(surface.vertex[row / 3], dof / 3);
        const auto known = B.try_emplace(link, Matrix3d::Zero()).first;
        known->second(row % 3, dof % 3) -= e.value() * w.value();
      }
    }
  for (const auto& [link, block] : B)
    if (!block.isZero(0)) frames.follow(link.first, link.second, block);
}

}  // namespace

bool has_own_unknowns(const SurfaceTrace& trace) {
  const auto free = std::count(trace.held.begin(), trace.held.end(), 0);
  const int own = count_of(trace.primary);
  return own == free && trace.trace.A.leftCols(own).nonZeros() == own;
}

SurfaceUnknowns surface_unknowns(const ContactSurface& surface,
                                 const SurfaceTrace& trace,
                                 const CompliantLayer& layer,
                                 const ElasticSystem& system) {
  SurfaceUnknowns unknowns{
      VertexFrames<3>(system), VectorXi::Constant(3 * surface.node_count(), -1),
      nodal_compliance(layer, surface.area, 3, trace.held)};
  put_frames(surface, trace, unknowns);
  put_followed(surface, trace, unknowns.frames);
  return unknowns;
}

StepMultigrid::StepMultigrid(const ElasticSystem& system,
                             const Matrix3Xd& vertices,
                             const SurfaceUnknowns& unknowns)
    : unknowns_(unknowns),
      vertex_(unknowns.of_row.size() / 3, -1),
      diagonal_(vertex_.size(), SingleBlock<3, 3>::Zero()),
      known_(vertex_.size()),
      multigrid_(body_grid<3>(system, vertices, unknowns.frames)) {
  for (int row = 0; row < unknowns.of_row.size(); ++row)
    if (unknowns.of_row[row] >= 0) vertex_[row / 3] = unknowns.of_row[row] / 3;
  for (int i = 0; i < node_count(); ++i)
    if (vertex_[i] >= 0)
      diagonal_[i] = multigrid_.matrix().block(vertex_[i], vertex_[i]);
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

SmoothedAggregation<3>::Change StepMultigrid::change_of(
    int node, const Node& state) const {
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
  const double size = std::max(known.slip.norm(), now.slip.norm());
  return now.moves != known.moves || now.layer != known.layer ||
         (now.slip - known.slip).norm() > std::max(stale * size, weak * c);
}

void StepMultigrid::follow(const SurfaceEquations& equations) {
  std::vector<SmoothedAggregation<3>::Change> changes;
  for (int i = 0; i < node_count(); ++i) {
    if (vertex_[i] < 0) continue;
    const Node now = node_of(equations, i);
    if (!is_stale(i, now, equations.stiffness(i))) continue;
    known_[i] = now;
    changes.push_back(change_of(i, now));
  }
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

VectorXf StepMultigrid::product(const SurfaceEquations& equations,
                                const VectorXf& y) const {
  const BlockRows<3, 3>& A = multigrid_.matrix();
  VectorXf result = ffcontact::product(A, y);
#pragma omp parallel for
  for (int i = 0; i < node_count(); ++i) {
    const int v = vertex_[i];
    if (v < 0) continue;
    // K has another block on the diagonal than multigrid
    const SingleBlock<3, 1> at = block_of<3>(y, v),
                            K_y = block_of<3>(result, v) +
                                  (diagonal_[i] - A.block(v, v)) * at;
    block_of<3>(result, v) = rows_of(i, equations, K_y, at);
  }
  return result;
}

std::optional<VectorXd> StepMultigrid::change(const SurfaceEquations& equations,
                                              const VectorXd& missed,
                                              double residual) {
  follow(equations);
  const double size = missed.norm();
  if (!(size > 0)) return VectorXd::Zero(missed.size());
  const GmresResult found = gmres(
      [&](const VectorXf& y) { return product(equations, y); }, multigrid_,
      (-missed / size).cast<float>(), {residual, most_products});
  if (!(found.residual < useless_residual) || !found.x.allFinite()) return {};
  return size * found.x.cast<double>();
}

}  // namespace ffcontact
