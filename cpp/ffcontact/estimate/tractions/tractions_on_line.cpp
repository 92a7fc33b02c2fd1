// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/law/held_rows.hpp"
#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/estimate/bodies/unstressed.hpp"
#include "ffcontact/estimate/tractions/contact_tractions.hpp"
#include "ffcontact/estimate/tractions/nearest_in_cone.hpp"
#include "ffcontact/estimate/tractions/published_tractions.hpp"
#include "ffcontact/estimate/tractions/tool_work.hpp"
#include "ffcontact/interface/nodal_force.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

template <>
VectorXd computed_forces(const SolvedProblem<2>& solved) {
  const auto& [topology, line, system, body] = solved;
  return nodal_load(line,
                    without<Matrix2Xd>(held_rows(line, system.prescribed),
                                       forces_of(line, body.multipliers)),
                    system.dof_count());
}

namespace {

/// (4.1) alone: the shift of an edge has neither resultant nor moment, so that stresses
/// that balance lambda_h balance r_hat.
ContactTractions<2> tractions_as_published(const MatchedBodies<2>& bodies) {
  const SolvedBody<2>& body = bodies.body();
  const ContactDensities computed =
      edge_densities(bodies.contact(), body.multipliers);
  const ConeCorrection correction = published_tractions(
      bodies.topology().mesh, bodies.contact(), body.law, computed);
  return {correction.densities, computed, correction.shift,
          correction.uncorrected};
}

HeldMotions motions_of_tool(const SolvedProblem<2>& solved) {
  const ToolWork tool =
      tool_work(solved.topology.mesh, solved.contact, solved.body);
  return {tool.fields, tool.work,
          tool.fields.transpose() * computed_forces(solved)};
}

/// Tractions and what of the loads' resultants they miss, relative to their own.
struct Candidate {
  ContactDensities densities;
  double off;
};

double part_missed(const ContactLine& line, const HeldMotions& held,
                   const ContactDensities& r) {
  const VectorXd missed = resultants_of(line, r, held.fields) - held.of_loads;
  const double scale = line.length.sum() * largest_traction(r);
  return relative(missed.norm(), scale);
}

/// Tractions in the cone nearest to given ones, if there are any: with the resultants of
/// the loads, or, where these are on the boundary of what the cone allows and leave it by
/// their rounding, as little as it takes towards those of the contact forces.
std::optional<Candidate> candidate(const ContactLine& line,
                                   const ContactLaw<2>& law,
                                   const HeldMotions& held,
                                   const ContactDensities& near,
                                   const std::vector<Carrying>& carrying) {
  for (const double share : {0.0, 1e-3, 0.03, 1.0}) {
    const VectorXd resultants =
        (1 - share) * held.of_loads + share * held.of_forces;
    const auto r =
        nearest_in_cone(line, law, near, held.fields, resultants, carrying);
    if (r) return Candidate{*r, part_missed(line, held, *r)};
  }
  return std::nullopt;
}

/// The largest of C in the triangle of each contact edge over the length of the solved one
/// [MPa/mm].
VectorXd stiffness_at_edges(const MatchedBodies<2>& bodies) {
  const ContactLine& line = bodies.contact();
  const Edges& edges = bodies.topology().facets;
  return VectorXd::NullaryExpr(line.edge_count(), [&](Index e) {
    return max_norm(bodies.body().hooke[edges.cells(0, line.edge[e])]) /
           bodies.solved_length(static_cast<int>(e));
  });
}

/// On the boundary of what the cone allows there may be but one, which is found from lambda_h
/// rather than from p.
std::optional<ContactDensities> densities_in_cone(
    const SolvedProblem<2>& solved, const MatchedBodies<2>& bodies,
    const HeldMotions& held, const Ref<const VectorXd>& u_hat) {
  const Matrix2Xd p = nodal_pressures(solved);
  const std::vector<Carrying> carrying =
      carrying_edges(bodies.contact(), bodies.body().law, u_hat,
                     stiffness_at_edges(bodies), bodies.nodal_values(p));
  const auto near = [&](const Matrix2Xd& nodal,
                        const std::vector<Carrying>& edges) {
    return candidate(
        bodies.contact(), bodies.body().law, held,
        edge_densities(bodies.contact(), bodies.nodal_values(nodal)), edges);
  };
  auto best = near(p, carrying);
  for (const Matrix2Xd& nodal : {p, solved.body.multipliers}) {
    if (best && best->off <= rounding_of_terms) break;
    const auto other = near(nodal, {});
    if (other && (!best || other->off < best->off)) best = other;
  }
  if (!best) return std::nullopt;
  return best->densities;
}

/// int psi_i n(s) . n_i at each node [mm], its length where directions do not turn.
VectorXd projected_lengths(const ContactLine& line) {
  VectorXd lengths = VectorXd::Zero(line.node_count());
  for (int e = 0; e < line.edge_count(); ++e) {
    const Vector2i nodes = line.edge_node.col(e);
    const double cosine =
        turns(line, e)
            ? line.normal.col(nodes[0]).dot(line.normal.col(nodes[1]))
            : 1;
    for (const int node : nodes)
      lengths[node] += (2 + cosine) / 6 * line.length[e];
  }
  return lengths;
}

}  // namespace

Matrix2Xd nodal_pressures(const SolvedProblem<2>& solved) {
  const ContactLine& line = solved.contact;
  const VectorXd shorter =
      nodal_lengths(line).cwiseQuotient(projected_lengths(line));
  return lumped_pressures(line, solved.system.prescribed,
                          forces_of(line, solved.body.multipliers)) *
         shorter.asDiagonal();
}

template <>
std::optional<ContactTractions<2>> contact_tractions(
    const SolvedProblem<2>& solved, const MatchedBodies<2>& bodies,
    HeldMotions held, const EstimateSettings<2>& settings,
    const Ref<const VectorXd>& u_hat) {
  if (settings.tractions == Tractions::published)
    return tractions_as_published(bodies);
  held.fields = bodies.fields(held.fields);
  if (solved.body.tool) held.add(motions_of_tool(solved));
  const auto r = densities_in_cone(solved, bodies, held, u_hat);
  if (!r) return std::nullopt;
  return ContactTractions<2>{*r, *r, VectorXd::Zero(r->normal.cols())};
}

}  // namespace ffcontact
