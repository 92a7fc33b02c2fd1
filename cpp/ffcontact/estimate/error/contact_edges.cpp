// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/contact_edges.hpp"

#include <Eigen/LU>
#include <map>

#include "ffcontact/estimate/error/contact_error.hpp"
#include "ffcontact/estimate/error/wide_cones.hpp"

namespace ffcontact {

namespace {

ContactFacet<2> contact_edge(const ContactLine& line, const ContactLaw<2>& law,
                             const TractionCosts& costs, int e) {
  ContactFacet<2> edge;
  edge.facet = line.edge[e];
  edge.index = e;
  edge.opposite = facing_edge(line, e);
  edge.opposite_corner = {1, 0};  // it runs the other way
  edge.measure = line.length[e];
  for (int end = 0; end < 2; ++end)
    edge.frame[end] = line.frame(line.edge_node(end, e));
  if (turns(line, e)) {
    edge.moments_of_bent = moments_of_ends(line, e);
    edge.bent_of_moments = edge.moments_of_bent.inverse();
  }
  edge.cone = least_cones(line, law, e);
  edge.work << costs.normal.col(e).transpose() / 2,
      costs.tangential.col(e).transpose() / 2;
  edge.slip.setZero();
  edge.direction.setZero();
  return edge;
}

}  // namespace

std::vector<ContactFacet<2>> contact_edges(
    const ContactLine& line, const ContactLaw<2>& law,
    const Ref<const VectorXd>& displacement, const ContactDensities& densities,
    const BoundaryTractions& boundary) {
  const TractionCosts costs =
      traction_costs(line, law, densities, displacement);
  std::multimap<int, ContactFacet<2>> along;  // by the first node
  for (int e = 0; e < line.edge_count(); ++e) {
    if (stays_unloaded(line, law, displacement, densities, costs, e)) continue;
    ContactFacet<2> edge = contact_edge(line, law, costs, e);
    edge.beside =
        boundary.moments.col(edge.facet) - contact_moments(line, densities, e);
    along.emplace(line.edge_node(0, e), edge);
  }
  std::vector<ContactFacet<2>> contact;
  for (const auto& [node, edge] : along) contact.push_back(edge);
  return contact;
}

void put_tractions(const std::vector<ContactFacet<2>>& contact,
                   const EdgeMoments& moments, ContactDensities& densities) {
  for (const ContactFacet<2>& edge : contact)
    set_end_values(densities, edge.index,
                   traction_on<2>(edge, moments).reshaped());
}

}  // namespace ffcontact
