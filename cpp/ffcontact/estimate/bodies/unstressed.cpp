// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/unstressed.hpp"

#include <algorithm>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/elastic/stress_terms.hpp"
#include "ffcontact/estimate/bodies/boundary_moments.hpp"
#include "ffcontact/estimate/bodies/total_stresses.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// What a displacement of the length `given` along each contact edge would stress on
/// either side.
double terms_along_line(const Edges& edges, const ContactLine& line,
                        const Hooke& hooke, double given) {
  double largest = 0;
  const auto count = [&](int edge, int e) {
    const double stiffness = max_norm(hooke[edges.cells(0, edge)]);
    largest = std::max(largest, stiffness * given / line.length[e]);
  };
  for (int e = 0; e < line.edge_count(); ++e) count(line.edge[e], e);
  for (const FacingPiece& piece : line.pieces)
    count(piece.opposite_edge, piece.contact_edge);
  return largest;
}

/// Does a node slide against Tresca's friction? Then stresses are not rounding, however
/// small.
bool slides(const ContactLine& line, const SolvedBody<2>& body) {
  if (!body.law.tresca()) return false;
  const VectorXd& bound = body.law.slip_bound;
  const VectorXd slip =
      displacement_against_foundation(line, body.law, body.displacement).row(1);
  const double least =
      rounding_of_terms * largest_displacement(body.law, body.displacement);
  return (slip.cwiseProduct(bound).array().abs() > least * bound.array()).any();
}

}  // namespace

double largest_stress_terms(const Topology<2>& topology,
                            const ContactLine& line, const SolvedBody<2>& body,
                            const VectorXd& displacement) {
  const auto& [mesh, edges, ridges, stars] = topology;
  const double given = std::max(
      terms_along_line(edges, line, body.hooke, largest_given(body.law)),
      body.initial.bound());
  return std::max(given, largest_stress_terms(mesh, body.hooke, displacement));
}

bool is_unstressed(const Topology<2>& topology, const ContactLine& line,
                   const Flags& prescribed, const SolvedBody<2>& body,
                   double stress_terms) {
  if (has_loads(topology, prescribed, body)) return false;
  const double stress =
      total_stresses(topology.mesh, body, body.displacement).bound();
  const double traction = max_norm(body.multipliers);
  return std::max(stress, traction) <= rounding_of_terms * stress_terms &&
         !slides(line, body);
}

}  // namespace ffcontact
