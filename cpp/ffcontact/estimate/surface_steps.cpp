// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/law/bounded_friction.hpp"
#include "ffcontact/estimate/bodies/contact_subset.hpp"
#include "ffcontact/estimate/contact_steps.hpp"
#include "ffcontact/estimate/displacement/bonded_displacement.hpp"
#include "ffcontact/estimate/displacement/jump_on_surface.hpp"
#include "ffcontact/estimate/displacement/sticking_displacement.hpp"
#include "ffcontact/estimate/error/contact_faces.hpp"
#include "ffcontact/estimate/error/facing_error.hpp"
#include "ffcontact/estimate/error/facing_faces.hpp"
#include "ffcontact/estimate/error/facing_oscillations.hpp"
#include "ffcontact/estimate/error/surface_error.hpp"
#include "ffcontact/estimate/error/traction_oscillation.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// |w_t| on a face, where it has one direction.
double mean_slip(const ContactFacet<3>& face) {
  return 3 * max_norm(face.slip) / face.measure;
}

/// Does a face without tractions stay without, as outweighs_all_gains says?
bool stays_unloaded(const ContactSurface& surface, const Compared<3>& compared,
                    const Matrix3Xd& nodal, const ContactFacet<3>& face) {
  const ContactLaw<3>& law = compared.law;
  const Vector3i nodes = surface.face_node.col(face.index);
  return law.slip_bound.size() == 0 && nodal(Eigen::all, nodes).isZero(0) &&
         outweighs_all_gains(law.friction(nodes).minCoeff(), mean_slip(face),
                             max_norm(compared.displacement));
}

TractionFields fields_of(const ContactTractions<3>& contact) {
  return {contact.densities, contact.on_faces};
}

/// r_hat on some contact faces.
SurfaceTractions tractions_on(const std::vector<ContactFacet<3>>& faces,
                              const RelaxedTractions<3>& tractions) {
  return tractions.contact.on_faces(Eigen::all, surface_faces(faces));
}

/// What bonded bodies jump by between the vertices of the one that follows.
BondedJump jump_of(const MatchedBodies<3>& bodies, const VectorXd& u_hat) {
  if (!bodies.body().law.has_bonded()) return {};
  const ContactLaw<3>& all = bodies.body().law;
  const auto& [surface, law, node] = bonded_subset<3>(bodies.contact(), all);
  Flags slides(bodies.topology().facets.count(), 0);
  for_touching_facets(bodies.contact(), [&](int facet, int m) {
    slides[facet] = !is_bonded<3>(bodies.contact(), all, m);
  });
  BondedJump jump = bonded_jump(bodies.topology(), surface, bodies.body().hooke,
                                bodies.prescribed(), u_hat, slides);
  jump.left.node = node[jump.left.node];
  return jump;
}

/// Does e pay for next to nothing but friction without bound on what the displacements of
/// surfaces that do not match differ by between their nodes? No u_hat sticks there.
bool pays_for_rough_faces(const MatchedBodies<3>& bodies,
                          const std::vector<ContactFacet<3>>& matching,
                          const PairError& error) {
  const ContactSurface& surface = bodies.contact();
  const bool match = count_of(matching) == surface.face_count();
  return surface.against_a_body() && !match &&
         bodies.body().law.friction.maxCoeff() > most_friction &&
         pays_for_contact_alone(error);
}

}  // namespace

template <>
Matrix3Xd carried_tractions(const SolvedProblem<3>& solved) {
  const SolvedBody<3>& body = solved.body;
  return lumped_tractions(body.law, solved.contact, body.multipliers);
}

template <>
VectorXd displacement_of_pair(const SolvedProblem<3>& solved,
                              const MatchedBodies<3>&) {
  const Facets<3>& faces = solved.topology.facets;
  const ContactLaw<3>& all = solved.body.law;
  const auto& [surface, law, nodes] = sliding_subset<3>(solved.contact, all);
  const Flags held =
      held_with_bonded<3>(solved.contact, all, solved.system.prescribed);
  const VectorXd clear = sticking_displacement(
      solved, admissible_displacement(faces, surface, law,
                                      bonded_displacement(solved), held));
  return cleared_between_nodes(faces, surface, law, clear, held);
}

template <>
std::vector<ContactFacet<3>> contact_facets(
    const MatchedBodies<3>& bodies, const Compared<3>& compared,
    const ContactTractions<3>& tractions, const FaceTractions&) {
  const auto& [mesh, faces, ridges, stars] = bodies.topology();
  const ContactSurface& surface = bodies.contact();
  std::vector<ContactFacet<3>> contact,
      all = contact_faces(mesh, faces, surface, compared.law,
                          compared.displacement);
  for (ContactFacet<3>& face :
       facing_faces(mesh, faces, surface, compared.law, compared.displacement))
    all.push_back(std::move(face));
  for (ContactFacet<3>& face : all) {
    if (stays_unloaded(surface, compared, tractions.densities, face)) continue;
    face.beside = tractions.beside.col(face.index);
    contact.push_back(face);
  }
  return contact;
}

template <>
std::vector<FacingOscillation<3>> facing_oscillations(
    const MatchedBodies<3>& bodies, const std::vector<ContactFacet<3>>& contact,
    const ContactTractions<3>& tractions) {
  return facing_oscillations(bodies.topology().mesh, bodies.topology().facets,
                             bodies.contact(), bodies.body().hooke, contact,
                             tractions.densities);
}

template <>
void put_relaxed(const MatchedBodies<3>& bodies, const EstimateSettings<3>&,
                 const std::vector<ContactFacet<3>>& relaxed,
                 RelaxedTractions<3>& tractions) {
  auto& [nodal, on_faces, beside] = tractions.contact;
  on_faces = tractions_by_face(bodies.contact(), nodal);
  tractions.boundary = bodies.boundary_with(nodal);
  const SurfaceTractions on_relaxed = tractions_of(relaxed, tractions.moments);
  on_faces(Eigen::all, surface_faces(relaxed)) = on_relaxed;
  put_moments(relaxed, on_relaxed, tractions.boundary.moments);
}

template <>
VectorXd contact_part_of(const MatchedBodies<3>& bodies,
                         const Compared<3>& compared,
                         const RelaxedTractions<3>& tractions) {
  const auto& [mesh, faces, ridges, stars] = bodies.topology();
  return contact_error(mesh, faces, bodies.contact(), compared.law,
                       tractions.facets, fields_of(tractions.contact),
                       compared.displacement);
}

template <>
SpringNorms layer_norms_of(const MatchedBodies<3>& bodies,
                           const RelaxedTractions<3>& tractions) {
  return layer_norms(bodies.topology(), bodies.contact(), bodies.body().law,
                     fields_of(tractions.contact));
}

template <>
void add_contact_part(const MatchedBodies<3>& bodies, const VectorXd& part,
                      VectorXd& local) {
  const Facets<3>& faces = bodies.topology().facets;
  for (int m = 0; m < part.size(); ++m)
    local[faces.cells(0, bodies.contact().face[m])] += part[m];
}

template <>
double largest_traction(const ContactTractions<3>& contact) {
  return max_norm(contact.on_faces);
}

template <>
double cone_violation(const MatchedBodies<3>& bodies,
                      const RelaxedTractions<3>& tractions) {
  return std::max(
      cone_violation(bodies.body().law, tractions.contact.densities),
      cone_violation(tractions.facets,
                     tractions_on(tractions.facets, tractions)));
}

template <>
DeepestNode deepest_node(const MatchedBodies<3>& bodies,
                         const VectorXd& u_hat) {
  const auto& [surface, law, node] =
      sliding_subset<3>(bodies.contact(), bodies.body().law);
  DeepestNode deepest =
      deepest_node(bodies.topology().facets, surface, law, u_hat);
  const DeepestNode left = jump_of(bodies, u_hat).left;
  if (left.depth >= deepest.depth) return left;
  deepest.node = node[deepest.node];
  return deepest;
}

template <>
BetweenNodes between_nodes(const MatchedBodies<3>& bodies,
                           const ContactTractions<3>& contact,
                           const VectorXd& u_hat) {
  return between_nodes(bodies.topology().facets, bodies.contact(),
                       bodies.body().law, fields_of(contact), u_hat);
}

template <>
std::string reason_of(const MatchedBodies<3>& bodies,
                      const RelaxedTractions<3>& tractions,
                      const WorstPlaces& worst, const EstimateSettings<3>&,
                      const Estimate<3>& estimate) {
  const std::string reason = reason_against(estimate, worst);
  if (reason.empty() && bodies.body().law.layer.tangential > 0 &&
      turns(bodies.contact()))
    return "the tangential compliance of an interface is judged where normals "
           "do not turn over a face: take eps for an indicator";
  if (reason.empty() &&
      pays_for_rough_faces(bodies, tractions.facets, estimate))
    return "e pays friction= times what the displacements of surfaces whose "
           "meshes do not match differ by between their nodes: where nothing "
           "slips make the meshes match, or give friction= no larger than the "
           "contact needs";
  return reason;
}

template <>
void put_fields(MatchedBodies<3>& bodies, RelaxedTractions<3> tractions,
                Estimate<3>& estimate) {
  const auto& [mesh, faces, ridges, stars] = bodies.topology();
  estimate.oscillation =
      traction_oscillation(mesh, faces, bodies.contact(), bodies.body().hooke,
                           fields_of(tractions.contact));
  if (bodies.body().law.has_bonded())
    estimate.oscillation += jump_of(bodies, estimate.displacement).norm;
  estimate.moments = std::move(tractions.moments);
  estimate.tractions = std::move(tractions.contact.densities);
  estimate.face_tractions = std::move(tractions.contact.on_faces);
  estimate.spring_tractions = bodies.spring_tractions();
}

}  // namespace ffcontact
