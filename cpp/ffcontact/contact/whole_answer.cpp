// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/whole_answer.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/condensed_answer.hpp"

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
    const ContactStates states =
        law.bonded ? state : open_where_cut(state, best.answer.P);
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
  BodyAnswer answer{
      displacement_of(contact, stiffness, condensed.v, condensed.P) +
          system.prescribed_value,
      condensed.P};
  if (condensed.status == ContactStatus::converged)
    return refined_answer(line, law, system, stiffness, contact,
                          condensed.state, std::move(answer));
  const ResidualDefect residual =
      residual_defect(line, law, system, contact.held, answer);
  return {std::move(answer), residual};
}

/// How far an answer of the whole body is from the law.
double law_defect(const ContactLine& line, const ContactLaw& law,
                  const CondensedContact& contact, const BodyAnswer& answer,
                  const VectorXd& v) {
  return complementarity_defect(line, on_layer(line, law, contact.held, answer),
                                contact.held, answer.displacement,
                                answer.P.reshaped(2, line.node_count()),
                                law_scales(contact, v));
}

WholeAnswer whole_of(const ContactLine& line, const ContactLaw& law,
                     const ElasticSystem& system,
                     const CondensedStiffness& stiffness,
                     const CondensedContact& contact,
                     ActiveSetResult condensed) {
  Judged judged = body_answer(line, law, system, stiffness, contact, condensed);
  const double off = law_defect(line, law, contact, judged.answer, condensed.v);
  return {std::move(condensed), std::move(judged.answer), judged.residual, off};
}

/// The law anew for what the last answer misses of it.
WholeAnswer corrected(const ContactLine& line, const ContactLaw& law,
                      const ElasticSystem& system,
                      const ContactSettings& settings,
                      const CondensedStiffness& stiffness,
                      const CondensedContact& contact, WholeAnswer last) {
  const VectorXd& u = last.body.displacement;
  CondensedContact carried = contact;
  put_carried(last.body.P, carried);
  const CondensedContact rest =
      with_loads(std::move(carried), stiffness,
                 force_residual(system, u, VectorXd::Zero(system.dof_count())),
                 weight_of_rows(law.multiplier, line) *
                     steered_displacement(
                         line, on_layer(line, law, contact.held, last.body),
                         contact.held, u)
                         .reshaped());
  ContactSettings near = settings;
  near.initial_state = last.condensed.state;
  ActiveSetResult next =
      condensed_answer(rest, nodal_law(law, line), near).answer;
  Judged judged = judged_without_rounding(
      line, law, system, contact.held,
      {u + displacement_of(rest, stiffness, next.v, next.P), next.P});
  const double off =
      law_defect(line, law, contact, judged.answer, last.condensed.v);
  next.iterations += last.condensed.iterations;
  if (next.status != ContactStatus::converged || off >= last.off ||
      judged.residual.largest() >
          std::max(settings.tolerance, last.residual.largest()))
    return last;
  next.v = last.condensed.v;
  return {std::move(next), std::move(judged.answer), judged.residual, off};
}

}  // namespace

WholeAnswer whole_answer(const ContactLine& line, const ContactLaw& law,
                         const ElasticSystem& system,
                         const ContactSettings& settings,
                         const CondensedStiffness& stiffness,
                         const CondensedContact& contact,
                         ActiveSetResult condensed) {
  WholeAnswer whole =
      whole_of(line, law, system, stiffness, contact, std::move(condensed));
  if (whole.condensed.status != ContactStatus::converged ||
      whole.off <= settings.tolerance)
    return whole;
  return corrected(line, law, system, settings, stiffness, contact,
                   std::move(whole));
}

}  // namespace ffcontact
