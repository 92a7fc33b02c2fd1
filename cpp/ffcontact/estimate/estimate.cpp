// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/estimate.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/friction_cone.hpp"
#include "ffcontact/contact/nodal_pressures.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"
#include "ffcontact/equilibrium/edge_moments.hpp"
#include "ffcontact/equilibrium/nodal_residual.hpp"
#include "ffcontact/estimate/data_defect.hpp"
#include "ffcontact/estimate/matched_bodies.hpp"
#include "ffcontact/estimate/nearest_in_cone.hpp"
#include "ffcontact/estimate/nodal_forces.hpp"
#include "ffcontact/estimate/published_tractions.hpp"
#include "ffcontact/estimate/rebalancing_displacement.hpp"
#include "ffcontact/estimate/stress_norms.hpp"
#include "ffcontact/estimate/unstressed.hpp"

namespace ffcontact {

namespace {

constexpr double equilibrium_tolerance = 1e-10;
constexpr double cone_tolerance = 1e-12;
constexpr double penetration_tolerance = 1e-12;

/// Equilibrium is judged against sigma_hat and the stresses of u_hat, and against this
/// part of the terms that these are summed from.
constexpr double least_part = 1e-4;

/// Solves for the balance of stresses and tractions: one, and one or two for its rounding.
constexpr int most_refinements = 3;

void require_valid(const SolvedProblem& solved, const RelaxationSettings& relaxation) {
  const auto& [topology, line, system, body] = solved;
  const Mesh& mesh = topology.mesh;
  require_elliptic(body.hooke, mesh.cell_count());
  require_size("A", system.dof_count(), 2 * mesh.vertices.cols());
  require_size("u", body.displacement.size(), 2 * mesh.vertices.cols());
  require_finite("u", body.displacement);
  require_size("contact pressures", body.pressure.cols(), line.node_count());
  require_finite("contact pressure", body.pressure.reshaped());
  require_size("body loads", body.body_loads.cols(), mesh.cell_count());
  require_finite("body load", body.body_loads.reshaped());
  require_valid(body.law, line);
  if (relaxation.sweeps < 0)
    refuse("sweeps must not be negative, got ", relaxation.sweeps);
  if (!(relaxation.tightness >= 0 && relaxation.tightness < 1))
    refuse("tightness must be in [0, 1), got ", relaxation.tightness);
}

/// The scale of the stresses' rounding.
struct Terms {
  double stress;    ///< largest_stress_terms of u_h [MPa]
  bool unstressed;  ///< stresses and tractions of u_h are rounding
};

Matrix3Xd computed_stresses(const SolvedProblem& solved, const Terms& terms) {
  const Mesh& mesh = solved.topology.mesh;
  if (terms.unstressed) return Matrix3Xd::Zero(3, mesh.cell_count());
  return stresses(mesh, solved.body.hooke, solved.body.displacement);
}

double largest_value(const std::vector<CompositeStress>& stress) {
  double largest = 0;
  for (const CompositeStress& values : stress)
    largest = std::max(largest, values.cwiseAbs().maxCoeff());
  return largest;
}

/// What sigma_hat and r_hat are compared with: u_hat, or, where u has no stress and
/// slides nowhere, what u_hat differs by from it.
struct Compared {
  VectorXd displacement;
  ContactLaw law;
  Matrix3Xd stress;
};

Compared compared(const MatchedBodies& bodies, const Terms& terms,
                  const VectorXd& u_hat) {
  const SolvedBody& body = bodies.body();
  const Mesh& mesh = bodies.topology().mesh;
  if (!terms.unstressed) return {u_hat, body.law, stresses(mesh, body.hooke, u_hat)};
  Compared change{u_hat - body.displacement, body.law, {}};
  change.law.gap.resize(0);
  change.law.previous.resize(0);
  change.stress = stresses(mesh, body.hooke, change.displacement);
  if (change.stress.cwiseAbs().maxCoeff() <= rounding_of_terms * terms.stress) {
    change.displacement.setZero();
    change.stress.setZero();
  }
  return change;
}

double longest_edge(const Topology& topology) {
  double longest = 0;
  for (int e = 0; e < topology.edges.count(); ++e)
    longest = std::max(longest, edge_vector(topology.mesh, topology.edges, e).norm());
  return longest;
}

/// The script's tractions; none of contact, which are known on its line.
BoundaryTractions given_tractions(const SolvedProblem& solved) {
  const auto& [topology, line, system, body] = solved;
  const Matrix2Xd zero = Matrix2Xd::Zero(2, line.edge_count());
  return boundary_tractions(topology.mesh, topology.edges, system.prescribed,
                            body.neumann, line, {zero, zero});
}

/// Forces of lambda_h on all dofs.
VectorXd computed_forces(const SolvedProblem& solved) {
  const ContactLine& line = solved.line;
  return nodal_forces(solved.topology.mesh, line,
                      edge_densities(line, solved.body.pressure));
}

/// What the stresses of u_h lack beside the given loads; contact tractions are not among
/// these.
/// @throws std::invalid_argument  if lambda_h does not make up for it, with the cause
NodalResidual residual_without_contact(const SolvedProblem& solved, const Terms& terms,
                                       const Matrix3Xd& stress) {
  const auto& [topology, line, system, body] = solved;
  const NodalResidual residual =
      nodal_residual(topology, stress, body.body_loads, given_tractions(solved));
  try {
    require_balanced(topology.mesh, with_forces(residual, computed_forces(solved)),
                     least_part * terms.stress * longest_edge(topology));
  } catch (const Imbalance& imbalance) {
    refuse(imbalance.what(), ", ",
           cause_of(imbalance, topology.mesh, line, system, body));
  }
  return residual;
}

/// The node on which most of the contact force stands.
[[noreturn]] void refuse_unheld(const SolvedProblem& solved) {
  Index node;
  const Matrix2Xd forces = forces_of(solved.line, solved.body.pressure);
  forces.colwise().norm().maxCoeff(&node);
  const int v = solved.line.vertex[node];
  const Vector2d x = solved.topology.mesh.place(v);
  refuse(
      "no tractions in the cone have the resultant and the moment of the loads; most of "
      "the contact force acts at vertex ",
      v, " (", x.x(), ", ", x.y(),
      "), as where a body stands on one end of its line; hold it otherwise, or let the "
      "line go on there");
}

/// Contact tractions r_hat, and those that stresses have to balance.
struct ContactTractions {
  ContactDensities densities, balanced;
  VectorXd shift;               ///< d of (4.1) per edge [MPa]
  std::vector<int> unmended{};  ///< edges that (4.1) leaves outside the cone
};

/// (4.1) alone: the shift of an edge has neither resultant nor moment, so that stresses
/// that balance lambda_h balance r_hat.
ContactTractions tractions_as_published(const MatchedBodies& bodies) {
  const SolvedBody& body = bodies.body();
  const ContactDensities computed = edge_densities(bodies.line(), body.pressure);
  const ConeCorrection correction =
      published_tractions(bodies.topology().mesh, bodies.line(), body.law, computed);
  return {correction.densities, computed, correction.shift, correction.uncorrected};
}

/// What contact forces must do along rigid motions to balance the loads [k].
VectorXd resultants_of_loads(const SolvedProblem& solved, const MatrixXd& motions) {
  const auto& [topology, line, system, body] = solved;
  const Matrix3Xd no_stress = Matrix3Xd::Zero(3, topology.mesh.cell_count());
  const NodalResidual loads =
      nodal_residual(topology, no_stress, body.body_loads, given_tractions(solved));
  return -motions.transpose() * loads.missing.reshaped();
}

/// Tractions and what of the loads' resultants they miss, relative to their own.
struct Candidate {
  ContactDensities densities;
  double off;
};

/// The better one of two, if there is any, of tractions in the cone nearest to given
/// ones: with the resultants of the loads, or, where these are on the boundary of what
/// the cone allows and leave it by their rounding, of the contact forces.
std::optional<Candidate> candidate(const SolvedProblem& solved,
                                   const MatchedBodies& bodies, const MatrixXd& motions,
                                   const ContactDensities& near) {
  const ContactLine& line = bodies.line();
  const MatrixXd fields = bodies.fields(motions);
  const VectorXd of_loads = resultants_of_loads(solved, motions);
  const VectorXd of_forces = motions.transpose() * computed_forces(solved);
  for (const VectorXd& resultants : {of_loads, of_forces}) {
    const auto r = nearest_in_cone(line, bodies.body().law, near, fields, resultants);
    if (!r) continue;
    const VectorXd missed = resultants_of(line, *r, fields) - of_loads;
    const double scale = line.length.sum() * largest_traction(*r);
    return Candidate{*r, scale > 0 ? missed.norm() / scale : 0};
  }
  return std::nullopt;
}

/// r_hat linear between the nodal pressures p_i = F_i / len_i: the forces obey the law,
/// so that p is in the cone, and has their resultant. Where the law varies along an edge,
/// or where rigid motions are held by contact alone and int z . r must be what balances
/// the loads along them, it is the density in the cone nearest to that
/// (nearest_in_cone). On the boundary of what the cone allows there may be but one, which
/// is found from lambda_h rather than from p.
ContactTractions tractions_in_cone(const SolvedProblem& solved,
                                   const MatchedBodies& bodies, const MatrixXd& motions) {
  const SolvedBody& body = solved.body;
  const Matrix2Xd p = lumped_pressures(solved.line, solved.system.prescribed,
                                       forces_of(solved.line, body.pressure));
  const auto near = [&](const Matrix2Xd& nodal) {
    return candidate(solved, bodies, motions,
                     edge_densities(bodies.line(), bodies.nodal_values(nodal)));
  };
  auto best = near(p);
  if (!best || best->off > rounding_of_terms) {
    const auto other = near(body.pressure);
    if (other && (!best || other->off < best->off)) best = other;
  }
  if (!best) refuse_unheld(solved);
  return {best->densities, best->densities, VectorXd::Zero(bodies.line().edge_count())};
}

double largest_missing(const NodalResidual& residual) {
  return residual.missing.cwiseAbs().maxCoeff();
}

/// Stresses of the displacement that makes up for a residual.
Matrix3Xd balancing_stresses(const SolvedProblem& solved, const MatrixXd& motions,
                             const NodalResidual& residual) {
  const auto& [topology, line, system, body] = solved;
  const VectorXd forces = residual.missing.reshaped();
  const VectorXd u =
      body.stiffness
          ? rebalancing_displacement(*body.stiffness, system, line, forces, motions)
          : rebalancing_displacement(system, line, forces, motions);
  return stresses(topology.mesh, body.hooke, u);
}

/// Stresses in equilibrium with the loads and with contact tractions: those of u_h, and
/// of the small displacement that makes up for what they lack; its own rounding once
/// more.
/// @param forces  of the contact tractions on all dofs
Matrix3Xd balanced_stresses(const SolvedProblem& solved, const MatrixXd& motions,
                            const NodalResidual& without_contact, const VectorXd& forces,
                            Matrix3Xd stress) {
  NodalResidual residual = with_forces(without_contact, forces);
  for (int step = 0; step < most_refinements; ++step) {
    const double missing = largest_missing(residual);
    if (missing <= rounding_of_terms * residual.scale) break;
    const Matrix3Xd added = balancing_stresses(solved, motions, residual);
    residual = less_stress(solved.topology, residual, added);
    if (step > 0 && largest_missing(residual) >= missing) break;
    stress += added;
  }
  return stress;
}

/// r_hat before the relaxation, and edge tractions in equilibrium with it on every
/// triangle of the matched bodies.
struct FirstTractions {
  ContactTractions contact;
  EdgeMoments moments;
};

FirstTractions first_tractions(const SolvedProblem& solved, const MatchedBodies& bodies,
                               const Terms& terms, Tractions kind) {
  const Matrix3Xd computed = computed_stresses(solved, terms);
  const MatrixXd motions =
      free_rigid_motions(solved.topology.mesh, solved.system.prescribed);
  const NodalResidual without = residual_without_contact(solved, terms, computed);
  ContactTractions contact = kind == Tractions::published
                                 ? tractions_as_published(bodies)
                                 : tractions_in_cone(solved, bodies, motions);

  const Matrix3Xd stress = balanced_stresses(
      solved, motions, without, bodies.solved_forces(contact.balanced), computed);
  const BoundaryTractions boundary = bodies.boundary_with(contact.balanced);
  const EdgeMoments on_solved = equilibrated_moments(
      solved.topology, stress, solved.body.body_loads, bodies.solved_boundary(boundary));
  return {std::move(contact), bodies.moments(on_solved, stress, boundary)};
}

/// Relaxation leaves tractions outside of the cone by its rounding; inside they unbalance
/// the stresses by as little.
void clamp_rounding(const ContactLine& line, const ContactLaw& law,
                    ContactDensities& densities) {
  for (int e = 0; e < line.edge_count(); ++e)
    set_end_values(densities, e, clamped_to_cone(line, law, e, end_values(densities, e)));
}

/// sigma_hat and r_hat: by its edge loads less those of the compared stress.
struct RelaxedTractions {
  EdgeLoadsOfAll difference;
  ContactDensities contact;
  std::vector<double> falls;  ///< of e^2, sweep by sweep
};

RelaxedTractions relaxed(const MatchedBodies& bodies, const Compared& compared,
                         const FirstTractions& first, const EstimateSettings& settings,
                         bool contact_is_free) {
  const auto& [mesh, edges, stars] = bodies.topology();
  const ContactLine& line = bodies.line();
  const SolvedBody& body = bodies.body();
  const BoundaryTractions boundary = bodies.boundary_with(first.contact.densities);
  const std::vector<int> contact_edge = contact_edge_numbers(line, edges);
  EdgeMoments moments = first.moments;
  for (int e = 0; e < edges.count(); ++e)
    if (contact_edge[e] >= 0) moments.col(e) = boundary.moments.col(e);

  RelaxedTractions result{
      difference_loads(mesh, edges, moments, compared.stress), {}, {}};
  const TractionCosts costs =
      traction_costs(line, compared.law, first.contact.densities, compared.displacement);
  FreeTractions tractions{first.contact.densities, costs.normal, costs.tangential,
                          contact_edge};
  FreeContact contact{line, body.law, tractions};
  result.falls = relax_stars(bodies.topology(), body.hooke, boundary, body.body_loads,
                             settings.relaxation, result.difference,
                             contact_is_free ? &contact : nullptr);
  result.contact = std::move(tractions.densities);
  if (settings.tractions != Tractions::published)
    clamp_rounding(line, body.law, result.contact);
  return result;
}

/// e after every sweep from the last square and what every sweep took off.
std::vector<double> error_history(double last_square, const std::vector<double>& falls) {
  std::vector<double> squares(falls.size() + 1, last_square);
  for (std::size_t k = falls.size(); k > 0; --k)
    squares[k - 1] = squares[k] + falls[k - 1];
  for (double& square : squares) square = std::sqrt(std::max(0.0, square));
  return squares;
}

/// Adds the contact part of each edge to its triangle, or half of it to each of the two
/// that face each other there.
void share_contact_part(const Edges& edges, const ContactLine& line,
                        const VectorXd& contact_part, VectorXd& local) {
  for (int e = 0; e < line.edge_count(); ++e) {
    const int opposite = line.against_a_body() ? line.opposite_edge[e] : -1;
    local[edges.cells(0, line.edge[e])] += (opposite < 0 ? 1 : 0.5) * contact_part[e];
    if (opposite >= 0) local[edges.cells(0, opposite)] += 0.5 * contact_part[e];
  }
}

/// e and its parts.
void put_error(const MatchedBodies& bodies, const Compared& compared,
               const RelaxedTractions& relaxed, Construction construction,
               Estimate& estimate) {
  const Topology& topology = bodies.topology();
  const SolvedBody& body = bodies.body();
  const VectorXd contact_part =
      contact_error(bodies.line(), compared.law, relaxed.contact, compared.displacement);
  estimate.contact = contact_part.sum();

  const auto norms_by = [&](auto construct) {
    return construct(topology.mesh, body.hooke, compared.stress, relaxed.difference,
                     body.body_loads);
  };
  StressNorms norms = norms_by(composite_norms);
  estimate.history =
      error_history(norms.difference.sum() + estimate.contact, relaxed.falls);
  if (construction == Construction::polynomial) norms = norms_by(polynomial_norms);

  estimate.elastic = std::sqrt(norms.difference.sum());
  estimate.e = std::sqrt(std::max(0.0, norms.difference.sum() + estimate.contact));
  const double scale = norms.sum > 0 ? norms.sum : 1;
  estimate.relative = estimate.e / std::sqrt(scale);
  VectorXd local = norms.difference;
  share_contact_part(topology.edges, bodies.line(), contact_part, local);
  estimate.local = (bodies.sums_of_parts(local) / scale).cwiseMax(0.0).cwiseSqrt();
  estimate.stress = std::move(norms.stress);
}

/// Contact tractions beside the largest stress: makes what is relative to the former
/// relative to the latter, where an open contact line carries nothing but rounding.
double share_of_contact(const ContactDensities& densities, const Matrix3Xd& stress) {
  const double contact = std::max(densities.normal.cwiseAbs().maxCoeff(),
                                  densities.tangential.cwiseAbs().maxCoeff());
  return contact > 0 ? contact / std::max(contact, stress.cwiseAbs().maxCoeff()) : 0;
}

std::string in_digits(double value) {
  std::ostringstream text;
  text << std::setprecision(2) << value;
  return text.str();
}

/// Why a pair is not admissible; nothing if it is.
std::string reason_against(const Estimate& estimate, Construction construction,
                           const Vector2d& deepest) {
  if (estimate.penetration > penetration_tolerance)
    return "u penetrates by " + in_digits(estimate.penetration) +
           " of the largest displacement at (" + in_digits(deepest.x()) + ", " +
           in_digits(deepest.y()) + "), where displacements are prescribed";
  if (estimate.cone > cone_tolerance) {
    const auto edges = estimate.unmended.size();
    return "contact tractions leave the friction cone by " + in_digits(estimate.cone) +
           " of the largest stress" +
           (edges == 0 ? "" : ": (4.1) cannot mend " + std::to_string(edges) + " edges");
  }
  if (construction == Construction::polynomial)
    return "the polynomial construction is in equilibrium in the mean only: its "
           "tractions jump by " +
           in_digits(estimate.equilibrium.jump) + " of the largest";
  if (estimate.equilibrium.largest() > equilibrium_tolerance)
    return "the stress is out of equilibrium by " +
           in_digits(estimate.equilibrium.largest()) + " of the largest traction";
  return {};
}

/// What the theory promises, measured.
void judge(const MatchedBodies& bodies, const Compared& compared,
           Construction construction, Estimate& estimate) {
  const auto& [mesh, edges, stars] = bodies.topology();
  const ContactLine& line = bodies.line();
  const SolvedBody& body = bodies.body();
  const VectorXd& u_hat = estimate.displacement;
  const double terms = largest_stress_terms(bodies.topology(), line, body, u_hat);
  const double least = std::max({compared.stress.cwiseAbs().maxCoeff(),
                                 largest_value(estimate.stress), least_part * terms});
  estimate.equilibrium =
      equilibrium_defect(mesh, edges, estimate.stress, body.body_loads,
                         bodies.boundary_with(estimate.tractions), least);
  estimate.cone = cone_defect(line, body.law, estimate.tractions) *
                  share_of_contact(estimate.tractions, compared.stress);
  const PenetrationDefect penetration = penetration_defect(line, body.law, u_hat);
  estimate.penetration = penetration.value;
  const Vector2d deepest = mesh.place(line.vertex[penetration.node]);
  estimate.reason = reason_against(estimate, construction, deepest);
  estimate.admissible = estimate.reason.empty();
}

/// Steps 1 to 6 of the estimate.
Estimate estimate_of(const SolvedProblem& solved, const Terms& terms,
                     const EstimateSettings& settings) {
  // Facing traces that match, by cutting where they do not.
  MatchedBodies bodies(solved);
  Estimate estimate;

  // 1. Admissible displacement [CHH01, 4.1].
  estimate.displacement = admissible_displacement(
      bodies.line(), bodies.body().law, bodies.body().displacement, bodies.prescribed());
  const Compared u_hat = compared(bodies, terms, estimate.displacement);

  // 2., 3. Contact tractions in the cone, edge tractions in equilibrium with them.
  const FirstTractions first = first_tractions(solved, bodies, terms, settings.tractions);
  estimate.shift = first.contact.shift;
  estimate.unmended = first.contact.unmended;

  // 4. Star relaxation of sigma_hat - C eps(u_hat), and of r_hat in the cone.
  RelaxedTractions tractions =
      relaxed(bodies, u_hat, first, settings,
              settings.tractions == Tractions::free && !terms.unstressed);

  // 5. The error and its parts [CHH01, (2.11)-(2.13)].
  put_error(bodies, u_hat, tractions, settings.construction, estimate);
  estimate.tractions = std::move(tractions.contact);
  if (terms.unstressed)  // to the last digit: above it is what u_hat - u leaves
    for (CompositeStress& zero : estimate.stress) zero.setZero();

  // 6. What the theory promises, measured.
  judge(bodies, u_hat, settings.construction, estimate);
  estimate.refinement = bodies.take_refinement();
  return estimate;
}

}  // namespace

Estimate estimate_error(const Topology& topology, const ContactLine& line,
                        const ElasticSystem& system, const SolvedBody& body,
                        const EstimateSettings& settings) {
  const SolvedProblem solved{topology, line, system, body};
  require_valid(solved, settings.relaxation);
  require_law_of_matrix(topology.mesh, system, body.hooke);
  const double stress_terms =
      largest_stress_terms(topology, line, body, body.displacement);
  if (!is_unstressed(topology, line, system.prescribed, body, stress_terms))
    return estimate_of(solved, {stress_terms, false}, settings);
  SolvedBody unstressed = body;
  unstressed.pressure.setZero();
  return estimate_of({topology, line, system, unstressed}, {stress_terms, true},
                     settings);
}

}  // namespace ffcontact
