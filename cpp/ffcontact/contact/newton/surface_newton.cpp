// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/newton/surface_newton.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Full steps that may fail to, before steps are shortened.
constexpr int most_full_steps = 5;
constexpr double smallest_step = 1e-3;
/// Steps that may fail to lower the violation, before the tolerance is met and after.
constexpr int patience = 30, patience_with_rounding = 1;

/// Exactly in the law where it is missed by rounding.
void put_into_law(const NodalLaw& law, const Flags& held,
                  ActiveSetResult& result) {
  for (int i = 0; i < law.node_count(); ++i) {
    auto P = result.P.segment<3>(3 * i);
    if (!law.cone[i].bonded) P[0] = std::min(P[0], 0.0);
    const double bound = law.cone[i].bound(P[0]), length = P.tail<2>().norm();
    const bool slips = result.state[i] == ContactState::slip_forward;
    if (length > bound || (slips && length > 0)) P.tail<2>() *= bound / length;
    for (int c = 0; c < 3; ++c)
      if (held[3 * i + c]) P[c] = 0;
  }
}

class Newton {
 public:
  Newton(NewtonRelation& relation, const NodalLaw& law, const Flags& held,
         const NewtonSettings& settings)
      : relation_(relation),
        law_(law),
        held_(held),
        settings_(settings),
        map_(relation.natural_map(held)),
        states_(law.node_count()) {
    rows_.P = rows_.v = VectorXd::Zero(relation.row_count());
    result_.violation = infinity;
  }

  ActiveSetResult result(const ContactStates& start) && {
    for (std::size_t i = 0; i < states_.size(); ++i)
      states_[i] = node_state(law_.cone[i], start[i]);
    return run();
  }

  ActiveSetResult result(const ContactRows& near) && {
    rows_ = near;
    states_ = map_.states(law_, rows_);
    return run();
  }

 private:
  ActiveSetResult run() {
    while (!ends()) {
    }
    if (result_.violation <= settings_.tolerance)
      result_.status = ContactStatus::converged;
    if (result_.status == ContactStatus::converged)
      put_into_law(law_, held_, result_);
    return std::move(result_);
  }

  bool ends() {
    if (result_.iterations >= settings_.max_iterations) return true;
    ++result_.iterations;
    const ContactRows last = rows_;
    const SystemKind kind =
        relation_.step(SurfaceEquations(held_, map_, states_), rows_);
    const bool loose = kind == SystemKind::inconsistent;
    if (failures_ > most_full_steps) shorten_step(last);
    const double violation =
        loose ? infinity : surface_violation(relation_, law_, held_, rows_);
    tell(settings_.report,
         {"Newton", result_.iterations, "violation", violation});
    const bool better = violation < result_.violation,
               gains = violation < wanted_violation();
    if (better || result_.iterations == 1) keep(violation);
    failures_ = gains ? 0 : failures_ + 1;
    if (violation <= settings_.enough) return true;
    states_ = map_.states(law_, rows_);
    const bool cycles = failures_ > (result_.violation <= settings_.tolerance
                                         ? patience_with_rounding
                                         : patience);
    result_.status = loose    ? ContactStatus::singular
                     : cycles ? ContactStatus::cycled
                              : ContactStatus::not_converged;
    return cycles;
  }

  /// Once the tolerance is met, steps that gain less than a factor of 10 are rounding.
  double wanted_violation() const {
    const bool met = result_.violation <= settings_.tolerance;
    return met ? result_.violation / 10 : result_.violation;
  }

  /// Back towards the rows before, as far as the merit asks for.
  void shorten_step(const ContactRows& last) {
    const double before = map_.merit(law_, last);
    ContactRows best = rows_;
    double least = infinity;
    for (double t = 1; t > smallest_step; t /= 2) {
      const ContactRows trial{last.P + t * (rows_.P - last.P),
                              last.v + t * (rows_.v - last.v)};
      const double merit = map_.merit(law_, trial);
      if (merit < least) {
        least = merit;
        best = trial;
      }
      if (merit < (1 - t / 4) * before) break;
    }
    rows_ = best;
  }

  void keep(double violation) {
    result_.keep(contact_states(map_.states(law_, rows_)), rows_, violation);
  }

  NewtonRelation& relation_;
  const NodalLaw& law_;
  const Flags& held_;
  const NewtonSettings settings_;
  const NaturalMap map_;
  std::vector<NodeState> states_;
  ContactRows rows_;
  ActiveSetResult result_;
  int failures_ = 0;
};

}  // namespace

double surface_violation(const NewtonRelation& relation, const NodalLaw& law,
                         const Flags& held, const ContactRows& rows) {
  const Index nodal = 3 * law.node_count();
  const VectorXd v = without<VectorXd>(held, rows.v.head(nodal));
  const LawScales scales = relation.scales(v);
  const auto beyond = rows.P.tail(rows.P.size() - nodal);
  const double missed = max_norm(beyond),
               size = std::max(
                   {scales.P, relation.largest_load(), max_norm(rows.P)});
  return std::max(law_violation(law, rows.P.head(nodal), v, scales),
                  relative(missed, size));
}

double surface_violation(const CondensedContact& contact, const NodalLaw& law,
                         const Flags& held, const ContactRows& rows) {
  StepSolver none;
  return surface_violation(CondensedRelation(contact, none), law, held, rows);
}

ActiveSetResult surface_newton(NewtonRelation& relation, const NodalLaw& law,
                               const Flags& held, const ContactStates& state,
                               const NewtonSettings& settings) {
  return Newton(relation, law, held, settings).result(state);
}

ActiveSetResult surface_newton(NewtonRelation& relation, const NodalLaw& law,
                               const Flags& held, const ContactRows& near,
                               const NewtonSettings& settings) {
  return Newton(relation, law, held, settings).result(near);
}

ActiveSetResult surface_newton(const CondensedContact& contact,
                               const NodalLaw& law, const Flags& held,
                               const ContactStates& state, StepSolver& solver,
                               const NewtonSettings& settings) {
  CondensedRelation relation(contact, solver);
  return surface_newton(relation, law, held, state, settings);
}

ActiveSetResult surface_newton(const CondensedContact& contact,
                               const NodalLaw& law, const Flags& held,
                               const ContactStates& state,
                               const NewtonSettings& settings) {
  StepSolver solver;
  return surface_newton(contact, law, held, state, solver, settings);
}

ActiveSetResult surface_newton(const CondensedContact& contact,
                               const NodalLaw& law, const Flags& held,
                               const ContactRows& near, StepSolver& solver,
                               const NewtonSettings& settings) {
  CondensedRelation relation(contact, solver);
  return surface_newton(relation, law, held, near, settings);
}

}  // namespace ffcontact
