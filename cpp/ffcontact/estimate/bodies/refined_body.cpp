// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/refined_body.hpp"

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/tractions/refined_moments.hpp"

namespace ffcontact {

namespace {

VectorXd refined_values(const CommonRefinement& refinement,
                        const VectorXd& values) {
  return values.size() > 0 ? VectorXd(refinement.node_weights * values)
                           : values;
}

/// All that a new node lies between have one flag.
Flags refined_flags(const CommonRefinement& refinement, const Flags& flags) {
  if (flags.empty()) return flags;
  Flags refined(refinement.line.node_count(), 0);
  for (int i = 0; i < count_of(refined); ++i)
    for (WeightsByNode::InnerIterator part(refinement.node_weights, i); part;
         ++part)
      refined[i] = flags[part.col()];
  return refined;
}

/// Share of its old contact edge k at an end of contact edge e.
double share_at(const Edges& old_edges, const ContactLine& old_line,
                const CommonRefinement& refinement, int end, int e, int k) {
  const ContactLine& line = refinement.line;
  const int vertex = line.vertex[line.edge_node(end, e)];
  return old_line.share(k,
                        refinement.place(old_edges, vertex, old_line.edge[k]));
}

/// A bound that is linear on the old contact edges at the ends of the new ones.
Matrix2Xd refined_bound(const Edges& old_edges, const ContactLine& old_line,
                        const CommonRefinement& refinement,
                        const Matrix2Xd& bound) {
  if (bound.size() == 0) return {};
  Matrix2Xd refined(2, refinement.line.edge_count());
  for (int e = 0; e < refinement.line.edge_count(); ++e)
    for (int end = 0; end < 2; ++end) {
      const int k = refinement.parent_contact_edge[e];
      const double share = share_at(old_edges, old_line, refinement, end, e, k);
      refined(end, e) = (1 - share) * bound(0, k) + share * bound(1, k);
    }
  return refined;
}

EdgeRange refined_range(const Edges& old_edges, const ContactLine& old_line,
                        const CommonRefinement& refinement,
                        const EdgeRange& range) {
  return {refined_bound(old_edges, old_line, refinement, range.least),
          refined_bound(old_edges, old_line, refinement, range.most)};
}

ContactLaw<2> refined_law(const Edges& old_edges, const ContactLine& old_line,
                          const CommonRefinement& refinement,
                          const ContactLaw<2>& old) {
  const auto values = [&](const VectorXd& at_nodes) {
    return refined_values(refinement, at_nodes);
  };
  const auto range = [&](const EdgeRange& between_nodes) {
    return refined_range(old_edges, old_line, refinement, between_nodes);
  };
  ContactLaw<2> law = old;
  law.friction = values(old.friction);
  law.slip_bound = values(old.slip_bound);
  law.gap = values(old.gap);
  law.previous = values(old.previous);
  law.between_nodes = range(old.between_nodes);
  law.shear_limit = values(old.shear_limit);
  law.limit_between_nodes = range(old.limit_between_nodes);
  law.bonded = refined_flags(refinement, old.bonded);
  if (old.carried.size() > 0)
    law.carried = old.carried * refinement.node_weights.transpose();
  return law;
}

/// Linear on the old triangles, at the vertices of the new ones.
LinearStresses<2> refined_stresses(const Mesh& old_mesh,
                                   const CommonRefinement& refinement,
                                   const LinearStresses<2>& old) {
  if (old.empty()) return old;
  const Mesh& mesh = refinement.mesh;
  Matrix<double, 9, Dynamic> values =
      Matrix<double, 9, Dynamic>::Zero(9, mesh.cell_count());
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const int parent = refinement.parent[t];
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i)
        values.block<3, 1>(3 * k, t) +=
            refinement.vertex_weights.coeff(mesh.cells(k, t),
                                            old_mesh.cells(i, parent)) *
            old.at_vertices(parent).col(i);
  }
  return LinearStresses<2>::of_values(values);
}

/// Springs are on edges that are not cut.
BoundarySprings<2> refined_springs(const CommonRefinement& refinement,
                                   const BoundarySprings<2>& old) {
  if (old.empty()) return old;
  BoundarySprings<2> springs(refinement.mesh.boundary.cols());
  springs.stiffness = old.stiffness(Eigen::all, refinement.parent_boundary);
  springs.rest = old.rest(Eigen::all, refinement.parent_boundary);
  return springs;
}

}  // namespace

VectorXd refined_field(const CommonRefinement& refinement,
                       const VectorXd& field) {
  return (field.reshaped(2, field.size() / 2) *
          refinement.vertex_weights.transpose())
      .reshaped();
}

SolvedBody<2> refined_body(const Mesh& old_mesh, const Edges& old_edges,
                           const ContactLine& old_line,
                           const SolvedBody<2>& old,
                           const CommonRefinement& refinement) {
  SolvedBody<2> body;
  for (int t : refinement.parent) body.hooke.push_back(old.hooke[t]);
  body.displacement = refined_field(refinement, old.displacement);
  body.multipliers =
      (refinement.node_weights * old.multipliers.transpose()).transpose();
  body.law = refined_law(old_edges, old_line, refinement, old.law);
  body.neumann = refined_boundary_moments(old_mesh, refinement, old.neumann);
  body.body_loads = refined_body_loads(old_mesh, refinement, old.body_loads);
  body.initial = refined_stresses(old_mesh, refinement, old.initial);
  body.springs = refined_springs(refinement, old.springs);
  return body;
}

Flags refined_prescribed(const CommonRefinement& refinement, const Flags& old) {
  Flags prescribed(2 * refinement.mesh.vertices.cols(), 1);
  for (int v = 0; v < refinement.mesh.vertex_count(); ++v)
    for (WeightsByNode::InnerIterator part(refinement.vertex_weights, v); part;
         ++part)
      for (int c = 0; c < 2; ++c)
        prescribed[2 * v + c] =
            prescribed[2 * v + c] && old[2 * part.col() + c];
  return prescribed;
}

VectorXd unrefined_forces(const CommonRefinement& refinement,
                          const VectorXd& forces) {
  return (forces.reshaped(2, forces.size() / 2) * refinement.vertex_weights)
      .reshaped();
}

}  // namespace ffcontact
