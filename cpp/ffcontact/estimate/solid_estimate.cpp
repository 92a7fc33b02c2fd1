// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/solid_estimate.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/parted_sum.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/law/bounded_friction.hpp"
#include "ffcontact/elastic/stress_terms.hpp"
#include "ffcontact/equilibrium/tractions/equilibrium_defect.hpp"
#include "ffcontact/equilibrium/tractions/free_springs.hpp"
#include "ffcontact/estimate/bodies/boundary_moments.hpp"
#include "ffcontact/estimate/bodies/total_stresses.hpp"
#include "ffcontact/estimate/bodies/unstressed.hpp"
#include "ffcontact/estimate/checks/law_of_matrix.hpp"
#include "ffcontact/estimate/checks/reason_against.hpp"
#include "ffcontact/estimate/checks/sound_problem.hpp"
#include "ffcontact/estimate/displacement/sticking_solid.hpp"
#include "ffcontact/estimate/error/error_history.hpp"
#include "ffcontact/estimate/error/facing_error.hpp"
#include "ffcontact/estimate/error/spring_parts.hpp"
#include "ffcontact/estimate/error/stress_norms.hpp"
#include "ffcontact/estimate/error/surface_error.hpp"
#include "ffcontact/estimate/error/traction_oscillation.hpp"
#include "ffcontact/estimate/tractions/first_surface_tractions.hpp"
#include "ffcontact/estimate/tractions/surface_tractions.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Stresses of u_h and the forces beside them, 0 where they are rounding.
/// @param terms  largest_stress_terms
struct SolidStresses {
  double terms;
  bool unstressed;
  CellStresses<3> computed;

  explicit SolidStresses(const SolvedProblem<3>& solved)
      : terms(std::max(
            solved.body.initial.bound(),
            largest_stress_terms(solved.topology.mesh, solved.body.hooke,
                                 solved.body.displacement))) {
    const LinearStresses<3> total = total_stresses(
        solved.topology.mesh, solved.body, solved.body.displacement);
    const double traction = max_norm(solved.body.multipliers) /
                            solved.contact.area.minCoeff(),
                 largest = std::max(total.bound(), traction);
    unstressed =
        largest <= rounding_of_terms * terms &&
        !has_loads(solved.topology, solved.system.prescribed, solved.body);
    computed = total.mean;
    if (unstressed) computed.setZero();
  }
};

/// |w_t| on a face, where it has one direction.
double mean_slip(const ContactFacet<3>& face) {
  return 3 * max_norm(face.slip) / face.measure;
}

/// Does a face without tractions stay without, as outweighs_all_gains says?
bool stays_unloaded(const SolvedProblem<3>& solved, const ContactFacet<3>& face,
                    const SolidEstimate& estimate) {
  const SurfaceLaw& law = solved.body.law;
  const Vector3i nodes = solved.contact.face_node.col(face.index);
  return law.slip_bound.size() == 0 &&
         estimate.tractions(Eigen::all, nodes).isZero(0) &&
         outweighs_all_gains(law.friction(nodes).minCoeff(), mean_slip(face),
                             max_norm(estimate.displacement));
}

/// The contact faces whose tractions are relaxed.
/// @param beside  given tractions on the faces of the surface
std::vector<ContactFacet<3>> relaxed_faces(const SolvedProblem<3>& solved,
                                           const FaceMoments& beside,
                                           const SolidEstimate& estimate) {
  const auto& [topology, surface, system, body] = solved;
  std::vector<ContactFacet<3>> relaxed;
  for (ContactFacet<3>& face :
       contact_faces(topology.mesh, topology.facets, surface, body.law,
                     estimate.displacement)) {
    face.beside = beside.col(face.index);
    if (!stays_unloaded(solved, face, estimate)) relaxed.push_back(face);
  }
  return relaxed;
}

/// r_hat on all faces of the surface and on the boundary, relaxed where it may be.
void put_relaxed(const SolvedProblem<3>& solved,
                 const std::vector<ContactFacet<3>>& contact,
                 FaceMoments& on_boundary, SolidEstimate& estimate) {
  const SurfaceTractions relaxed = tractions_of(contact, estimate.moments);
  estimate.face_tractions =
      tractions_by_face(solved.contact, estimate.tractions);
  estimate.face_tractions(Eigen::all, surface_faces(contact)) = relaxed;
  put_moments(contact, relaxed, on_boundary);
}

/// The contact part of e^2 on each face of the surface.
VectorXd contact_part_of(const SolvedProblem<3>& solved,
                         const std::vector<ContactFacet<3>>& contact,
                         const SolidEstimate& estimate) {
  const auto& [topology, surface, system, body] = solved;
  const VectorXi relaxed = surface_faces(contact);
  VectorXd part = surface.against_a_body()
                      ? facing_contact_error(
                            topology.mesh, topology.facets, surface, body.law,
                            estimate.tractions, estimate.displacement)
                      : VectorXd::Zero(surface.face_count());
  part(relaxed) =
      contact_error(contact, estimate.face_tractions(Eigen::all, relaxed));
  return part;
}

/// Body loads of sigma_hat - sigma, where they are not those of sigma_hat.
BodyLoadsOfCells<3> difference_loads_of(const SolvedBody<3>& body,
                                        const SolidMesh& mesh,
                                        const LinearStresses<3>& stress) {
  if (!stress.varies()) return {};
  return difference_body_loads(mesh, body.body_loads, stress);
}

/// Relaxes sigma_hat, by its moments, contact tractions in the cone and those of springs,
/// which are put into what the boundary carries.
/// @param fixed  with springs whose tractions are known
/// @return what e^2 fell by in every step
std::vector<double> relaxed(const SolvedProblem<3>& solved,
                            const RelaxFaces& relax,
                            const RelaxationSettings& settings,
                            const FacetSetting<3>& fixed,
                            FirstSurfaceTractions& first,
                            SolidEstimate& estimate) {
  const auto& [topology, surface, system, body] = solved;
  if (body.springs.empty()) return relax(fixed, settings, estimate.moments);
  const std::vector<FreeSpring<3>> springs =
      free_springs<3>(topology.mesh, topology.facets, body.springs,
                      first.boundary, estimate.displacement, first.springs);
  const FaceTractions without = released<3>(first.boundary, springs);
  const LoadedFacets<3>& of = fixed.body;
  const std::vector<double> falls =
      relax({{of.topology, of.hooke, without, of.body_loads, of.stress,
              terms_of<3>(springs)},
             fixed.contact},
            settings, estimate.moments);
  add_spring_changes<3>(topology.mesh, topology.facets, springs, first.boundary,
                        estimate.moments, first.springs);
  first.boundary = boundary_with(solved, first.springs, estimate.tractions);
  return falls;
}

/// (2.11) to (2.13).
void put_error(const SolvedProblem<3>& solved,
               const std::vector<ContactFacet<3>>& contact,
               const StressNorms<3>& norms, const SpringNorms& springs,
               const std::vector<double>& falls, SolidEstimate& estimate) {
  const auto& [topology, surface, system, body] = solved;
  const VectorXd contact_part = contact_part_of(solved, contact, estimate);
  const double elastic = parted_sum(topology.mesh.cell_count(),
                                    [&](int t) { return norms.difference[t]; }),
               sum = norms.sum + springs.sum, scale = sum > 0 ? sum : 1;
  estimate.contact = contact_part.sum();
  estimate.springs = springs.difference.sum();
  const double square =
      square_of_error(elastic + estimate.springs, estimate.contact);
  estimate.elastic = std::sqrt(elastic);
  estimate.e = std::sqrt(square);
  estimate.relative = estimate.e / std::sqrt(scale);
  estimate.history = error_history(square, falls);
  VectorXd local = norms.difference;
  for (int m = 0; m < surface.face_count(); ++m)
    local[topology.facets.cells(0, surface.face[m])] += contact_part[m];
  add_spring_parts<3>(topology.facets, springs.difference, local);
  estimate.local = (local / scale).cwiseMax(0.0).cwiseSqrt();
}

/// Does e pay for next to nothing but friction without bound on what the displacements of
/// surfaces that do not match differ by between their nodes? No u_hat sticks there.
bool pays_for_rough_faces(const SolvedProblem<3>& solved,
                          const std::vector<ContactFacet<3>>& matching,
                          const SolidEstimate& estimate) {
  constexpr double nearly_all = 0.99;
  const ContactSurface& surface = solved.contact;
  const bool match = count_of(matching) == surface.face_count();
  return surface.against_a_body() && !match &&
         solved.body.law.friction.maxCoeff() > most_friction &&
         estimate.contact > nearly_all * estimate.e * estimate.e;
}

/// What stresses and tractions are large beside [MPa].
double stress_scale(const SolvedProblem<3>& solved, const SolidStresses& stress,
                    const StressNorms<3>& norms,
                    const SolidEstimate& estimate) {
  const double largest =
      std::max({max_norm(stress.computed), norms.largest,
                least_part_of_terms * stress.terms,
                largest_traction(solved.topology.mesh, solved.topology.facets,
                                 estimate.moments)});
  return largest > 0 ? largest : 1;
}

/// Out of the cone, at the nodes and on relaxed faces [MPa].
double cone_violation(const SolvedProblem<3>& solved,
                      const std::vector<ContactFacet<3>>& contact,
                      const SolidEstimate& estimate) {
  return std::max(
      cone_violation(solved.body.law, solved.contact, estimate.tractions),
      cone_violation(contact, estimate.face_tractions(Eigen::all,
                                                      surface_faces(contact))));
}

/// Why the pair is not admissible, or nothing.
std::string reason_of(const SolvedProblem<3>& solved,
                      const std::vector<ContactFacet<3>>& contact,
                      const DeepestNode& deepest, const BetweenNodes& found,
                      const SolidEstimate& estimate) {
  const auto& [topology, surface, system, body] = solved;
  const auto middle = [&solved](int facet) {
    return middle_of(solved.topology.mesh, solved.topology.facets,
                     solved.contact.face[facet]);
  };
  const std::string reason = reason_against(
      estimate, {topology.mesh.place(surface.vertex[deepest.node]),
                 middle(found.turned_facet), middle(found.negative_facet)});
  if (reason.empty() && pays_for_rough_faces(solved, contact, estimate))
    return "e pays friction= times what the displacements of surfaces whose "
           "meshes do not match differ by between their nodes: where nothing "
           "slips make the meshes match, or give friction= no larger than the "
           "contact needs";
  return reason;
}

/// What the theory promises, measured.
void judge(const SolvedProblem<3>& solved, const SolidStresses& stress,
           const std::vector<ContactFacet<3>>& contact,
           const StressNorms<3>& norms, SolidEstimate& estimate) {
  const auto& [topology, surface, system, body] = solved;
  const double scale = stress_scale(solved, stress, norms, estimate),
               moved = largest_displacement(body.law, body.displacement);
  estimate.equilibrium = norms.defect.relative_to(scale);
  estimate.cone = cone_violation(solved, contact, estimate) / scale;
  const BetweenNodes found =
      between_nodes(topology.facets, surface, body.law, estimate.face_tractions,
                    estimate.displacement);
  put_between_nodes(found, scale * moved, estimate);
  const DeepestNode deepest =
      deepest_node(topology.facets, surface, body.law, estimate.displacement);
  if (deepest.depth > 0) estimate.penetration = deepest.depth / moved;
  estimate.reason = reason_of(solved, contact, deepest, found, estimate);
  estimate.admissible = estimate.reason.empty();
}

/// sigma, of u_hat.
LinearStresses<3> stress_beside(const SolvedProblem<3>& solved,
                                const SolidStresses& stress,
                                const SolidEstimate& estimate) {
  if (stress.unstressed) return LinearStresses<3>(stress.computed);
  return total_stresses(solved.topology.mesh, solved.body,
                        estimate.displacement);
}

}  // namespace

SolidEstimate estimate_error(const Topology<3>& topology,
                             const ContactSurface& surface,
                             const ElasticSystem& system,
                             const SolvedBody<3>& body,
                             const RelaxationSettings& settings,
                             const RelaxFaces& relax) {
  const SolvedProblem<3> given{topology, surface, system, body};
  require_sound(given, settings);
  require_law_of_matrix<3>(topology.mesh, system, body.hooke, body.springs);
  const SolidStresses stress(given);
  SolvedBody<3> without_forces;
  if (stress.unstressed) {
    without_forces = body;
    without_forces.multipliers.setZero();
  }
  const SolvedProblem<3> solved{topology, surface, system,
                                stress.unstressed ? without_forces : body};
  SolidEstimate estimate;

  // 1. Admissible displacement [CHH01, 4.1].
  estimate.displacement = sticking_displacement(
      solved, admissible_displacement(topology.facets, surface, body.law,
                                      body.displacement, system.prescribed));
  const LinearStresses<3> of_displacement =
      stress_beside(solved, stress, estimate);

  // 2., 3. Contact tractions in the cone, face tractions in equilibrium with them.
  FirstSurfaceTractions first =
      first_tractions(solved, stress.computed, stress.terms);
  estimate.tractions = std::move(first.contact);
  estimate.moments = std::move(first.moments);

  // 4. Relaxation of sigma_hat - C eps(u_hat), contact tractions in the cone.
  const BodyLoadsOfCells<3> other_loads =
      difference_loads_of(body, topology.mesh, of_displacement);
  const FacetSetting<3> setting{
      {topology, body.hooke, first.boundary,
       of_displacement.varies() ? other_loads : body.body_loads,
       of_displacement},
      relaxed_faces(solved, first.beside, estimate)};
  const std::vector<double> falls =
      relaxed(solved, relax, settings, setting, first, estimate);
  put_relaxed(solved, setting.contact, first.boundary.moments, estimate);

  // 5. The error and its parts [CHH01, (2.11)-(2.13)].
  const StressNorms<3> norms =
      stress_norms<3>({setting.body, estimate.moments, body.body_loads});
  const SpringNorms springs = spring_norms<3>(
      topology.mesh, body.springs, estimate.displacement, first.springs);
  put_error(solved, setting.contact, norms, springs, falls, estimate);
  estimate.oscillation = traction_oscillation(
      topology.mesh, topology.facets, surface, body.hooke, estimate.tractions);

  // 6. What the theory promises, measured.
  judge(solved, stress, setting.contact, norms, estimate);
  return estimate;
}

SubcellStress<3> stress_of(const Topology<3>& topology,
                           const SolidEstimate& estimate,
                           const SolvedBody<3>& body, int cell) {
  return composite_stress(
      corners_of(topology.mesh, cell),
      loads_of(topology.mesh, topology.facets, estimate.moments, cell),
      loads_in_cell<3>(body.body_loads, cell));
}

}  // namespace ffcontact
