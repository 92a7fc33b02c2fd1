// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>

#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"
#include "ffcontact/mesh/facets.hpp"

namespace ffcontact {

/// The reaction that is out of balance, as the end of a sentence; empty if it is none: of
/// displacements prescribed along a contact facet, or of a point support.
/// @param contact  facets of the mesh
template <int d>
std::string reaction_in_words(const Imbalance& imbalance,
                              const ElasticSystem& system,
                              const Facets<d>& facets,
                              const VectorXi& contact) {
  const auto is_prescribed = [&](int vertex) {
    return system.prescribed[dof_of<d>(vertex, imbalance.component)] != 0;
  };
  if (!is_prescribed(imbalance.vertex)) return "";
  const auto is_held = [&](int facet) {
    const auto vertices = facets.vertices.col(facet);
    return (vertices.array() == imbalance.vertex).any() &&
           std::all_of(vertices.begin(), vertices.end(), is_prescribed);
  };
  const std::string facet = d == 2 ? "edges" : "faces";
  if (std::none_of(contact.begin(), contact.end(), is_held))
    return "it is the reaction of a point support, which no admissible stress "
           "has: prescribe displacements on whole " +
           facet;
  return std::string(
             "it is the reaction of displacements that are prescribed "
             "along the contact ") +
         (d == 2 ? "line" : "surface") +
         ", which is no friction and is not judged: leave them free there and "
         "take a large friction= that holds them, or take these " +
         facet + " out of label=";
}

}  // namespace ffcontact
