// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/first_surface_tractions.hpp"

#include <algorithm>

#include "ffcontact/base/over.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/checks/balance.hpp"
#include "ffcontact/equilibrium/stress/cell_geometry.hpp"
#include "ffcontact/equilibrium/tractions/equilibrated_moments.hpp"
#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"
#include "ffcontact/estimate/bodies/unstressed.hpp"
#include "ffcontact/estimate/tractions/balanced_stresses.hpp"
#include "ffcontact/estimate/tractions/missing_loads.hpp"
#include "ffcontact/estimate/tractions/reaction.hpp"
#include "ffcontact/estimate/tractions/surface_tractions.hpp"

namespace ffcontact {

namespace {

/// The script's tractions and the springs'; on the contact surface, where all components count as known,
/// those of contact are left out.
FaceTractions tractions_without_contact(const SolvedProblem<3>& solved,
                                        const FaceMoments& springs) {
  return boundary_with(solved, springs,
                       Matrix3Xd::Zero(3, solved.contact.node_count()));
}

/// Why the stresses of u_h are not in equilibrium with the loads at a vertex.
std::string cause_at(const Imbalance& imbalance,
                     const SolvedProblem<3>& solved) {
  const auto& [topology, surface, system, body] = solved;
  const std::string reaction =
      reaction_in_words<3>(imbalance, system, topology.facets, surface.face);
  if (!reaction.empty()) return reaction;
  const std::vector<int> contact = contact_vertices(surface);
  const bool in_contact = std::find(contact.begin(), contact.end(),
                                    imbalance.vertex) != contact.end();
  return missing_loads(topology.mesh, imbalance.vertex,
                       in_contact ? "on the contact surface: give the forces "
                                    "of the solution u, and the same label= "
                                    "and traction="
                                  : "");
}

double longest_side(const SolidMesh& mesh) {
  return largest_over(mesh.cell_count(), [&](int t) {
    return piola_matrix<3>(corners_of(mesh, t)).colwise().norm().maxCoeff();
  });
}

/// @throws std::invalid_argument  if the stresses of u_h are not in equilibrium with loads
///                                and nodal forces, with the cause
void require_loads_of_solution(const SolvedProblem<3>& solved,
                               const NodalResidual<3>& without_contact,
                               double stress_terms) {
  const auto& [topology, surface, system, body] = solved;
  const double side = longest_side(topology.mesh);
  try {
    require_balanced(
        topology.mesh,
        with_forces(without_contact,
                    nodal_load(surface, body.multipliers, system.dof_count())),
        least_part_of_terms * stress_terms * side * side);
  } catch (const Imbalance& imbalance) {
    refuse(imbalance.what(), ", ", cause_at(imbalance, solved));
  }
}

/// Contact forces that balance the loads along rigid motions, or those of u_h along them,
/// which differ by rounding.
[[noreturn]] void refuse_unheld_solid() {
  refuse(
      "no tractions in the cone have the resultant and the moment of the "
      "loads, as where a body stands on one edge of its contact surface; hold "
      "it otherwise, or let the surface go on there");
}

/// r_hat: F_i / A_i, continued to nodes that a support holds on a rigid foundation, moved
/// inside the cone where contact alone holds rigid motions.
Matrix3Xd tractions_in_cone(const SolvedProblem<3>& solved,
                            const FaceTractions& without_contact,
                            const MatrixXd& motions) {
  const auto& [topology, surface, system, body] = solved;
  Matrix3Xd lumped = lumped_tractions(body.law, surface, body.multipliers);
  if (!surface.against_a_body())
    lumped = continued_tractions(body.law, surface, body.displacement,
                                 system.prescribed, std::move(lumped));
  if (motions.cols() == 0) return lumped;
  const CellStresses<3> no_stress =
      CellStresses<3>::Zero(6, topology.mesh.cell_count());
  const NodalResidual<3> loads =
      nodal_residual(topology, no_stress, body.body_loads, without_contact);
  const VectorXd of_loads = -motions.transpose() * loads.missing.reshaped(),
                 of_forces =
                     motions.transpose() *
                     nodal_load(surface, body.multipliers, system.dof_count());
  for (const VectorXd& resultants : {of_loads, of_forces}) {
    const auto nearest =
        nearest_in_cone(topology.mesh, topology.facets, surface, body.law,
                        lumped, motions, resultants);
    if (nearest) return *nearest;
  }
  refuse_unheld_solid();
}

}  // namespace

FaceTractions boundary_with(const SolvedProblem<3>& solved,
                            const FaceMoments& springs,
                            const Ref<const Matrix3Xd>& contact) {
  const auto& [topology, surface, system, body] = solved;
  return with_contact(
      given_tractions<3>(topology.mesh, topology.facets, system.prescribed,
                         with_springs<3>(body.neumann, springs)),
      topology.mesh, topology.facets, surface, contact);
}

FirstSurfaceTractions first_tractions(const SolvedProblem<3>& solved,
                                      const CellStresses<3>& stress,
                                      double stress_terms) {
  const auto& [topology, surface, system, body] = solved;
  FirstSurfaceTractions first;
  first.springs =
      spring_moments<3>(topology.mesh, body.springs, body.displacement);
  const FaceTractions without =
      tractions_without_contact(solved, first.springs);
  require_loads_of_solution(
      solved, nodal_residual(topology, stress, body.body_loads, without),
      stress_terms);
  first.beside = without.moments(Eigen::all, surface.face);
  const MatrixXd motions = unheld_motions(topology.mesh, system);

  first.contact = tractions_in_cone(solved, without, motions);
  const auto rebalancing = [&] {
    return Rebalancing(
        solved.system,
        free_dofs_at(contact_vertices(solved.contact), solved.system), motions,
        solved.body.stiffness);
  };
  const CellStresses<3> in_balance = balanced_stresses(
      topology, body.hooke,
      nodal_residual(topology, stress, body.body_loads,
                     boundary_with(solved, first.springs, first.contact)),
      stress, rebalancing, body.springs,
      [&](const FaceMoments& answers) { first.springs += answers; });
  first.boundary = boundary_with(solved, first.springs, first.contact);
  first.moments = equilibrated_moments(topology, in_balance, body.body_loads,
                                       first.boundary);
  return first;
}

}  // namespace ffcontact
