// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/contact_solution.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/balance.hpp"
#include "ffcontact/contact/condensed_contact.hpp"

namespace ffcontact {

namespace {

/// Components at nodes that no equation of the body moves, so that nodal forces leave their pressures open.
Eigen::Array<bool, 2, Eigen::Dynamic> immovable(const CondensedContact& contact, int nodes) {
  Eigen::Array<bool, 2, Eigen::Dynamic> absent(2, nodes);
  absent.setConstant(false);
  for (std::size_t k = 0; k < contact.dependent.size(); ++k) {
    const int row = contact.dependent[k];
    absent(row % 2, row / 2) = contact.E.col(static_cast<Eigen::Index>(k)).cwiseAbs().sum() == 0;
  }
  return absent;
}

Eigen::VectorXd primary_values(const CondensedContact& contact, const Eigen::VectorXd& rows) {
  Eigen::VectorXd values(contact.S.rows());
  for (Eigen::Index k = 0; k < values.size(); ++k) values[k] = rows[contact.primary[k]];
  return values;
}

/// Contact forces on all dofs, sum over nodes of F_n n + F_t t.
Eigen::VectorXd contact_load(const ContactLine& line, const Eigen::Matrix2Xd& force, Eigen::Index dofs) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(dofs);
  for (int i = 0; i < line.node_count(); ++i)
    load.segment<2>(2 * line.vertex[i]) += force(0, i) * line.normal.col(i) + force(1, i) * line.tangent(i);
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

}  // namespace

const char* in_words(ContactStatus status) {
  switch (status) {
    case ContactStatus::converged: return "converged";
    case ContactStatus::cycled: return "the active set cycles";
    case ContactStatus::singular: return "the body slides or rotates freely";
    case ContactStatus::not_converged: return "the iterations are used up";
  }
  return "";
}

Eigen::Matrix2Xd nodal_pressures(const ContactLine& line, const Eigen::Matrix2Xd& force,
                                 const Eigen::Array<bool, 2, Eigen::Dynamic>& absent) {
  const Eigen::SparseMatrix<double> mass = contact_mass(line);
  Eigen::Matrix2Xd pressure(2, line.node_count());
  for (int c = 0; c < 2; ++c) {
    Eigen::SparseMatrix<double> reduced = mass;
    Eigen::VectorXd right = force.row(c);
    reduced.prune([&](Eigen::Index i, Eigen::Index j, double) { return i == j || !(absent(c, i) || absent(c, j)); });
    for (int i = 0; i < line.node_count(); ++i)
      if (absent(c, i)) right[i] = 0;
    pressure.row(c) = Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>(reduced).solve(right);
  }
  return pressure;
}

ContactSolution solve_contact(const Mesh& mesh, const ContactLine& line, const ContactLaw& law, const ElasticSystem& system,
                              const ContactSettings& settings) {
  require_valid(law, line);
  require_size("A", system.dof_count(), 2 * mesh.vertices.cols());
  if (settings.max_iterations < 1) refuse("maxit must be at least 1, got ", settings.max_iterations);
  require_balance(mesh, line, law, system);

  const CondensedStiffness stiffness(system, contact_dofs(line, system));
  const CondensedContact contact = condensed_contact(line, law, system, stiffness);

  std::vector<ContactState> start = settings.initial_state;
  if (start.empty()) start.assign(line.node_count(), ContactState::stick);
  require_size("initial state", static_cast<Eigen::Index>(start.size()), line.node_count());
  const ActiveSetResult active = active_set_newton(contact, nodal_law(law, line), start,
                                                   {settings.max_iterations, settings.tolerance});

  ContactSolution solution;
  solution.status = active.status;
  solution.state = active.state;
  solution.iterations = active.iterations;
  solution.displacement = stiffness.extended(system.load, kept_displacement(contact, primary_values(contact, active.v)));
  solution.displacement += system.prescribed_value;

  const Eigen::Matrix2Xd P = Eigen::Map<const Eigen::Matrix2Xd>(active.P.data(), 2, line.node_count());
  if (law.multiplier == Multiplier::pressure) {
    solution.pressure = P;
    solution.force = P * contact_mass(line);
  } else {
    solution.force = P;
    solution.pressure = nodal_pressures(line, P, immovable(contact, line.node_count()));
  }
  solution.complementarity = complementarity_defect(line, law, solution.displacement, P);
  solution.residual =
      relative_residual(system, solution.displacement, contact_load(line, solution.force, system.dof_count()));
  return solution;
}

}  // namespace ffcontact
