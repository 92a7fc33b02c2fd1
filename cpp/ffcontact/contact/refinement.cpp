// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/refinement.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/contact/active_set_system.hpp"
#include "ffcontact/interface/nodal_force.hpp"

namespace ffcontact {

namespace {

constexpr double share_of_terms = 1e-4;

/// Of the contact forces W P on all dofs.
VectorXd contact_load(const ContactLine& line, const ContactLaw& law,
                      const HeldRows& held, const BodyAnswer& answer) {
  return nodal_load(
      line, loading_forces(held.row, nodal_forces_of(line, law, answer.P)),
      answer.displacement.size());
}

/// b + contact forces - K u on the free dofs.
VectorXd residual(const ElasticSystem& system, const VectorXd& u,
                  const VectorXd& contact) {
  VectorXd residual =
      system.load + contact - system.stiffness * (u - system.prescribed_value);
  for (Index dof = 0; dof < residual.size(); ++dof)
    if (system.prescribed[dof]) residual[dof] = 0;
  return residual;
}

}  // namespace

Matrix2Xd nodal_forces_of(const ContactLine& line, const ContactLaw& law,
                          const VectorXd& P) {
  return (weight_of_rows(law.multiplier, line) * P)
      .reshaped(2, line.node_count());
}

double residual_defect(const ContactLine& line, const ContactLaw& law,
                       const ElasticSystem& system, const HeldRows& held,
                       const BodyAnswer& answer) {
  const VectorXd& u = answer.displacement;
  const VectorXd contact = contact_load(line, law, held, answer);
  const VectorXd r = residual(system, u, contact);
  const double apart = largest_given(law);
  double forces = 0;
  for (Index dof = 0; dof < r.size(); ++dof)
    if (!system.prescribed[dof])
      forces =
          std::max(forces, std::abs(system.load[dof]) + std::abs(contact[dof]));
  double defect = 0;
  for (Index dof = 0; dof < r.size(); ++dof) {
    if (r[dof] == 0) continue;
    double terms = 0;
    for (RowMatrix::InnerIterator e(system.stiffness, dof); e; ++e)
      terms += std::abs(e.value()) * (std::abs(u[e.col()]) + apart);
    defect = std::max(
        defect, std::abs(r[dof]) / std::max(forces, share_of_terms * terms));
  }
  return defect;
}

BodyAnswer refined(const ContactLine& line, const ContactLaw& law,
                   const ElasticSystem& system,
                   const CondensedStiffness& stiffness,
                   const CondensedContact& contact,
                   const std::vector<ContactState>& state,
                   const BodyAnswer& answer) {
  const VectorXd forces = contact_load(line, law, contact.held, answer);
  const VectorXd load = residual(system, answer.displacement, forces);
  VectorXd v =
      weight_of_rows(law.multiplier, line) *
      steered_displacement(line, law, contact.held, answer.displacement)
          .reshaped();
  for (Index row = 0; row < v.size(); ++row)
    if (!holds(state[row / 2], static_cast<int>(row % 2))) v[row] = 0;
  const CondensedContact correction = with_loads(contact, stiffness, load, v);
  NodalLaw unbounded = nodal_law(law, line);
  for (FrictionCone& cone : unbounded.cone) cone.cohesion = cone.limit = 0;
  ContactRows rows;
  if (solve_active_set(correction, unbounded, state, rows) ==
      SystemKind::inconsistent)
    return answer;
  const VectorXd kept = kept_displacement(correction, rows.v(contact.primary),
                                          rows.P(contact.dependent));
  return {answer.displacement + stiffness.extended(correction.load, kept),
          answer.P + rows.P};
}

}  // namespace ffcontact
