// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/contact_solution.hpp"

#include <algorithm>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/norms.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/balance.hpp"
#include "ffcontact/contact/condensed_answer.hpp"
#include "ffcontact/contact/feasibility.hpp"
#include "ffcontact/contact/line_balance.hpp"
#include "ffcontact/contact/nodal_pressures.hpp"
#include "ffcontact/contact/refinement.hpp"
#include "ffcontact/contact/unheld_bodies.hpp"
#include "ffcontact/interface/nodal_force.hpp"

namespace ffcontact {

namespace {

/// Residuals below this are rounding.
constexpr double residual_rounding = 1e-12;

/// An answer and how well the body is in equilibrium.
struct Judged {
  BodyAnswer answer;
  ResidualDefect residual;
};

/// Multipliers that the residual does not notice are none with Coulomb's law: their
/// friction would know no slip.
Judged judged_without_rounding(const ContactLine& line, const ContactLaw& law,
                               const ElasticSystem& system,
                               const HeldRows& held, BodyAnswer answer) {
  const ResidualDefect residual =
      residual_defect(line, law, system, held, answer);
  Judged judged{std::move(answer), residual};
  if (law.tresca()) return judged;
  BodyAnswer none{judged.answer.displacement,
                  VectorXd::Zero(judged.answer.P.size())};
  const ResidualDefect without = residual_defect(line, law, system, held, none);
  if (without.largest() > std::max(residual_rounding, residual.largest()))
    return judged;
  return {std::move(none), without};
}

/// Multipliers in tension by rounding are cut to none by the law: the forces that these
/// nodes miss then are small, but not beside those of a soft body. They are open, unless
/// no node has multipliers at all.
ContactStates open_where_cut(ContactStates state, const VectorXd& P) {
  if (P.isZero(0)) return state;
  for (Index i = 0; i < count_of(state); ++i)
    if (P.segment<2>(2 * i).isZero(0)) state[i] = ContactState::open;
  return state;
}

/// Refined until rounding is all that is left of the residual.
Judged refined_answer(const ContactLine& line, const ContactLaw& law,
                      const ElasticSystem& system,
                      const CondensedStiffness& stiffness,
                      const CondensedContact& contact,
                      const ContactStates& state, BodyAnswer answer) {
  constexpr int most_steps = 3;
  const NodalLaw nodal = nodal_law(law, line);
  Judged best = judged_without_rounding(line, law, system, contact.held,
                                        std::move(answer));
  for (int k = 0; k < most_steps; ++k) {
    const ContactStates states = open_where_cut(state, best.answer.P);
    if (best.residual.largest() <= residual_rounding && states == state) break;
    BodyAnswer next =
        refined(line, law, system, stiffness, contact, states, best.answer);
    put_into_law(nodal, states, next.P);
    Judged judged = judged_without_rounding(line, law, system, contact.held,
                                            std::move(next));
    if (!(judged.residual.largest() < 0.5 * best.residual.largest())) break;
    best = std::move(judged);
  }
  return best;
}

/// The whole body of a condensed answer.
Judged body_answer(const ContactLine& line, const ContactLaw& law,
                   const ElasticSystem& system,
                   const CondensedStiffness& stiffness,
                   const CondensedContact& contact,
                   const ActiveSetResult& condensed) {
  const VectorXd kept = kept_displacement(contact, condensed.v(contact.primary),
                                          condensed.P(contact.dependent));
  BodyAnswer answer{
      stiffness.extended(contact.load, kept) + system.prescribed_value,
      condensed.P};
  if (condensed.status == ContactStatus::converged)
    return refined_answer(line, law, system, stiffness, contact,
                          condensed.state, std::move(answer));
  const ResidualDefect residual =
      residual_defect(line, law, system, contact.held, answer);
  return {std::move(answer), residual};
}

/// A state as answers have it.
ContactState answered(ContactState state) {
  if (is_open(state)) return ContactState::open;
  if (!is_limited(state)) return state;
  return slip_sign(state) > 0 ? ContactState::slip_forward
                              : ContactState::slip_backward;
}

/// The pressures and forces of the multipliers that were solved for.
void put_multipliers(const ContactLine& line, const ContactLaw& law,
                     const Flags& prescribed, const Matrix2Xd& P,
                     ContactSolution& solution) {
  if (law.multiplier == Multiplier::pressure) {
    solution.pressure = P;
    solution.force = nodal_forces_of(line, law, P.reshaped());
  } else {
    solution.force = P;
    solution.pressure = consistent_pressures(line, prescribed, P);
  }
}

void require_sound(const Mesh& mesh, const ContactLine& line,
                   const ContactLaw& law, const ElasticSystem& system,
                   const ContactSettings& settings) {
  require_valid(law, line);
  require_size("A", system.dof_count(), 2 * mesh.vertices.cols());
  require_valid(settings, line.node_count());
  require_feasible(mesh, line, law, system);
  require_balance(mesh, line, law, system);
}

/// Is nothing loaded or moved, with a gap somewhere?
bool is_at_rest(const ContactLaw& law, const ElasticSystem& system) {
  return system.load.isZero(0) && system.prescribed_value.isZero(0) &&
         law.gap.size() > 0 && law.gap.minCoeff() >= 0 &&
         max_norm(law.gap) > 0 && law.previous.isZero(0);
}

/// A body at rest stays: nothing moves and no node touches. Newton would look for it
/// among motions that are free, by their rounding.
FixedPointResult resting_answer(const ContactLine& line, const ContactLaw& law,
                                Index dofs) {
  FixedPointResult rest;
  rest.answer.P = VectorXd::Zero(2 * line.node_count());
  rest.answer.v =
      weight_of_rows(law.multiplier, line) *
      displacement_against_foundation(line, law, VectorXd::Zero(dofs))
          .reshaped();
  rest.answer.state.assign(line.node_count(), ContactState::open);
  rest.answer.status = ContactStatus::converged;
  return rest;
}

Index nearest(const Ref<const VectorXd>& values, double value) {
  Index place;
  (values.array() - value).abs().minCoeff(&place);
  return place;
}

}  // namespace

ContactStatus judged_status(ContactStatus condensed, double complementarity,
                            double residual, double tolerance) {
  if (complementarity <= tolerance && residual <= tolerance)
    return condensed == ContactStatus::singular ? condensed
                                                : ContactStatus::converged;
  return condensed == ContactStatus::converged ? ContactStatus::inaccurate
                                               : condensed;
}

const char* in_words(ContactStatus status) {
  switch (status) {
    case ContactStatus::converged: return "converged";
    case ContactStatus::cycled: return "the active set cycles";
    case ContactStatus::singular: return "the body slides or rotates freely";
    case ContactStatus::not_converged: return "the iterations are used up";
    case ContactStatus::inaccurate: return "rounding exceeds the tolerance";
  }
  return "";
}

ContactStates states_at(const ContactLine& line,
                        const Ref<const VectorXd>& old_abscissa,
                        const ContactStates& old_state) {
  require_size("abscissa of the initial states", old_abscissa.size(),
               count_of(old_state));
  if (old_state.empty()) return {};
  ContactStates states;
  for (double s : line.abscissa)
    states.push_back(old_state[nearest(old_abscissa, s)]);
  return states;
}

ContactSolution solve_contact(const Mesh& mesh, const ContactLine& line,
                              const ContactLaw& law,
                              const ElasticSystem& system,
                              const ContactSettings& settings) {
  require_sound(mesh, line, law, system, settings);

  // 1. The body as the contact line sees it, P = S v - g.
  ContactSolution solution;
  solution.stiffness =
      prepared_stiffness(contact_dofs(line, system), system, settings);
  const CondensedStiffness& stiffness = *solution.stiffness;
  solution.contact = held_or_refused(mesh, line, system, [&] {
    return std::make_shared<const CondensedContact>(condensed_contact(
        line, law, system, stiffness, {}, unheld_motions(mesh, system)));
  });
  const CondensedContact& contact = *solution.contact;

  // 2. The conditions of Prop. 3.4 / 3.5.
  FixedPointResult condensed =
      is_at_rest(law, system)
          ? resting_answer(line, law, system.dof_count())
          : condensed_answer(contact, nodal_law(law, line), settings);
  const ActiveSetResult& answer = condensed.answer;
  solution.iterations = answer.iterations;
  solution.history = std::move(condensed.history);
  for (ContactState state : answer.state)
    solution.state.push_back(answered(state));

  // 3. Back to the whole body.
  Judged whole = body_answer(line, law, system, stiffness, contact, answer);
  const Matrix2Xd P = whole.answer.P.reshaped(2, line.node_count());
  solution.displacement = std::move(whole.answer.displacement);
  put_multipliers(line, law, system.prescribed, P, solution);

  // 4. What the theory promises, measured.
  solution.residual = with_balance(
      whole.residual.of_forces,
      balance_defect(
          mesh, system,
          nodal_load(line, loading_forces(contact.held.row, solution.force),
                     system.dof_count())));
  solution.complementarity =
      complementarity_defect(line, law, contact.held, solution.displacement, P,
                             law_scales(contact, answer.v));
  solution.status = judged_status(answer.status, solution.complementarity,
                                  solution.residual, settings.tolerance);
  return solution;
}

}  // namespace ffcontact
