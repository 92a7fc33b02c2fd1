// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/law/contact_densities.hpp"
#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/estimate/error/between_nodes.hpp"

namespace ffcontact {

/// The contact part of e^2 on each contact edge, exactly [N/mm times mm]:
///     2 int (mu |r_n| |w_t| + r_t w_t + r_n (w_n - gap))      [CHH01, (2.11)], with k |w_t| for Tresca's law (2.19) and
/// min(mu |r_n|, k) |w_t| with a shear limit k. mu and k are the law's upper bounds along
/// the edge (most_cones). Where directions turn w_n = w . n(s), w_t = w . t(s) are quadratic
/// (EdgeMotions), and |n(s)| of r = r_n n(s) + r_t t(s) is that of the slip's direction
/// t(s) / |n(s)|: it cancels but in k |w_t| / |n(s)|, for which the least |n(s)| counts. Each
/// edge is split where w_t or r_n
/// changes sign, and where mu |r_n| = k. Inside the cone and without penetration every
/// value is >= 0; the indicator functions are left out: outside the cone the value has no
/// meaning as a bound and can be negative.
/// @param displacement  u_hat on all dofs [mm]
VectorXd contact_error(const ContactLine& line, const ContactLaw<2>& law,
                       const ContactDensities& densities,
                       const Ref<const VectorXd>& displacement);

/// Adds what belongs to the contact edges to their cells, one half of it to the cell of the
/// edge that faces a whole one.
void add_to_cells(const Edges& edges, const ContactLine& line,
                  const VectorXd& of_edges, VectorXd& local);

/// What the end values of r_hat cost in the contact part of e^2 when r_hat is in the
/// cone, [mm^2]:
///     cost_n = 2 int phi (-mu |w_t| + w_n - gap)   (Tresca: 2 int phi (w_n - gap)),   cost_t = 2 int phi w_t
/// at the two ends of each edge [2 x m]. For Tresca's law the constant 2 int k |w_t| is
/// left out. With a shear limit mu |w_t| counts where -mu r_n is below the limit k for
/// the given densities: min(-mu r_n, k) is concave in r_n, so that this is never below
/// its change. mu counts as 1e4 where it is larger: relaxation would round what
/// larger ones cost, and has no reason to pay them.
struct TractionCosts {
  Matrix2Xd normal, tangential;
};
TractionCosts traction_costs(const ContactLine& line, const ContactLaw<2>& law,
                             const ContactDensities& densities,
                             const Ref<const VectorXd>& displacement);

/// Along all edges of the line; facets are numbers of contact edges.
BetweenNodes between_nodes(const ContactLine& line, const ContactLaw<2>& law,
                           const ContactDensities& densities,
                           const Ref<const VectorXd>& displacement);

}  // namespace ffcontact
