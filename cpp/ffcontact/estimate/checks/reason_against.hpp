// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "ffcontact/estimate/bodies/estimate_settings.hpp"
#include "ffcontact/estimate/error/between_nodes.hpp"
#include "ffcontact/estimate/error/pair_error.hpp"
#include "ffcontact/mesh/facets.hpp"

namespace ffcontact {

/// Where a pair is the farthest from admissible.
struct WorstPlaces {
  VectorXd deepest;  ///< where u_hat penetrates most
  bool is_bonded;    ///< does it jump there in place of penetrating?
  VectorXd turned;   ///< middle of the facet along which directions turn most
  VectorXd
      negative;  ///< middle of that with the least integrand of the contact part
};

/// Is next to nothing of e^2 but its contact part?
bool pays_for_contact_alone(const PairError& error);

/// The middle of a facet as who made the mesh knows it.
template <int dim>
VectorOf<dim> middle_of(const SimplexMesh<dim>& mesh, const Facets<dim>& facets,
                        int facet) {
  return mesh.origin + facet_points(mesh, facets, facet).rowwise().mean();
}

/// Puts what was found between the nodes into the error, in its units.
/// @param work  largest stress times largest displacement [MPa mm]
void put_between_nodes(const BetweenNodes& found, double work,
                       PairError& error);

/// Why a pair is not admissible, and what to do, one sentence without a full stop:
/// contact directions that turn along a facet, penetration above 1e-12, tractions outside
/// of the cone by more than 1e-12, a contact part whose integrand is below -1e-11, stresses
/// out of equilibrium by more than 1e-10. Nothing if it is.
/// @param unmended  edges that (4.1) cannot mend
std::string reason_against(const PairError& error, const WorstPlaces& worst,
                           Construction construction = Construction::composite,
                           std::size_t unmended = 0);

}  // namespace ffcontact
