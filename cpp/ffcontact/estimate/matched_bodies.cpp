// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/matched_bodies.hpp"

#include "ffcontact/equilibrium/refined_moments.hpp"
#include "ffcontact/estimate/nodal_forces.hpp"
#include "ffcontact/estimate/refined_body.hpp"

namespace ffcontact {

MatchedBodies::MatchedBodies(const SolvedProblem& solved) : solved_(solved) {
  const auto& [topology, line, system, body] = solved;
  if (line.matches()) return;
  refinement_ = common_refinement(topology.mesh, topology.edges, line);
  const Stars stars = stars_of(refinement_->mesh, refinement_->edges);
  cut_ = Cut{
      {refinement_->mesh, refinement_->edges, stars},
      refined_prescribed(*refinement_, system.prescribed),
      refined_body(topology.mesh, topology.edges, line, body, *refinement_)};
}

BoundaryTractions MatchedBodies::boundary_with(
    const ContactDensities& densities) const {
  return boundary_tractions(topology().mesh, topology().edges, prescribed(),
                            body().neumann, line(), densities);
}

BoundaryTractions MatchedBodies::solved_boundary(
    const BoundaryTractions& boundary) const {
  if (!cut_) return boundary;
  const Edges& edges = solved_.topology.edges;
  return tractions_of_parts(
      edges, *refinement_, boundary,
      given_tractions(solved_.topology.mesh, edges, solved_.system.prescribed,
                      solved_.body.neumann));
}

VectorXd MatchedBodies::solved_forces(const ContactDensities& densities) const {
  const VectorXd forces = nodal_forces(topology().mesh, line(), densities);
  return cut_ ? unrefined_forces(*refinement_, forces) : forces;
}

Matrix2Xd MatchedBodies::nodal_values(const Matrix2Xd& solved) const {
  if (!cut_) return solved;
  return (refinement_->node_weights * solved.transpose()).transpose();
}

MatrixXd MatchedBodies::fields(const MatrixXd& solved) const {
  if (!cut_) return solved;
  MatrixXd cut(2 * cut_->topology.mesh.vertices.cols(), solved.cols());
  for (Index k = 0; k < solved.cols(); ++k)
    cut.col(k) = refined_field(*refinement_, solved.col(k));
  return cut;
}

EdgeMoments MatchedBodies::moments(const EdgeMoments& solved,
                                   const Matrix3Xd& stress,
                                   const BoundaryTractions& boundary) const {
  if (!cut_) return solved;
  return refined_moments(solved_.topology.edges, *refinement_, solved, stress,
                         cut_->body.body_loads, boundary);
}

VectorXd MatchedBodies::sums_of_parts(const VectorXd& values) const {
  if (!cut_) return values;
  VectorXd sums = VectorXd::Zero(solved_.topology.mesh.cell_count());
  for (Index t = 0; t < values.size(); ++t)
    sums[refinement_->parent[t]] += values[t];
  return sums;
}

}  // namespace ffcontact
