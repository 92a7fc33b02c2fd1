// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/refinement.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/contact/active_set/active_set_system.hpp"
#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/elastic/row_sum.hpp"
#include "ffcontact/interface/nodal_force.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

constexpr double share_of_terms = 1e-4, share_of_largest_row = 2.2e-7;

/// Of the contact forces W P on all dofs.
VectorXd contact_load(const ContactLine& line, const ContactLaw& law,
                      const HeldRows& held, const BodyAnswer& answer) {
  return nodal_load(
      line, without<Matrix2Xd>(held.row, nodal_forces_of(line, law, answer.P)),
      answer.displacement.size());
}

/// Of the loads and contact forces on a free dof.
double largest_force(const ElasticSystem& system, const VectorXd& contact) {
  double largest = 0;
  for (Index dof = 0; dof < contact.size(); ++dof) {
    const double force = std::abs(system.load[dof]) + std::abs(contact[dof]);
    if (!system.prescribed[dof]) largest = std::max(largest, force);
  }
  return largest;
}

/// sum |K_ij| (|u_j| + apart)
double terms_of_equation(const ElasticSystem& system, Index dof,
                         const VectorXd& u, double apart) {
  double terms = 0;
  for (RowMatrix::InnerIterator e(system.stiffness, dof); e; ++e)
    terms += std::abs(e.value()) * (std::abs(u[e.col()]) + apart);
  return terms;
}

double defect_of_forces(const ElasticSystem& system, const VectorXd& r,
                        const VectorXd& u, const VectorXd& contact,
                        double apart) {
  const double forces = largest_force(system, contact);
  double defect = 0;
  for (Index dof = 0; dof < r.size(); ++dof) {
    if (r[dof] == 0) continue;
    const double terms = terms_of_equation(system, dof, u, apart);
    const double scale = std::max(forces, share_of_terms * terms);
    defect = std::max(defect, std::abs(r[dof]) / scale);
  }
  return defect;
}

double defect_of_rows(const ElasticSystem& system, const VectorXd& r,
                      const VectorXd& u, const VectorXd& contact,
                      double apart) {
  const double moved = max_norm(u) + apart;
  VectorXd size = system.load.cwiseAbs() + contact.cwiseAbs();
  for (Index dof = 0; dof < r.size(); ++dof)
    size[dof] = system.prescribed[dof]
                    ? 0
                    : size[dof] + moved * row_sum(system.stiffness, dof);
  const double least = share_of_largest_row * max_norm(size);
  if (least == 0) return 0;
  return (r.array().abs() / size.array().max(least)).maxCoeff();
}

/// v of the rows that hold it, W (u_n - gap, u_t - previous), and 0 on the others.
VectorXd held_displacement(const ContactLine& line, const ContactLaw& law,
                           const HeldRows& held, const ContactStates& state,
                           const VectorXd& displacement) {
  VectorXd v = weight_of_rows(law.multiplier, line) *
               steered_displacement(line, law, held, displacement).reshaped();
  for (Index row = 0; row < v.size(); ++row)
    if (!holds(state[row / 2], static_cast<int>(row % 2))) v[row] = 0;
  return v;
}

/// The law of a correction: bounds are those of the answer.
NodalLaw without_bounds(NodalLaw law) {
  for (FrictionCone& cone : law.cone) cone.cohesion = cone.limit = 0;
  return law;
}

}  // namespace

ContactLaw on_layer(const ContactLine& line, const ContactLaw& law,
                    const HeldRows& held, const BodyAnswer& answer) {
  if (!law.layer.given()) return law;
  const Matrix2Xd force = answer.P.reshaped(2, line.node_count());
  return on_layer(law,
                  lumped_pressures(line, without<Matrix2Xd>(held.row, force)));
}

Matrix2Xd nodal_forces_of(const ContactLine& line, const ContactLaw& law,
                          const VectorXd& P) {
  return (weight_of_rows(law.multiplier, line) * P)
      .reshaped(2, line.node_count());
}

VectorXd force_residual(const ElasticSystem& system, const VectorXd& u,
                        const VectorXd& contact) {
  return on_free_dofs(
      system,
      system.load + contact - system.stiffness * (u - system.prescribed_value));
}

ResidualDefect residual_defect(const ElasticSystem& system,
                               const VectorXd& displacement,
                               const VectorXd& contact_load, double apart) {
  const VectorXd r = force_residual(system, displacement, contact_load);
  return {defect_of_forces(system, r, displacement, contact_load, apart),
          defect_of_rows(system, r, displacement, contact_load, apart)};
}

ResidualDefect residual_defect(const ContactLine& line, const ContactLaw& law,
                               const ElasticSystem& system,
                               const HeldRows& held, const BodyAnswer& answer) {
  return residual_defect(system, answer.displacement,
                         contact_load(line, law, held, answer),
                         largest_given(law));
}

BodyAnswer refined(const ContactLine& line, const ContactLaw& law,
                   const ElasticSystem& system,
                   const CondensedStiffness& stiffness,
                   const CondensedContact& contact, const ContactStates& state,
                   const BodyAnswer& answer) {
  const VectorXd forces = contact_load(line, law, contact.held, answer);
  const VectorXd load = force_residual(system, answer.displacement, forces);
  const VectorXd v =
      held_displacement(line, on_layer(line, law, contact.held, answer),
                        contact.held, state, answer.displacement);
  const CondensedContact correction = with_loads(contact, stiffness, load, v);
  const NodalLaw unbounded = without_bounds(nodal_law(law, line));
  ContactRows rows;
  if (solve_active_set(correction, unbounded, state, rows) ==
      SystemKind::inconsistent)
    return answer;
  return {answer.displacement +
              displacement_of(correction, stiffness, rows.v, rows.P),
          answer.P + rows.P};
}

}  // namespace ffcontact
