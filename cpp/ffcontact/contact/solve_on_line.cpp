// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/balance.hpp"
#include "ffcontact/contact/checks/feasibility.hpp"
#include "ffcontact/contact/checks/line_balance.hpp"
#include "ffcontact/contact/checks/unheld_bodies.hpp"
#include "ffcontact/contact/condensed_answer.hpp"
#include "ffcontact/contact/corrected_answer.hpp"
#include "ffcontact/contact/far_gaps.hpp"
#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/contact/line_relation.hpp"
#include "ffcontact/contact/solve_contact.hpp"

namespace ffcontact {

namespace {

ContactSolution<2> solution_on_line(const Mesh& mesh, const ContactLine& line,
                                    const ContactLaw<2>& law,
                                    const ElasticSystem& system,
                                    const ContactSettings& settings) {
  const StatedContact<2> stated = stated_on_line(line, law, system, settings);
  const auto stiffness =
      prepared_stiffness(contact_dofs(line, system), system, settings);
  const auto contact = held_or_refused(mesh, line, system, [&] {
    return std::make_shared<const CondensedContact>(condensed_contact(
        line, law, system, *stiffness, {}, unheld_motions(mesh, system)));
  });
  CorrectedAnswer<2> answer(stated,
                            line_relation(stated, *contact, *stiffness));
  answer.correct();
  ContactSolution<2> solution = answer.solution(mesh);
  const Matrix2Xd P = answer.multipliers().reshaped(2, line.node_count());
  solution.pressure = law.multiplier == Multiplier::pressure
                          ? P
                          : consistent_pressures(line, system.prescribed, P);
  solution.stiffness = stiffness;
  solution.contact = contact;
  return solution;
}

}  // namespace

ContactSolution<2> solve_contact(const Mesh& mesh, const ContactLine& line,
                                 const ContactLaw<2>& law,
                                 const ElasticSystem& system,
                                 const ContactSettings& settings) {
  require_valid(mesh, line, law, system, settings);
  require_feasible(mesh, line, law, system);
  require_balance(mesh, line, law, system);
  return solved_with_far_gaps<2>(
      law, settings,
      [&](const ContactLaw<2>& near, const ContactSettings& with) {
        return solution_on_line(mesh, line, near, system, with);
      });
}

}  // namespace ffcontact
