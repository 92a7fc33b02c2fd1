// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "ffcontact/mesh/facets.hpp"

namespace ffcontact {

/// A box along the axes: its middle and half of each of its sides [mm].
template <int dim>
struct Box {
  VectorOf<dim> middle, half;
};

/// Facets in a tree of boxes, each box halved into two: of n facets those in a narrow
/// region are found among about log n boxes.
template <int dim>
class FacetTree {
 public:
  FacetTree(const SimplexMesh<dim>& mesh, const Facets<dim>& facets,
            std::vector<int> members);

  /// The members whose boxes a region may meet, ascending.
  /// @param may_meet  of a box; true of each box around one for which it is
  template <class MayMeet>
  std::vector<int> met_by(const MayMeet& may_meet) const {
    std::vector<int> found;
    for (std::size_t next = 0; next < nodes_.size();) {
      const Node& node = nodes_[next];
      const bool met = may_meet(node.box);
      if (met && node.member >= 0) found.push_back(node.member);
      next = met ? next + 1 : node.beyond;
    }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  /// Nodes are in the order of a walk that visits each before those within it.
  struct Node {
    Box<dim> box;
    int member;          ///< of a single facet, -1 otherwise
    std::size_t beyond;  ///< the node after those within it
  };
  using Iterator = std::vector<int>::iterator;

  Box<dim> box_around(Iterator first, Iterator last) const;
  void add(Iterator first, Iterator last);

  const SimplexMesh<dim>& mesh_;
  const Facets<dim>& facets_;
  std::vector<Node> nodes_;
};

}  // namespace ffcontact
