// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/residual_defect.hpp"

#include <cmath>

#include "ffcontact/elastic/row_sum.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

constexpr double share_of_terms = 1e-4, share_of_largest_row = 2.2e-7;

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

}  // namespace

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

}  // namespace ffcontact
