// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/coulomb_constant.hpp"

#include <cmath>
#include <optional>

#include "ffcontact/base/cholesky.hpp"
#include "ffcontact/base/krylov.hpp"
#include "ffcontact/base/norms.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/trace_stiffness.hpp"

namespace ffcontact {

namespace {

/// Added to S, relative to its diagonal.
constexpr double stabilisation = 1e-10;
/// What a motion without energy makes of kappa^2 is more than this.
constexpr double largest_square = 1e8;

/// The unknowns of kappa: all normal rows, then the tangential ones of phi.
struct Unknowns {
  std::vector<int> rows;  ///< places in the trace stiffness
  std::vector<int>
      normal;       ///< of each phi: place in `rows` of its node's normal
  VectorXd weight;  ///< m of each phi
  Index normal_count = 0;
};

/// Nothing where a node may slip that v cannot follow.
std::optional<Unknowns> unknowns(const CondensedContact& contact,
                                 const TraceStiffness& traces,
                                 const VectorXd& weight,
                                 const std::vector<char>& is_left_out) {
  Unknowns result;
  std::vector<int> place(weight.size(), -1);
  for (int node = 0; node < weight.size(); ++node)
    if (traces.place[2 * node] >= 0) {
      place[node] = count_of(result.rows);
      result.rows.push_back(traces.place[2 * node]);
    }
  result.normal_count = count_of(result.rows);
  std::vector<double> m;
  for (int node = 0; node < weight.size(); ++node) {
    const int normal = traces.place[2 * node],
              tangential = traces.place[2 * node + 1];
    if (contact.held.row[2 * node + 1] || is_left_out[node]) continue;
    const bool is_free = normal >= 0 && tangential >= 0;
    if (weight[node] != 0 && (!is_free || traces.is_followed[normal]))
      return std::nullopt;
    if (!is_free) continue;
    result.rows.push_back(tangential);
    result.normal.push_back(place[node]);
    m.push_back(weight[node]);
  }
  result.weight = packed(m);
  return result;
}

Cholesky factor_of(const MatrixXd& S, const std::vector<int>& rows) {
  MatrixXd own = S(rows, rows);
  own.diagonal() *= 1 + stabilisation;
  return Cholesky(own);
}

}  // namespace

double coulomb_constant(const CondensedContact& contact,
                        const SlipPattern& pattern, double largest_friction,
                        StuckNodes stuck) {
  if (pattern.reaches_limit && stuck == StuckNodes::may_slip) return infinity;
  const VectorXd weight = pattern.weight(largest_friction);
  if (weight.isZero(0)) return 0;
  const std::vector<char> none(pattern.sticks.size(), 0);
  const TraceStiffness traces = trace_stiffness(contact);
  const std::optional<Unknowns> found =
      unknowns(contact, traces, weight,
               stuck == StuckNodes::stick ? pattern.sticks : none);
  if (!found) return infinity;
  const Unknowns& phi = *found;
  const Index n = phi.normal_count, t = phi.weight.size();
  const Cholesky factor = factor_of(traces.S, phi.rows);
  if (!factor.is_positive_definite()) return infinity;
  const auto L_nn =
      factor.lower().topLeftCorner(n, n).triangularView<Eigen::Lower>();
  const auto L_tt =
      factor.lower().bottomRightCorner(t, t).triangularView<Eigen::Lower>();
  const auto square = [&](const VectorXd& x) {
    const VectorXd y =
        phi.weight.cwiseProduct(VectorXd(L_tt.transpose().solve(x)));
    VectorXd v_n = VectorXd::Zero(n);
    v_n(phi.normal) = y;
    const VectorXd forces = L_nn * VectorXd(L_nn.transpose() * v_n);
    return VectorXd(
        L_tt.solve(VectorXd(phi.weight.cwiseProduct(forces(phi.normal)))));
  };
  const double largest = largest_eigenvalue(square, t);
  return largest < largest_square ? std::sqrt(largest) : infinity;
}

double coulomb_bound(double e, double largest_friction, double kappa) {
  if (largest_friction == 0 || kappa == 0) return e;
  const double rest = 1 - largest_friction * kappa;
  return rest > 0 ? e / std::sqrt(rest) : infinity;
}

}  // namespace ffcontact
