// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/imbalance_cause.hpp"

#include <algorithm>

#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/estimate/tractions/other_multiplier.hpp"

namespace ffcontact {

namespace {

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

/// Which loads of u_h may be missing at a vertex, as the end of a sentence.
/// @param in_contact  what is said of a vertex where contact may occur; empty elsewhere
template <int d>
std::string missing_loads(const SimplexMesh<d>& mesh, int vertex,
                          const std::string& in_contact) {
  if (!(mesh.boundary.array() == vertex).any())
    return "inside the body: give the bodyforce=, initialstrain= and "
           "initialstress= u was computed with";
  if (!in_contact.empty()) return in_contact;
  return "on the boundary: give the traction=, rest=, initialstrain= and "
         "initialstress= u was computed with";
}

/// Which data may not be those of the solution at a vertex of the contact.
template <int d>
const char* data_of_contact() {
  return d == 2 ? "on the contact line: give pn and pt of the solution u, and "
                  "the same label=, normal= and traction="
                : "on the contact surface: give the forces of the solution u, "
                  "and the same label= and traction=";
}

}  // namespace

template <int d>
std::string cause_of(const Imbalance& imbalance, const SolvedProblem<d>& solved,
                     const NodalResidual<d>& without_contact) {
  const auto& [topology, contact, system, body] = solved;
  const std::string reaction = reaction_in_words<d>(
      imbalance, system, topology.facets, facets_of(contact));
  if (!reaction.empty()) return reaction;
  const std::vector<int> vertices = contact_vertices(contact);
  if (std::find(vertices.begin(), vertices.end(), imbalance.vertex) ==
      vertices.end())
    return missing_loads(topology.mesh, imbalance.vertex, "");
  if constexpr (d == 2) {
    const std::string other =
        other_multiplier_in_words(imbalance, solved, without_contact);
    if (!other.empty()) return other;
  }
  return missing_loads(topology.mesh, imbalance.vertex, data_of_contact<d>());
}

template std::string cause_of(const Imbalance&,
                              const SolvedProblem<FFCONTACT_DIMENSION>&,
                              const NodalResidual<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
