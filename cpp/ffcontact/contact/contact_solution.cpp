// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/contact_solution.hpp"

#include <algorithm>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/checks/balance.hpp"
#include "ffcontact/contact/checks/feasibility.hpp"
#include "ffcontact/contact/checks/line_balance.hpp"
#include "ffcontact/contact/checks/unheld_bodies.hpp"
#include "ffcontact/contact/condensed_answer.hpp"
#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/contact/whole_answer.hpp"
#include "ffcontact/interface/nodal_force.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

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
bool has_open_gap(const ContactLaw& law) {
  return law.gap.size() > 0 && law.gap.minCoeff() >= 0 && max_norm(law.gap) > 0;
}

bool is_at_rest(const ContactLaw& law, const ElasticSystem& system) {
  return system.load.isZero(0) && system.prescribed_value.isZero(0) &&
         has_open_gap(law) && law.previous.isZero(0);
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
  solution.history = std::move(condensed.history);

  // 3. Back to the whole body.
  const WholeAnswer whole = whole_answer(line, law, system, settings, stiffness,
                                         contact, std::move(condensed.answer));
  for (ContactState state : whole.condensed.state)
    solution.state.push_back(answered(state));
  solution.iterations = whole.condensed.iterations;
  solution.displacement = whole.body.displacement;
  put_multipliers(line, law, system.prescribed,
                  whole.body.P.reshaped(2, line.node_count()), solution);

  // 4. What the theory promises, measured.
  solution.complementarity = whole.off;
  solution.residual = with_balance(
      whole.residual.of_forces,
      balance_defect(
          mesh, system,
          nodal_load(line, without<Matrix2Xd>(contact.held.row, solution.force),
                     system.dof_count())));
  solution.status =
      judged_status(whole.condensed.status, solution.complementarity,
                    solution.residual, settings.tolerance);
  return solution;
}

}  // namespace ffcontact
