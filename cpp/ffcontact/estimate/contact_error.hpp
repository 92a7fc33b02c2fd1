// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/cone_correction.hpp"

namespace ffcontact {

/// u_hat: the displacement with u_n - gap lowered to min(u_n - gap, 0) at the contact nodes, nothing else changed [CHH01, 4.1].
/// Needed for M'_h only; a displacement that does not penetrate comes back as it is.
/// At a vertex with two nodes, or with a prescribed component, it is the smallest change that keeps all of them; where there is
/// none, as where prescribed components push the vertex into the foundation, nothing is changed (see penetration_defect).
/// @param displacement  u_h on all dofs [mm]
/// @param prescribed    1 where the dof is prescribed and stays; empty for none
Eigen::VectorXd admissible_displacement(const ContactLine& line, const ContactLaw& law,
                                        const Eigen::Ref<const Eigen::VectorXd>& displacement,
                                        const std::vector<char>& prescribed = {});

/// How far a displacement penetrates: the largest u_n - gap at the nodes, relative to the largest displacement or gap; 0 where it
/// keeps clear. Between the nodes all of it is linear.
struct PenetrationDefect {
  double value = 0;
  int node = 0;  ///< where
};
PenetrationDefect penetration_defect(const ContactLine& line, const ContactLaw& law,
                                     const Eigen::Ref<const Eigen::VectorXd>& displacement);

/// The contact part of e^2 on each contact edge, exactly [N/mm times mm]:
///     2 int (mu |r_n| |w_t| + r_t w_t + r_n (w_n - gap))      [CHH01, (2.11)], with k |w_t| for Tresca's law (2.19).
/// mu and k are the law's upper bounds along the edge (most_coefficient). Each edge is split where w_t or r_n changes sign. Inside the cone and without penetration every value is >= 0; the
/// indicator functions are left out: outside the cone the value has no meaning as a bound and can be negative.
/// @param displacement  u_hat on all dofs [mm]
Eigen::VectorXd contact_error(const ContactLine& line, const ContactLaw& law, const ContactDensities& densities,
                              const Eigen::Ref<const Eigen::VectorXd>& displacement);

/// What the end values of r_hat cost in the contact part of e^2 when r_hat is in the cone, [mm^2]:
///     cost_n = 2 int phi (-mu |w_t| + w_n - gap)   (Tresca: 2 int phi (w_n - gap)),   cost_t = 2 int phi w_t
/// at the two ends of each edge [2 x m]. For Tresca's law the constant 2 int k |w_t| is left out.
struct TractionCosts {
  Eigen::Matrix2Xd normal, tangential;
};
TractionCosts traction_costs(const ContactLine& line, const ContactLaw& law,
                             const Eigen::Ref<const Eigen::VectorXd>& displacement);

}  // namespace ffcontact
