// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/displacement/sticking_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/estimate/bodies/contact_subset.hpp"
#include "ffcontact/estimate/displacement/rough_contact.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// 1 at the nodes of a line that slip: friction is at its bound, and there is some.
Flags slipping_nodes(const ContactLine& line, const ContactLaw<2>& law,
                     const Ref<const Matrix2Xd>& pressure) {
  const double largest = max_norm(pressure);
  Flags slipping(line.node_count(), 0);
  for (int e = 0; e < line.edge_count(); ++e) {
    const ConesAtEnds cones = most_cones(line, law, e);
    for (int end = 0; end < 2; ++end) {
      const int i = line.edge_node(end, e);
      if (slips(cones[end].bound(pressure(0, i)), std::abs(pressure(1, i)),
                largest))
        slipping[i] = 1;
    }
  }
  return slipping;
}

/// How many nodes move with each vertex.
VectorXi nodes_at_vertices(const ContactLine& line, Index vertices) {
  VectorXi count = VectorXi::Zero(vertices);
  for (int i = 0; i < line.node_count(); ++i) {
    ++count[line.vertex[i]];
    visit_opposite(line, i, [&](int vertex, double) { ++count[vertex]; });
  }
  return count;
}

class Sticking {
 public:
  Sticking(const MatchedBodies<2>& bodies, const Ref<const Matrix2Xd>& pressure)
      : bodies_(bodies),
        line_(bodies.contact()),
        pressure_(bodies.nodal_values(pressure)),
        nodes_at_(
            nodes_at_vertices(line_, bodies.topology().mesh.vertex_count())) {
    const Flags slipping =
        slipping_nodes(bodies.solved_line(), bodies.solved_law(), pressure);
    Matrix2Xd flags = Matrix2Xd::Zero(2, count_of(slipping));
    for (int i = 0; i < count_of(slipping); ++i) flags(0, i) = slipping[i];
    slips_ = bodies.nodal_values(flags).row(0);
  }

  VectorXd displacement(VectorXd u) const {
    const ContactLaw<2>& law = bodies_.body().law;
    const VectorXd slip = displacement_against_foundation(line_, law, u).row(1);
    const VectorXd worth = worth_of_sticking();
    for (int i = 0; i < line_.node_count(); ++i)
      if (slips_[i] == 0 && std::abs(slip[i]) < worth[i]) move(i, slip[i], u);
    return u;
  }

 private:
  /// The slip below which sticking is cheaper, 0 where friction is not rough [mm].
  VectorXd worth_of_sticking() const {
    VectorXd worth = VectorXd::Zero(line_.node_count());
    for (int e = 0; e < line_.edge_count(); ++e) {
      const double of_edge = worth_on_edge(e);
      for (const int i : line_.edge_node.col(e))
        worth[i] = std::max(worth[i], of_edge);
    }
    return worth;
  }

  double worth_on_edge(int e) const {
    if (is_bonded<2>(line_, bodies_.body().law, e)) return 0;
    const ConesAtEnds cones = most_cones(line_, bodies_.body().law, e);
    double bound = 0, normal = 0, largest = 0;
    for (int end = 0; end < 2; ++end) {
      const Vector2d p = pressure_.col(line_.edge_node(end, e));
      bound += cones[end].bound(p[0]) / 2;
      normal += std::abs(p[0]) / 2;
      largest = std::max(largest, p.norm());
    }
    if (!is_rough(bound, normal)) return 0;
    return slip_worth_sticking(bound, largest, line_.length[e], stiffness(e));
  }

  /// The largest of C beside an edge [MPa].
  double stiffness(int e) const {
    const Edges& edges = bodies_.topology().facets;
    const Hooke& hooke = bodies_.body().hooke;
    const int facing = facing_edge(line_, e);
    double largest = max_norm(hooke[edges.cells(0, line_.edge[e])]);
    if (facing >= 0)
      largest = std::max(largest, max_norm(hooke[edges.cells(0, facing)]));
    return largest;
  }

  bool may_move(int vertex, const Vector2d& t) const {
    if (nodes_at_[vertex] > 1) return false;
    for (int c = 0; c < 2; ++c)
      if (std::abs(t[c]) > no_component && bodies_.prescribed()[2 * vertex + c])
        return false;
    return true;
  }

  void move(int node, double slip, VectorXd& u) const {
    const Vector2d t = line_.tangent(node);
    const int own = line_.vertex[node];
    int other = -1;
    visit_opposite(line_, node, [&](int vertex, double weight) {
      other = weight == 1 && other < 0 ? vertex : -2;
    });
    const bool own_moves = other != -2 && may_move(own, t),
               other_moves = other >= 0 && may_move(other, t);
    if (own_moves &&
        (bodies_.is_cut(own) || !other_moves || !bodies_.is_cut(other)))
      u.segment<2>(2 * own) -= slip * t;
    else if (other_moves)
      u.segment<2>(2 * other) += slip * t;
  }

  const MatchedBodies<2>& bodies_;
  const ContactLine& line_;
  Matrix2Xd pressure_;
  VectorXd slips_;  ///< not 0 at nodes that slip, or lie beside such
  VectorXi nodes_at_;
};

}  // namespace

VectorXd sticking_displacement(const MatchedBodies<2>& bodies,
                               const Ref<const Matrix2Xd>& pressure,
                               VectorXd displacement) {
  return Sticking(bodies, pressure).displacement(std::move(displacement));
}

}  // namespace ffcontact
