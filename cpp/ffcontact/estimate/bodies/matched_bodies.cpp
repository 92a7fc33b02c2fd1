// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/matched_bodies.hpp"

#include "ffcontact/equilibrium/tractions/refined_moments.hpp"
#include "ffcontact/estimate/bodies/nodal_forces.hpp"
#include "ffcontact/estimate/bodies/refined_body.hpp"

namespace ffcontact {

MatchedBodies<2>::MatchedBodies(const SolvedProblem<2>& solved)
    : solved_(solved) {
  const auto& [topology, line, system, body] = solved;
  solved_springs_ = springs_ =
      spring_moments<2>(topology.mesh, body.springs, body.displacement);
  if (line.matches()) return;
  refinement_ = common_refinement(topology.mesh, topology.facets, line);
  cut_ =
      Cut{topology_of(refinement_->mesh, refinement_->edges),
          refined_prescribed(*refinement_, system.prescribed), matched(body)};
  springs_ = matched_moments(solved_springs_);
}

SolvedBody<2> MatchedBodies<2>::matched(const SolvedBody<2>& solved) const {
  if (!refinement_) return solved;
  const auto& [mesh, edges, ridges, stars] = solved_.topology;
  return refined_body(mesh, edges, solved_.contact, solved, *refinement_);
}

Matrix4Xd MatchedBodies<2>::matched_moments(const Matrix4Xd& solved) const {
  if (!cut_ || solved.cols() == 0) return solved;
  return refined_boundary_moments(solved_.topology.mesh, *refinement_, solved);
}

void MatchedBodies<2>::add_to_springs(const Matrix4Xd& change) {
  solved_springs_ += change;
  springs_ += matched_moments(change);
}

Matrix4Xd MatchedBodies<2>::solved_moments() const {
  return with_springs<2>(solved_.body.neumann, solved_springs_);
}

BoundaryTractions MatchedBodies<2>::boundary_with(
    const ContactDensities& densities) const {
  return boundary_tractions(topology().mesh, topology().facets, prescribed(),
                            with_springs<2>(body().neumann, springs_),
                            contact(), densities);
}

BoundaryTractions MatchedBodies<2>::solved_boundary(
    const BoundaryTractions& boundary) const {
  if (!cut_) return boundary;
  const Edges& edges = solved_.topology.facets;
  return tractions_of_parts(
      edges, *refinement_, boundary,
      given_tractions(solved_.topology.mesh, edges, solved_.system.prescribed,
                      solved_moments()));
}

BoundaryTractions MatchedBodies<2>::solved_boundary_without_contact() const {
  const auto& [topology, line, system, body] = solved_;
  const Matrix2Xd zero = Matrix2Xd::Zero(2, line.edge_count());
  return boundary_tractions(topology.mesh, topology.facets, system.prescribed,
                            solved_moments(), line, {zero, zero});
}

VectorXd MatchedBodies<2>::solved_forces(
    const ContactDensities& densities) const {
  const VectorXd forces = nodal_forces(topology().mesh, contact(), densities);
  return cut_ ? unrefined_forces(*refinement_, forces) : forces;
}

Matrix2Xd MatchedBodies<2>::nodal_values(const Matrix2Xd& solved) const {
  if (!cut_) return solved;
  return (refinement_->node_weights * solved.transpose()).transpose();
}

MatrixXd MatchedBodies<2>::fields(const MatrixXd& solved) const {
  if (!cut_) return solved;
  MatrixXd cut(2 * cut_->topology.mesh.vertices.cols(), solved.cols());
  for (Index k = 0; k < solved.cols(); ++k)
    cut.col(k) = refined_field(*refinement_, solved.col(k));
  return cut;
}

EdgeMoments MatchedBodies<2>::moments(const EdgeMoments& solved,
                                      const Matrix3Xd& stress,
                                      const BoundaryTractions& boundary) const {
  if (!cut_) return solved;
  return refined_moments(solved_.topology.facets, *refinement_, solved, stress,
                         cut_->body.body_loads, boundary);
}

VectorXd MatchedBodies<2>::sums_of_parts(const VectorXd& values) const {
  if (!cut_) return values;
  VectorXd sums = VectorXd::Zero(solved_.topology.mesh.cell_count());
  for (Index t = 0; t < values.size(); ++t)
    sums[refinement_->parent[t]] += values[t];
  return sums;
}

}  // namespace ffcontact
