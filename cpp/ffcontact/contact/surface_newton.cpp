// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/surface_newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ffcontact/base/norms.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/surface_law.hpp"

namespace ffcontact {

namespace {

/// Violations below this are rounding.
constexpr double least_violation = 1e-13;
/// Full steps that may fail to, before steps are shortened.
constexpr int most_full_steps = 5;
constexpr double smallest_step = 1e-3;
/// r of the proximal terms, where what the unknowns move is 1.
constexpr double proximal = 1e-8;
/// Steps that may fail to lower the violation, before the tolerance is met and after.
constexpr int most_failures = 30, most_failures_of_rounding = 2;

/// The next P and v of a node: what its state makes of them.
struct NodeState {
  bool open = false, slips = false;
  Vector2d e = Vector2d::Zero();  ///< direction of the force where it slips
  double share = 0;               ///< rho / |tau_t|
  double given = 0, ratio = 0;    ///< rho = given - ratio P_n
};

ContactState in_words(const NodeState& node) {
  if (node.open) return ContactState::open;
  return node.slips ? ContactState::slip_forward : ContactState::stick;
}

/// By the natural map at tau.
NodeState node_state(const FrictionCone& cone, const Vector3d& tau) {
  NodeState node;
  node.open = tau[0] >= 0;
  const double rho = cone.bound(tau[0]), length = tau.tail<2>().norm();
  node.slips = node.open || rho == 0 || length > rho;
  if (length > 0) node.e = tau.tail<2>() / length;
  if (length > 0) node.share = std::min(rho / length, 1.0);
  const bool at_limit = cone.at_limit(tau[0]);
  node.given = at_limit ? cone.limit : cone.cohesion;
  node.ratio = at_limit || node.open ? 0 : cone.friction;
  if (node.open && !cone.depends_on_contact()) node.slips = length > rho;
  return node;
}

NodeState node_state(const FrictionCone& cone, ContactState start) {
  NodeState node;
  node.open = is_open(start);
  node.slips = cone.frictionless() || node.open;
  return node;
}

/// sum P P_row + v v_row = value
struct Term {
  int row;
  double P, v;
};
struct Equation {
  std::vector<Term> terms;
  double value = 0;
};

/// Pi(tau): what the law makes of tau.
Vector3d projected(const FrictionCone& cone, const Vector3d& tau) {
  const double rho = cone.bound(tau[0]), length = tau.tail<2>().norm();
  const double share = length > rho ? rho / length : 1;
  return {std::min(tau[0], 0.0), share * tau[1], share * tau[2]};
}

/// The linear system of the next P and v: unknown are v of the primary rows without the
/// condition v = 0, and P of the dependent rows that are not held.
class NewtonStep {
 public:
  NewtonStep(const CondensedContact& contact, const std::vector<char>& held)
      : contact_(contact), held_(held) {
    const VectorXd diagonal = contact.S.diagonal().cwiseMax(1e-300);
    v_scale_ = diagonal.cwiseSqrt().cwiseInverse();
    const Index nodes = contact.position.size() / 3;
    stiffness_ = VectorXd::Constant(nodes, diagonal.mean());
    for (Index i = 0; i < nodes; ++i) put_stiffness(i, diagonal);
    for (int d = 0; d < count_of(contact.dependent); ++d)
      if (!held[contact.dependent[d]]) dependent_.push_back(d);
    for (int d : dependent_) q_scale_.push_back(q_scale(d));
  }

  Vector3d tau(const ContactRows& rows, int node) const {
    return rows.P.segment<3>(3 * node) -
           stiffness_[node] * rows.v.segment<3>(3 * node);
  }

  /// sum |P - Pi(tau)|^2 / c over the rows that are not held.
  double merit(const NodalLaw& law, const ContactRows& rows) const {
    double sum = 0;
    for (int i = 0; i < law.node_count(); ++i) {
      const Vector3d at = tau(rows, i);
      Vector3d missed = rows.P.segment<3>(3 * i) - projected(law.cone[i], at);
      for (int c = 0; c < 3; ++c)
        if (held_[3 * i + c]) missed[c] = 0;
      sum += missed.squaredNorm() / stiffness_[i];
    }
    return sum;
  }

  /// The next rows; unchanged if the system is not finite.
  SystemKind solve(const std::vector<NodeState>& states, ContactRows& rows) {
    put_unknowns(states);
    assemble(states);
    add_proximal_terms(rows.P);
    SystemKind kind;
    const Index n = count_of(unknown_);
    const VectorXd x = solved(std::move(matrix_), right_, n, kind);
    if (!x.allFinite()) return SystemKind::inconsistent;
    spread(x, states, rows);
    return kind;
  }

 private:
  void put_stiffness(Index node, const VectorXd& diagonal) {
    double sum = 0;
    int count = 0;
    for (int c = 0; c < 3; ++c)
      if (const int k = contact_.position[3 * node + c]; k >= 0) {
        sum += diagonal[k];
        ++count;
      }
    if (count > 0) stiffness_[node] = sum / count;
  }

  double q_scale(int d) const {
    const double reach =
        std::hypot(contact_.E.col(d).cwiseProduct(v_scale_).norm(),
                   std::sqrt(contact_.F(d, d)));
    return 1 / (reach > 0 ? reach : v_scale_.mean());
  }

  /// Is v = 0 the condition on a row?
  bool is_fixed(const std::vector<NodeState>& states, int row) const {
    const NodeState& node = states[row / 3];
    return row % 3 == 0 ? !node.open : !node.slips;
  }

  void put_unknowns(const std::vector<NodeState>& states) {
    unknown_.clear();
    for (int k = 0; k < count_of(contact_.primary); ++k)
      if (!is_fixed(states, contact_.primary[k])) unknown_.push_back(k);
  }

  /// The condition on a row that is not held.
  Equation equation(const std::vector<NodeState>& states, int row) const {
    const int node = row / 3, component = row % 3;
    if (is_fixed(states, row)) return {{{row, 0, 1}}, 0};
    if (component == 0) return {{{row, 1, 0}}, 0};
    const NodeState& state = states[node];
    Equation equation;
    equation.value = state.given * state.e[component - 1];
    const Matrix2Xd D = derivative(node, state);
    for (int c = 1; c < 3; ++c)
      if (const int other = 3 * node + c; !held_[other]) {
        const double d = D(component - 1, c - 1);
        equation.terms.push_back(
            {other, (c == component) - d, stiffness_[node] * d});
      }
    if (state.ratio != 0 && !held_[3 * node])
      equation.terms.push_back(
          {3 * node, state.ratio * state.e[component - 1], 0});
    return equation;
  }

  /// D on the tangential rows that are not held.
  Matrix2Xd derivative(int node, const NodeState& state) const {
    Matrix2Xd D = state.share *
                  (Eigen::Matrix2d::Identity() - state.e * state.e.transpose());
    for (int c = 0; c < 2; ++c)
      if (held_[3 * node + 1 + c]) {
        D.row(c).setZero();
        D.col(c).setZero();
      }
    return D;
  }

  void add_force(Index e, int row, double factor) {
    const Index n = count_of(unknown_), q = count_of(dependent_);
    const int k = contact_.position[row];
    if (k < 0) {
      for (Index d = 0; d < q; ++d)
        if (dependent_[d] == -1 - k) matrix_(e, n + d) += factor * q_scale_[d];
      return;
    }
    for (Index j = 0; j < n; ++j)
      matrix_(e, j) +=
          factor * contact_.S(unknown_[j], k) * v_scale_[unknown_[j]];
    for (Index d = 0; d < q; ++d)
      matrix_(e, n + d) -= factor * contact_.E(k, dependent_[d]) * q_scale_[d];
    right_[e] += factor * contact_.g[k];
  }

  void add_displacement(Index e, int row, double factor) {
    const Index n = count_of(unknown_), q = count_of(dependent_);
    const int k = contact_.position[row];
    if (k >= 0) {
      const auto place = std::lower_bound(unknown_.begin(), unknown_.end(), k);
      if (place != unknown_.end() && *place == k)
        matrix_(e, place - unknown_.begin()) += factor * v_scale_[k];
      return;
    }
    const int d = -1 - k;
    for (Index j = 0; j < n; ++j)
      matrix_(e, j) +=
          factor * contact_.E(unknown_[j], d) * v_scale_[unknown_[j]];
    for (Index j = 0; j < q; ++j)
      matrix_(e, n + j) += factor * contact_.F(d, dependent_[j]) * q_scale_[j];
    right_[e] -= factor * contact_.dependent_offset[d];
  }

  void put_equation(Index e, const std::vector<NodeState>& states, int row,
                    double v_scale, double P_scale) {
    const Equation condition = equation(states, row);
    const double scale = is_fixed(states, row) ? P_scale : v_scale;
    right_[e] = scale * condition.value;
    for (const Term& term : condition.terms) {
      if (term.P != 0) add_force(e, term.row, scale * term.P);
      if (term.v != 0) add_displacement(e, term.row, scale * term.v);
    }
  }

  void assemble(const std::vector<NodeState>& states) {
    const Index n = count_of(unknown_), q = count_of(dependent_);
    matrix_ = MatrixXd::Zero(n + q, n + q);
    right_ = VectorXd::Zero(n + q);
    for (Index e = 0; e < n; ++e)
      put_equation(e, states, contact_.primary[unknown_[e]],
                   v_scale_[unknown_[e]], 0);
    for (Index d = 0; d < q; ++d) {
      const int row = contact_.dependent[dependent_[d]];
      put_equation(n + d, states, row, 1 / q_scale_[d], q_scale_[d]);
    }
  }

  /// + r (P - last P) in the equation of a dependent row.
  void add_proximal_terms(const VectorXd& last) {
    const Index n = count_of(unknown_);
    for (Index d = 0; d < count_of(dependent_); ++d) {
      const int row = contact_.dependent[dependent_[d]];
      matrix_(n + d, n + d) += proximal;
      right_[n + d] += proximal * last[row] / q_scale_[d];
    }
  }

  void spread(const VectorXd& x, const std::vector<NodeState>& states,
              ContactRows& rows) const {
    VectorXd v = VectorXd::Zero(contact_.S.rows()),
             q = VectorXd::Zero(contact_.E.cols());
    for (std::size_t j = 0; j < unknown_.size(); ++j)
      v[unknown_[j]] = v_scale_[unknown_[j]] * x[j];
    for (std::size_t d = 0; d < dependent_.size(); ++d)
      q[dependent_[d]] = q_scale_[d] * x[unknown_.size() + d];
    const VectorXd P = contact_.S * v - contact_.g - contact_.E * q,
                   v_dependent = contact_.E.transpose() * v + contact_.F * q +
                                 contact_.dependent_offset;
    for (int row = 0; row < contact_.position.size(); ++row) {
      const int k = contact_.position[row];
      rows.P[row] = k >= 0 ? P[k] : q[-1 - k];
      rows.v[row] = k >= 0 ? v[k] : v_dependent[-1 - k];
      if (held_[row]) rows.v[row] = 0;
      if (row % 3 == 0 && states[row / 3].open) rows.P[row] = 0;
    }
  }

  const CondensedContact& contact_;
  const std::vector<char>& held_;
  VectorXd stiffness_;  ///< c of each node [p]
  VectorXd v_scale_, right_;
  std::vector<int> unknown_, dependent_;
  std::vector<double> q_scale_;
  MatrixXd matrix_;
};

/// Exactly in the law where it is missed by rounding.
void put_into_law(const NodalLaw& law, const std::vector<char>& held,
                  ActiveSetResult& result) {
  for (int i = 0; i < law.node_count(); ++i) {
    auto P = result.P.segment<3>(3 * i);
    P[0] = std::min(P[0], 0.0);
    const double bound = law.cone[i].bound(P[0]), length = P.tail<2>().norm();
    const bool slips = result.state[i] == ContactState::slip_forward;
    if (length > bound || (slips && length > 0)) P.tail<2>() *= bound / length;
    for (int c = 0; c < 3; ++c)
      if (held[3 * i + c]) P[c] = 0;
  }
}

class Newton {
 public:
  Newton(const CondensedContact& contact, const NodalLaw& law,
         const std::vector<char>& held, const NewtonSettings& settings)
      : contact_(contact),
        law_(law),
        held_(held),
        settings_(settings),
        step_(contact, held),
        states_(law.node_count()) {
    rows_.P = rows_.v = VectorXd::Zero(contact.position.size());
    result_.violation = infinity;
  }

  ActiveSetResult result(const std::vector<ContactState>& start) && {
    for (std::size_t i = 0; i < states_.size(); ++i)
      states_[i] = node_state(law_.cone[i], start[i]);
    while (!ends()) {
    }
    if (result_.violation <= settings_.tolerance)
      result_.status = ContactStatus::converged;
    if (result_.status == ContactStatus::converged)
      put_into_law(law_, held_, result_);
    return std::move(result_);
  }

 private:
  bool ends() {
    if (result_.iterations >= settings_.max_iterations) return true;
    ++result_.iterations;
    const ContactRows last = rows_;
    const SystemKind kind = step_.solve(states_, rows_);
    const bool loose = kind == SystemKind::inconsistent;
    if (failures_ > most_full_steps) shorten_step(last);
    const double violation =
        loose ? infinity : surface_violation(contact_, law_, held_, rows_);
    const bool better = violation < result_.violation;
    if (better || result_.iterations == 1) keep(violation);
    failures_ = better ? 0 : failures_ + 1;
    if (violation <= least_violation) return true;
    result_.status = loose ? ContactStatus::singular : ContactStatus::cycled;
    for (std::size_t i = 0; i < states_.size(); ++i)
      states_[i] =
          node_state(law_.cone[i], step_.tau(rows_, static_cast<int>(i)));
    return failures_ > (result_.violation <= settings_.tolerance
                            ? most_failures_of_rounding
                            : most_failures);
  }

  /// Back towards the rows before, as far as the merit asks for.
  void shorten_step(const ContactRows& last) {
    const double before = step_.merit(law_, last);
    ContactRows best = rows_;
    double least = infinity;
    for (double t = 1; t > smallest_step; t /= 2) {
      const ContactRows trial{last.P + t * (rows_.P - last.P),
                              last.v + t * (rows_.v - last.v)};
      const double merit = step_.merit(law_, trial);
      if (merit < least) {
        least = merit;
        best = trial;
      }
      if (merit < (1 - t / 4) * before) break;
    }
    rows_ = best;
  }

  void keep(double violation) {
    std::vector<ContactState> states;
    for (std::size_t i = 0; i < states_.size(); ++i)
      states.push_back(in_words(
          node_state(law_.cone[i], step_.tau(rows_, static_cast<int>(i)))));
    result_.keep(std::move(states), rows_, violation);
  }

  const CondensedContact& contact_;
  const NodalLaw& law_;
  const std::vector<char>& held_;
  const NewtonSettings settings_;
  NewtonStep step_;
  std::vector<NodeState> states_;
  ContactRows rows_;
  ActiveSetResult result_;
  int failures_ = 0;
};

}  // namespace

double surface_violation(const CondensedContact& contact, const NodalLaw& law,
                         const std::vector<char>& held,
                         const ContactRows& rows) {
  VectorXd v = rows.v;
  for (Index row = 0; row < v.size(); ++row)
    if (held[row]) v[row] = 0;
  return surface_violation(law, rows.P, v, law_scales(contact, v));
}

ActiveSetResult surface_newton(const CondensedContact& contact,
                               const NodalLaw& law,
                               const std::vector<char>& held,
                               const std::vector<ContactState>& state,
                               const NewtonSettings& settings) {
  return Newton(contact, law, held, settings).result(state);
}

}  // namespace ffcontact
