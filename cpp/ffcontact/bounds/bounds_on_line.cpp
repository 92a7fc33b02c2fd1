// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/contact_of_bounds.hpp"
#include "ffcontact/estimate/bodies/nodal_forces.hpp"
#include "ffcontact/estimate/displacement/admissible_displacement.hpp"
#include "ffcontact/estimate/error/contact_error.hpp"

namespace ffcontact {

template <>
VectorXd nodal_forces(const SolvedProblem<2>& solved,
                      const ContactDensities& rho) {
  return nodal_forces(solved.topology.mesh, solved.contact, rho);
}

template <>
VectorXd twice_psi(const SolvedProblem<2>& solved, const VectorXd& v,
                   const ContactDensities& rho) {
  return contact_error(solved.contact, solved.body.law, rho, v);
}

template <>
void add_to_cells(const SolvedProblem<2>& solved, const VectorXd& on_facets,
                  VectorXd& local) {
  add_to_cells(solved.topology.facets, solved.contact, on_facets, local);
}

template <>
ContactLaw with_twice_the_bound<2>(ContactLaw law) {
  law.multiplier = Multiplier::force;
  law.slip_bound *= 2;
  law.between_nodes.least *= 2;
  law.between_nodes.most *= 2;
  return law;
}

template <>
ContactLaw reflected(const SolvedProblem<2>& solved, const VectorXd& v) {
  ContactLaw law = solved.body.law;
  law.multiplier = Multiplier::force;
  const Matrix2Xd moved = contact_components(solved.contact, v);
  law.gap = on_the_other_side<VectorXd>(law.gap, moved.row(0));
  law.previous = on_the_other_side<VectorXd>(law.previous, moved.row(1));
  return law;
}

template <>
VectorXd cleared(const SolvedProblem<2>& solved, const VectorXd& v) {
  const auto& [topology, line, system, body] = solved;
  return cleared_between_nodes(
      line, body.law,
      admissible_displacement(line, body.law, v, system.prescribed),
      system.prescribed);
}

template <>
double depth_of(const SolvedProblem<2>& solved, const VectorXd& v) {
  return deepest_node(solved.contact, solved.body.law, v).depth;
}

template <>
std::string reason_against_bounds(const SolvedProblem<2>& solved,
                                  const Estimate<2>& first) {
  if (solved.body.law.bonded)
    return "there are no bounds of quantities of bonded bodies yet";
  if (first.refinement)
    return "there are no bounds of quantities of bodies whose meshes do not "
           "match on the contact: let them have the same vertices there";
  return "";
}

}  // namespace ffcontact
