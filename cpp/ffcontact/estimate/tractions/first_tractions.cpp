// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/first_tractions.hpp"

#include <algorithm>
#include <optional>

#include "ffcontact/base/appended.hpp"
#include "ffcontact/base/over.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/checks/balance.hpp"
#include "ffcontact/contact/condensed/condensed_contact.hpp"
#include "ffcontact/contact/law/held_rows.hpp"
#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/equilibrium/tractions/equilibrated_moments.hpp"
#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"
#include "ffcontact/estimate/bodies/boundary_moments.hpp"
#include "ffcontact/estimate/bodies/total_stresses.hpp"
#include "ffcontact/estimate/tractions/balanced_stresses.hpp"
#include "ffcontact/estimate/tractions/imbalance_cause.hpp"
#include "ffcontact/estimate/tractions/nearest_in_cone.hpp"
#include "ffcontact/estimate/tractions/published_tractions.hpp"
#include "ffcontact/estimate/tractions/tool_work.hpp"
#include "ffcontact/interface/nodal_force.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

Matrix3Xd computed_stresses(const SolvedProblem<2>& solved,
                            const StressTerms& terms) {
  const Mesh& mesh = solved.topology.mesh;
  if (terms.unstressed) return Matrix3Xd::Zero(3, mesh.cell_count());
  return total_stresses(mesh, solved.body, solved.body.displacement).mean;
}

double longest_edge(const Topology<2>& topology) {
  return largest_over(topology.facets.count(), [&](int e) {
    return edge_vector(topology.mesh, topology.facets, e).norm();
  });
}

/// The script's tractions and those of the springs; on the contact line, where all components count as known, those
/// of contact are left out.
BoundaryTractions tractions_without_contact(const SolvedProblem<2>& solved) {
  const auto& [topology, line, system, body] = solved;
  const Matrix2Xd zero = Matrix2Xd::Zero(2, line.edge_count());
  return boundary_tractions(topology.mesh, topology.facets, system.prescribed,
                            boundary_moments<2>(topology.mesh, body), line,
                            {zero, zero});
}

/// Forces of lambda_h on all dofs.
VectorXd computed_forces(const SolvedProblem<2>& solved) {
  const auto& [topology, line, system, body] = solved;
  return nodal_load(line,
                    without<Matrix2Xd>(held_rows(line, system.prescribed),
                                       forces_of(line, body.multipliers)),
                    system.dof_count());
}

/// What the stresses of u_h lack beside the given loads; contact tractions are not among
/// these.
/// @throws std::invalid_argument  if lambda_h does not make up for it, with the cause
NodalResidual<2> residual_without_contact(const SolvedProblem<2>& solved,
                                          const StressTerms& terms,
                                          const Matrix3Xd& stress) {
  const auto& [topology, line, system, body] = solved;
  const NodalResidual<2> residual = nodal_residual(
      topology, stress, body.body_loads, tractions_without_contact(solved));
  try {
    require_balanced(
        topology.mesh, with_forces(residual, computed_forces(solved)),
        least_part_of_terms * terms.stress * longest_edge(topology));
  } catch (const Imbalance& imbalance) {
    refuse(imbalance.what(), ", ", cause_of(imbalance, solved));
  }
  return residual;
}

/// The node on which most of the contact force stands.
[[noreturn]] void refuse_unheld(const SolvedProblem<2>& solved) {
  Index node;
  const Matrix2Xd forces = forces_of(solved.contact, solved.body.multipliers);
  forces.colwise().norm().maxCoeff(&node);
  const int v = solved.contact.vertex[node];
  refuse(
      "no tractions in the cone have the resultant and the moment of the "
      "loads; most of the contact force acts at vertex ",
      v, " ", in_words(solved.topology.mesh.place(v)),
      ", as where a body stands on one end of its line; hold it otherwise, or "
      "let the line go on there");
}

/// (4.1) alone: the shift of an edge has neither resultant nor moment, so that stresses
/// that balance lambda_h balance r_hat.
ContactTractions tractions_as_published(const MatchedBodies& bodies) {
  const SolvedBody<2>& body = bodies.body();
  const ContactDensities computed =
      edge_densities(bodies.line(), body.multipliers);
  const ConeCorrection correction = published_tractions(
      bodies.topology().mesh, bodies.line(), body.law, computed);
  return {correction.densities, computed, correction.shift,
          correction.uncorrected};
}

/// What contact forces must do along rigid motions to balance the loads [k].
VectorXd resultants_of_loads(const SolvedProblem<2>& solved,
                             const MatrixXd& motions) {
  const auto& [topology, line, system, body] = solved;
  const Matrix3Xd no_stress = Matrix3Xd::Zero(3, topology.mesh.cell_count());
  const NodalResidual<2> loads = nodal_residual(
      topology, no_stress, body.body_loads, tractions_without_contact(solved));
  return -motions.transpose() * loads.missing.reshaped();
}

/// The rigid motions that contact alone holds, or moves a tool by, and what it must do
/// along them [k].
struct HeldMotions {
  MatrixXd fields;     ///< on the matched bodies
  VectorXd of_loads;   ///< that balances the loads, or pushes the tool
  VectorXd of_forces;  ///< that the contact forces of u_h do

  void add(const HeldMotions& more) {
    append(more.fields, fields);
    append(more.of_loads, of_loads);
    append(more.of_forces, of_forces);
  }
};

HeldMotions motions_of_tool(const SolvedProblem<2>& solved) {
  const ToolWork tool =
      tool_work(solved.topology.mesh, solved.contact, solved.body);
  return {tool.fields, tool.work,
          tool.fields.transpose() * computed_forces(solved)};
}

HeldMotions held_motions(const SolvedProblem<2>& solved,
                         const MatchedBodies& bodies, const MatrixXd& motions) {
  if (motions.cols() == 0)
    return {bodies.fields(motions), VectorXd(0), VectorXd(0)};
  return {bodies.fields(motions), resultants_of_loads(solved, motions),
          motions.transpose() * computed_forces(solved)};
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
                                   const ContactLaw& law,
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
VectorXd stiffness_at_edges(const MatchedBodies& bodies) {
  const ContactLine& line = bodies.line();
  const Edges& edges = bodies.topology().facets;
  return VectorXd::NullaryExpr(line.edge_count(), [&](Index e) {
    return max_norm(bodies.body().hooke[edges.cells(0, line.edge[e])]) /
           bodies.solved_length(static_cast<int>(e));
  });
}

/// r_hat linear between the nodal pressures p_i = F_i / len_i: the forces obey the law,
/// so that p is in the cone, and has their resultant. Where the law varies along an edge,
/// or where rigid motions are held by contact alone and int z . r must be what balances
/// the loads along them, it is the density in the cone nearest to that
/// (nearest_in_cone). On the boundary of what the cone allows there may be but one, which
/// is found from lambda_h rather than from p. Edges carry what does not cost far more than
/// it gains (carrying_edges), all of the cone where no such tractions hold the body.
ContactTractions tractions_in_cone(const SolvedProblem<2>& solved,
                                   const MatchedBodies& bodies,
                                   const MatrixXd& motions,
                                   const Ref<const VectorXd>& u_hat) {
  const SolvedBody<2>& body = solved.body;
  const Matrix2Xd p = nodal_pressures(solved);
  HeldMotions held = held_motions(solved, bodies, motions);
  if (body.tool) held.add(motions_of_tool(solved));
  const std::vector<Carrying> carrying =
      carrying_edges(bodies.line(), bodies.body().law, u_hat,
                     stiffness_at_edges(bodies), max_norm(p));
  const auto near = [&](const Matrix2Xd& nodal,
                        const std::vector<Carrying>& edges) {
    return candidate(bodies.line(), bodies.body().law, held,
                     edge_densities(bodies.line(), bodies.nodal_values(nodal)),
                     edges);
  };
  auto best = near(p, carrying);
  for (const Matrix2Xd& nodal : {p, body.multipliers}) {
    if (best && best->off <= rounding_of_terms) break;
    const auto other = near(nodal, {});
    if (other && (!best || other->off < best->off)) best = other;
  }
  if (!best) refuse_unheld(solved);
  return {best->densities, best->densities,
          VectorXd::Zero(bodies.line().edge_count())};
}

}  // namespace

Matrix2Xd nodal_pressures(const SolvedProblem<2>& solved) {
  return lumped_pressures(solved.contact, solved.system.prescribed,
                          forces_of(solved.contact, solved.body.multipliers));
}

FirstTractions first_tractions(const SolvedProblem<2>& solved,
                               MatchedBodies& bodies, const StressTerms& terms,
                               Tractions kind,
                               const Ref<const VectorXd>& u_hat) {
  const Matrix3Xd computed = computed_stresses(solved, terms);
  const MatrixXd motions = unheld_motions(solved.topology.mesh, solved.system);
  const NodalResidual<2> without =
      residual_without_contact(solved, terms, computed);
  ContactTractions contact =
      kind == Tractions::published
          ? tractions_as_published(bodies)
          : tractions_in_cone(solved, bodies, motions, u_hat);

  const Matrix3Xd stress = balanced_stresses(
      solved.topology, solved.body.hooke,
      with_forces(without, bodies.solved_forces(contact.balanced)), computed,
      [&] {
        return Rebalancing(solved.system,
                           contact_dofs(solved.contact, solved.system), motions,
                           solved.body.stiffness);
      },
      solved.body.springs,
      [&](const Matrix4Xd& answers) { bodies.add_to_springs(answers); });
  const BoundaryTractions boundary = bodies.boundary_with(contact.balanced);
  const EdgeMoments on_solved =
      equilibrated_moments(solved.topology, stress, solved.body.body_loads,
                           bodies.solved_boundary(boundary));
  return {std::move(contact), bodies.moments(on_solved, stress, boundary)};
}

}  // namespace ffcontact
