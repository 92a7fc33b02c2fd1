// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"
#include "ffcontact/equilibrium/tractions/contact_facet.hpp"

namespace ffcontact {

/// The edges of a line whose tractions may be relaxed, all but those that stay unloaded,
/// with what these cost (TractionCosts), in the order of the line.
/// @param displacement  u_hat on all dofs [mm]
/// @param densities     r_hat
/// @param boundary      what the boundary carries with it
std::vector<ContactFacet<2>> contact_edges(
    const ContactLine& line, const ContactLaw<2>& law,
    const Ref<const VectorXd>& displacement, const ContactDensities& densities,
    const BoundaryTractions& boundary);

/// r_hat of given moments on all edges of the mesh takes the place of that on the edges.
void put_tractions(const std::vector<ContactFacet<2>>& contact,
                   const EdgeMoments& moments, ContactDensities& densities);

}  // namespace ffcontact
