// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/multigrid/block_rows.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"

namespace ffcontact {

/// How rigid motions a + w x (x - centre) of dim (dim + 1) / 2 parameters (a, w) move the
/// unknowns of a node: those of a vertex, or of an aggregate, which are such parameters
/// themselves.
template <int dim, int size>
struct NodeMotions {
  static constexpr int count = motion_count<dim>;
  VectorOf<dim> centre = VectorOf<dim>::Zero();
  double radius = 0;  ///< of what belongs to it, about the centre
  SingleBlock<size, count> motions = SingleBlock<size, count>::Zero();
};

/// What an aggregate makes of the unknowns of its nodes: u = Q u_a, where the columns of Q
/// are orthonormal, or 0 where the motions of the aggregate are dependent (one vertex, or
/// vertices on a plane of symmetry), and
///     motions of its nodes = Q (motions of u_a).
template <int dim, int size>
struct AggregateBasis {
  static constexpr int count = NodeMotions<dim, size>::count;
  std::vector<SingleBlock<size, count>> tentative;  ///< Q, node by node
  NodeMotions<dim, count> motions;                  ///< of u_a
};

/// By a QR factorisation with column pivoting, whose pivots below 1e-3 of the first one
/// count as 0.
template <int dim, int size>
AggregateBasis<dim, size> aggregate_basis(
    const std::vector<NodeMotions<dim, size>>& nodes,
    const std::vector<int>& members);

}  // namespace ffcontact
