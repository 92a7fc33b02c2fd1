// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/law/contact_densities.hpp"
#include "ffcontact/estimate/error/contact_error.hpp"

/// Tractions in the cones of friction far above 1, where e pays mu times the rounding of
/// r_n.
namespace ffcontact {

/// Relaxation leaves tractions outside of the cone by its rounding; inside they unbalance
/// the stresses by as little.
void clamp_rounding(const ContactLine& line, const ContactLaw<2>& law,
                    ContactDensities& densities);

/// Does an edge without tractions stay without, as outweighs_all_gains says?
/// @param displacement  u_hat on all dofs [mm]
bool stays_unloaded(const ContactLine& line, const ContactLaw<2>& law,
                    const Ref<const VectorXd>& displacement,
                    const ContactDensities& densities,
                    const TractionCosts& costs, int e);

}  // namespace ffcontact
