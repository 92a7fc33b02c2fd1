// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/other_multiplier.hpp"

#include <cmath>

#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/interface/nodal_force.hpp"

namespace ffcontact {

namespace {

/// lambda_h of the same nodal pressures with the other multiplier [2 x p].
Matrix2Xd density_of_other_multiplier(const SolvedProblem<2>& solved) {
  const auto& [topology, line, system, body] = solved;
  if (body.law.multiplier == Multiplier::force)
    return lumped_pressures(line, forces_of(line, body.multipliers));
  return multiplier_density(line, Multiplier::force, system.prescribed,
                            body.multipliers);
}

const char* name_of(Multiplier multiplier) {
  return multiplier == Multiplier::force ? "\"force\"" : "\"pressure\"";
}

}  // namespace

std::string other_multiplier_in_words(const Imbalance& imbalance,
                                      const SolvedProblem<2>& solved,
                                      const NodalResidual<2>& without_contact) {
  const Matrix2Xd forces =
      forces_of(solved.contact, density_of_other_multiplier(solved));
  const NodalResidual<2> residual = with_forces(
      without_contact,
      nodal_load(solved.contact, forces, solved.system.dof_count()));
  const double left = residual.missing(imbalance.component, imbalance.vertex);
  if (std::abs(left) > unbalanced * residual.scale) return {};
  const Multiplier own = solved.body.law.multiplier,
                   other = own == Multiplier::force ? Multiplier::pressure
                                                    : Multiplier::force;
  return std::string("pn and pt fit u with multiplier=") + name_of(other) +
         ", not with " + name_of(own);
}

}  // namespace ffcontact
