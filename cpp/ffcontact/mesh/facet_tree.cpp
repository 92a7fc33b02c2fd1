// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/facet_tree.hpp"

namespace ffcontact {

template <int dim>
FacetTree<dim>::FacetTree(const SimplexMesh<dim>& mesh,
                          const Facets<dim>& facets, std::vector<int> members)
    : mesh_(mesh), facets_(facets) {
  nodes_.reserve(2 * members.size());
  if (!members.empty()) add(members.begin(), members.end());
}

template <int dim>
Box<dim> FacetTree<dim>::box_around(Iterator first, Iterator last) const {
  VectorOf<dim> low = mesh_.vertices.col(facets_.vertices(0, *first)),
                high = low;
  for (Iterator member = first; member != last; ++member)
    for (int v : facets_.vertices.col(*member)) {
      low = low.cwiseMin(mesh_.vertices.col(v));
      high = high.cwiseMax(mesh_.vertices.col(v));
    }
  return {0.5 * (low + high), 0.5 * (high - low)};
}

/// Half of the members on either side of a plane across the longest side of their box.
template <int dim>
void FacetTree<dim>::add(Iterator first, Iterator last) {
  const std::size_t number = nodes_.size();
  const auto count = last - first;
  nodes_.push_back({box_around(first, last), count == 1 ? *first : -1, 0});
  if (count > 1) {
    Index axis;
    nodes_[number].box.half.maxCoeff(&axis);
    const auto place = [&](int facet) {
      const Matrix<int, dim, 1> vertices = facets_.vertices.col(facet);
      return mesh_.vertices(axis, vertices).sum();
    };
    const Iterator middle = first + count / 2;
    std::nth_element(first, middle, last,
                     [&](int a, int b) { return place(a) < place(b); });
    add(first, middle);
    add(middle, last);
  }
  nodes_[number].beyond = nodes_.size();
}

template class FacetTree<FFCONTACT_DIMENSION>;

}  // namespace ffcontact
