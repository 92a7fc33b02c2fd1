// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/refined_body.hpp"

#include "ffcontact/equilibrium/refined_moments.hpp"

namespace ffcontact {

namespace {

/// A vertex field on the refinement.
Eigen::VectorXd refined_field(const CommonRefinement& refinement, const Eigen::VectorXd& field) {
  return (field.reshaped(2, field.size() / 2) * refinement.vertex_weights.transpose()).reshaped();
}

Eigen::VectorXd refined_values(const CommonRefinement& refinement, const Eigen::VectorXd& values) {
  return values.size() > 0 ? Eigen::VectorXd(refinement.node_weights * values) : values;
}

}  // namespace

SolvedBody refined_body(const Mesh& old_mesh, const SolvedBody& old, const CommonRefinement& refinement) {
  SolvedBody body;
  for (int t : refinement.parent) body.hooke.push_back(old.hooke[t]);
  body.displacement = refined_field(refinement, old.displacement);
  body.pressure = (refinement.node_weights * old.pressure.transpose()).transpose();
  body.law = {old.law.multiplier, refined_values(refinement, old.law.friction),
              refined_values(refinement, old.law.slip_bound), refined_values(refinement, old.law.gap),
              refined_values(refinement, old.law.previous)};
  body.neumann = refined_boundary_moments(old_mesh, refinement, old.neumann);
  body.body_loads = refined_body_loads(old_mesh, refinement, old.body_loads);
  return body;
}

std::vector<char> refined_prescribed(const CommonRefinement& refinement, const std::vector<char>& old) {
  std::vector<char> prescribed(2 * refinement.mesh.vertices.cols(), 1);
  for (int v = 0; v < refinement.mesh.vertex_count(); ++v)
    for (WeightsByNode::InnerIterator part(refinement.vertex_weights, v); part; ++part)
      for (int c = 0; c < 2; ++c) prescribed[2 * v + c] = prescribed[2 * v + c] && old[2 * part.col() + c];
  return prescribed;
}

Eigen::VectorXd unrefined_forces(const CommonRefinement& refinement, const Eigen::VectorXd& forces) {
  return (forces.reshaped(2, forces.size() / 2) * refinement.vertex_weights).reshaped();
}

}  // namespace ffcontact
