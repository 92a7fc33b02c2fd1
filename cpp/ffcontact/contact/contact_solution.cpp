// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/contact_solution.hpp"

#include <algorithm>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/balance.hpp"
#include "ffcontact/contact/condensed_contact.hpp"
#include "ffcontact/contact/feasibility.hpp"
#include "ffcontact/contact/fixed_point.hpp"
#include "ffcontact/contact/friction_continuation.hpp"
#include "ffcontact/contact/nodal_pressures.hpp"

namespace ffcontact {

namespace {

Eigen::VectorXd selected(const Eigen::VectorXd& values, const std::vector<int>& rows) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(rows.size()));
  for (Eigen::Index k = 0; k < result.size(); ++k) result[k] = values[rows[k]];
  return result;
}

/// Contact forces on all dofs: F_n n + F_t t at every node, and against it on the opposite body.
Eigen::VectorXd contact_load(const ContactLine& line, const Eigen::Matrix2Xd& force, Eigen::Index dofs) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(dofs);
  for (int i = 0; i < line.node_count(); ++i) {
    const Eigen::Vector2d F = force(0, i) * line.normal.col(i) + force(1, i) * line.tangent(i);
    load.segment<2>(2 * line.vertex[i]) += F;
    visit_opposite(line, i, [&](int vertex, double weight) { load.segment<2>(2 * vertex) -= weight * F; });
  }
  return load;
}

double relative_residual(const ElasticSystem& system, const Eigen::VectorXd& u, const Eigen::VectorXd& contact) {
  Eigen::VectorXd residual = system.stiffness * (u - system.prescribed_value) - system.load - contact;
  double scale = 0;
  for (Eigen::Index dof = 0; dof < residual.size(); ++dof)
    if (system.prescribed[dof])
      residual[dof] = 0;
    else
      scale = std::max(scale, std::abs(system.load[dof]) + std::abs(contact[dof]));
  return scale > 0 ? residual.cwiseAbs().maxCoeff() / scale : 0;
}

bool may_be_mended(const ActiveSetResult& answer) {
  return answer.status == ContactStatus::cycled || answer.status == ContactStatus::singular;
}

/// Takes another answer to the same problem if it is better; its linear systems are counted in any case.
void improve(FixedPointResult& result, ActiveSetResult other) {
  const int systems = result.answer.iterations + other.iterations;
  if (other.status == ContactStatus::converged || other.violation < result.answer.violation)
    result.answer = std::move(other);
  result.answer.iterations = systems;
}

/// Newton; where it cycles, friction raised in few, then in many steps, then Newton from the states of the fixed point.
FixedPointResult safeguarded_newton(const CondensedContact& contact, const NodalLaw& law,
                                    const std::vector<ContactState>& start, const NewtonSettings& settings) {
  FixedPointResult result{active_set_newton(contact, law, start, settings), {}};
  for (const int steps : {4, 16})
    if (may_be_mended(result.answer)) improve(result, friction_continuation(contact, law, start, steps, settings));
  if (may_be_mended(result.answer)) {
    FixedPointResult path = fixed_point(contact, law, start, settings);
    const std::vector<ContactState> states = path.answer.state;
    improve(result, std::move(path.answer));
    improve(result, active_set_newton(contact, law, states, settings));
    result.history = std::move(path.history);
  }
  return result;
}

/// The pressures and forces of the multipliers that were solved for.
void put_multipliers(const ContactLine& line, const ContactLaw& law, const std::vector<char>& prescribed,
                     const Eigen::Matrix2Xd& P, ContactSolution& solution) {
  if (law.multiplier == Multiplier::pressure) {
    solution.pressure = P;
    solution.force = (weight_of_rows(Multiplier::pressure, line) * P.reshaped()).reshaped(2, P.cols());
  } else {
    solution.force = P;
    solution.pressure = consistent_pressures(line, prescribed, P);
  }
}

}  // namespace

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

std::vector<ContactState> states_at(const ContactLine& line, const Eigen::Ref<const Eigen::VectorXd>& old_abscissa,
                                    const std::vector<ContactState>& old_state) {
  require_size("abscissa of the initial states", old_abscissa.size(), static_cast<Eigen::Index>(old_state.size()));
  if (old_state.empty()) return {};
  std::vector<ContactState> states;
  for (double s : line.abscissa) {
    Eigen::Index nearest;
    (old_abscissa.array() - s).abs().minCoeff(&nearest);
    states.push_back(old_state[nearest]);
  }
  return states;
}

ContactSolution solve_contact(const Mesh& mesh, const ContactLine& line, const ContactLaw& law,
                              const ElasticSystem& system, const ContactSettings& settings) {
  require_valid(law, line);
  require_size("A", system.dof_count(), 2 * mesh.vertices.cols());
  if (settings.max_iterations < 1) refuse("maxit must be at least 1, got ", settings.max_iterations);
  std::vector<ContactState> start = settings.initial_state;
  if (start.empty()) start.assign(line.node_count(), ContactState::stick);
  require_size("initial state", static_cast<Eigen::Index>(start.size()), line.node_count());
  require_feasible(mesh, line, law, system);
  require_balance(mesh, line, law, system);

  // 1. The body as the contact line sees it, P = S v - g.
  const CondensedStiffness stiffness(system, contact_dofs(line, system));
  const CondensedContact contact = condensed_contact(line, law, system, stiffness);

  // 2. The conditions of Prop. 3.4 / 3.5.
  const NodalLaw nodal = nodal_law(law, line);
  const NewtonSettings limits{settings.max_iterations, settings.tolerance};
  FixedPointResult condensed = settings.solver == ContactSolver::newton
                                   ? safeguarded_newton(contact, nodal, start, limits)
                                   : fixed_point(contact, nodal, start, limits);
  const ActiveSetResult& answer = condensed.answer;

  // 3. Back to the whole body.
  ContactSolution solution;
  solution.status = answer.status;
  for (ContactState state : answer.state) solution.state.push_back(is_open(state) ? ContactState::open : state);
  solution.iterations = answer.iterations;
  solution.history = std::move(condensed.history);
  solution.displacement = stiffness.extended(
      system.load,
      kept_displacement(contact, selected(answer.v, contact.primary), selected(answer.P, contact.dependent)));
  solution.displacement += system.prescribed_value;
  const Eigen::Matrix2Xd P = answer.P.reshaped(2, line.node_count());
  put_multipliers(line, law, system.prescribed, P, solution);

  // 4. What the theory promises, measured.
  solution.complementarity = complementarity_defect(line, law, solution.displacement, P);
  solution.residual =
      relative_residual(system, solution.displacement, contact_load(line, solution.force, system.dof_count()));
  const bool fulfilled = solution.complementarity <= settings.tolerance && solution.residual <= settings.tolerance;
  if (fulfilled && solution.status != ContactStatus::singular) solution.status = ContactStatus::converged;
  if (!fulfilled && solution.status == ContactStatus::converged) solution.status = ContactStatus::inaccurate;
  return solution;
}

}  // namespace ffcontact
