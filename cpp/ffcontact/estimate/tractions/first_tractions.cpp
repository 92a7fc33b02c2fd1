// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/first_tractions.hpp"

#include <cmath>
#include <utility>

#include "ffcontact/base/over.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/checks/sliding_motions.hpp"
#include "ffcontact/elastic/multigrid/multigrid_inverse.hpp"
#include "ffcontact/equilibrium/stress/cell_geometry.hpp"
#include "ffcontact/equilibrium/tractions/equilibrated_moments.hpp"
#include "ffcontact/equilibrium/tractions/free_springs.hpp"
#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"
#include "ffcontact/equilibrium/tractions/tree_sweep.hpp"
#include "ffcontact/estimate/tractions/balanced_stresses.hpp"
#include "ffcontact/estimate/tractions/imbalance_cause.hpp"

namespace ffcontact {

namespace {

template <int d>
CellStresses<d> computed_stresses(const SolvedProblem<d>& solved,
                                  const StressTerms& terms) {
  const SimplexMesh<d>& mesh = solved.topology.mesh;
  CellStresses<d> stress =
      total_stresses(mesh, solved.body, solved.body.displacement).mean;
  if (terms.unstressed) stress.setZero();
  return stress;
}

template <int d>
double longest_side(const SimplexMesh<d>& mesh) {
  return largest_over(mesh.cell_count(), [&](int t) {
    return piola_matrix<d>(corners_of(mesh, t)).colwise().norm().maxCoeff();
  });
}

/// @param without_contact  what the stresses of u_h lack beside the given loads
/// @throws std::invalid_argument  if the multipliers do not make up for it, with the cause
template <int d>
void require_loads_of_solution(const SolvedProblem<d>& solved,
                               const NodalResidual<d>& without_contact,
                               double stress_terms) {
  const SimplexMesh<d>& mesh = solved.topology.mesh;
  const double measure = std::pow(longest_side(mesh), d - 1);
  try {
    require_balanced(mesh,
                     with_forces(without_contact, computed_forces(solved)),
                     least_part_of_terms * stress_terms * measure);
  } catch (const Imbalance& imbalance) {
    refuse(imbalance.what(), ", ",
           cause_of(imbalance, solved, without_contact));
  }
}

/// Names the vertex on which most of the contact force stands.
template <int d>
[[noreturn]] void refuse_unheld(const SolvedProblem<d>& solved) {
  Index dof;
  computed_forces(solved).cwiseAbs().maxCoeff(&dof);
  const int v = static_cast<int>(dof / d);
  refuse(
      "no tractions in the cone have the resultant and the moment of the "
      "loads; most of the contact force acts at vertex ",
      v, " ", in_words(solved.topology.mesh.place(v)),
      ", as where a body stands on one ",
      d == 2 ? "end of its line" : "edge of its contact surface",
      "; hold it otherwise, or let the ", d == 2 ? "line" : "surface",
      " go on there");
}

/// Those that stresses have to balance.
template <int d>
FacetTractions<d> balanced_boundary(const MatchedBodies<d>& bodies,
                                    const ContactTractions<d>& contact) {
  if constexpr (d == 2)
    return bodies.boundary_with(contact.balanced);
  else
    return bodies.boundary_with(contact.densities);
}

/// What the stresses lack beside all loads and r_hat, which acts in the plane by its forces at
/// the nodes, in space by its moments on the faces.
template <int d>
NodalResidual<d> residual_with(const SolvedProblem<d>& solved,
                               const MatchedBodies<d>& bodies,
                               const ContactTractions<d>& contact,
                               const CellStresses<d>& stress,
                               NodalResidual<d> without_contact) {
  if constexpr (d == 2)
    return with_forces(std::move(without_contact),
                       bodies.solved_forces(contact.balanced));
  else
    return nodal_residual(solved.topology, stress, solved.body.body_loads,
                          bodies.boundary_with(contact.densities));
}

/// Rigid motions, and what contact forces must do along them to balance the loads.
template <int d>
HeldMotions held_motions(const SolvedProblem<d>& solved,
                         const NodalResidual<d>& loads,
                         const MatrixXd& motions) {
  return {motions, -motions.transpose() * loads.missing.reshaped(),
          motions.transpose() * computed_forces(solved)};
}

/// r_hat, and loads against the noise of what it and the given loads do along sliding motions.
template <int d>
FirstTractions<d> tractions_in_cone(const SolvedProblem<d>& solved,
                                    const MatchedBodies<d>& bodies,
                                    const RigidMotions& motions,
                                    const FacetTractions<d>& without_contact,
                                    const EstimateSettings<d>& settings,
                                    const Ref<const VectorXd>& u_hat) {
  const auto that_hold = [&](const HeldMotions& held) -> FirstTractions<d> {
    auto found = contact_tractions(solved, bodies, held, settings, u_hat);
    if (!found) refuse_unheld(solved);
    return {*std::move(found), {}};
  };
  if (motions.none()) return that_hold({motions.others, {}, {}});
  const SimplexMesh<d>& mesh = solved.topology.mesh;
  const CellStresses<d> no_stress =
      CellStresses<d>::Zero(voigt_size<d>, mesh.cell_count());
  const NodalResidual<d> loads = nodal_residual(
      solved.topology, no_stress, solved.body.body_loads, without_contact);
  FirstTractions<d> first =
      that_hold(held_motions(solved, loads, motions.others));
  if (motions.sliding.cols() == 0) return first;
  const NodalResidual<d> outer =
      residual_with(solved, bodies, first.contact, no_stress, loads);
  const VectorXd forces = outer.missing.reshaped();
  if (!is_noise(forces, motions.sliding))
    return that_hold(held_motions(solved, loads, motions.all()));
  first.holding = holding_loads(mesh, motions.sliding, forces);
  return first;
}

/// Residual of u* by multigrid, of the largest moment: tractions that make up for it change e
/// by some 1e-7 of it.
constexpr double enough_by_multigrid = 1e-6;

/// Is that faster than a factor, which is not at hand?
template <int d>
bool multigrid_pays(const SolvedProblem<d>& solved) {
  return d == 3 && !solved.body.stiffness &&
         free_dof_count(solved.system) >= multigrid_pays_from;
}

/// @param enough  residual of u* that may be left by multigrid [N]
template <int d>
Rebalancing rebalancing_of(const SolvedProblem<d>& solved,
                           const MatrixXd& motions, double enough) {
  const ElasticSystem& system = solved.system;
  const std::vector<int> contact_dofs =
      free_dofs_at(contact_vertices(solved.contact), system);
  if constexpr (d == 3)
    if (multigrid_pays(solved))
      return {system, contact_dofs, motions,
              multigrid_inverse(system, solved.topology.mesh.vertices), enough};
  return {system, contact_dofs, motions, solved.body.stiffness};
}

/// What cells lack where stresses are balanced by less than rounding supports take, and
/// springs where there are none.
template <int d>
void put_in_balance(MatchedBodies<d>& bodies, const FacetTractions<d>& boundary,
                    const Ref<const VectorXd>& u_hat,
                    FacetColumns<d>& moments) {
  const Topology<d>& topology = bodies.topology();
  const SolvedBody<d>& body = bodies.body();
  const std::vector<FreeSpring<d>> springs =
      free_springs<d>(topology.mesh, topology.facets, body.springs, boundary,
                      u_hat, bodies.spring_tractions());
  sweep_to_roots<d>(topology, body.body_loads, boundary, springs, moments);
  add_spring_changes<d>(topology.mesh, topology.facets, springs, boundary,
                        moments, bodies.spring_tractions());
}

}  // namespace

template <int d>
FirstTractions<d> first_tractions(const SolvedProblem<d>& solved,
                                  MatchedBodies<d>& bodies,
                                  const StressTerms& terms,
                                  const EstimateSettings<d>& settings,
                                  const Ref<const VectorXd>& u_hat) {
  const auto& [topology, contact, system, body] = solved;
  const CellStresses<d> computed = computed_stresses(solved, terms);
  const FacetTractions<d> boundary_without =
      bodies.solved_boundary_without_contact();
  NodalResidual<d> without =
      nodal_residual(topology, computed, body.body_loads, boundary_without);
  require_loads_of_solution(solved, without, terms.stress);
  const RigidMotions motions =
      rigid_motions(topology.mesh, contact, body.law, system);
  FirstTractions<d> first = tractions_in_cone(
      solved, bodies, motions, boundary_without, settings, u_hat);
  if (first.holding.cols() > 0) return first;
  ContactTractions<d>& tractions = first.contact;
  if constexpr (d == 3)
    tractions.beside = boundary_without.moments(Eigen::all, contact.face);

  NodalResidual<d> residual =
      residual_with(solved, bodies, tractions, computed, std::move(without));
  const double wanted = multigrid_pays(solved) ? enough_by_multigrid : balanced;
  const auto rebalancing = [&, enough = wanted * residual.scale] {
    return rebalancing_of(solved, motions.all(), enough);
  };
  const auto [stress, to_rounding] = balanced_stresses<d>(
      wanted, topology, body.hooke, std::move(residual), computed, rebalancing,
      body.springs,
      [&](const FacetColumns<d>& answers) { bodies.add_to_springs(answers); });
  const FacetTractions<d> boundary = balanced_boundary(bodies, tractions);
  first.moments =
      bodies.moments(equilibrated_moments(topology, stress, body.body_loads,
                                          bodies.solved_boundary(boundary)),
                     stress, boundary);
  if (!to_rounding) put_in_balance(bodies, boundary, u_hat, first.moments);
  return first;
}

template FirstTractions<FFCONTACT_DIMENSION> first_tractions(
    const SolvedProblem<FFCONTACT_DIMENSION>&,
    MatchedBodies<FFCONTACT_DIMENSION>&, const StressTerms&,
    const EstimateSettings<FFCONTACT_DIMENSION>&, const Ref<const VectorXd>&);

}  // namespace ffcontact
