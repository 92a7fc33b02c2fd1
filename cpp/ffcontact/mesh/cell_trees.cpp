// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/cell_trees.hpp"

#include <utility>

#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

constexpr int first_cell = -1, not_reached = -2;

template <int dim>
class GrowingTrees {
 public:
  explicit GrowingTrees(const Facets<dim>& facets) : facets_(facets) {
    const Index cells = facets.of_cell.cols();
    trees_.cell.reserve(cells);
    trees_.facet.assign(cells, not_reached);
  }

  bool has(int cell) const { return trees_.facet[cell] != not_reached; }
  void add(int cell, int facet) {
    if (has(cell)) return;
    trees_.facet[cell] = facet;
    trees_.cell.push_back(cell);
  }
  void add_part(int cell) {
    trees_.without_root.push_back(count_of(trees_.cell));
    add(cell, first_cell);
    grow();
  }
  /// All that hangs together with what is there.
  void grow() {
    for (; next_ < trees_.cell.size(); ++next_) {
      const int cell = trees_.cell[next_];
      for (int facet : facets_.of_cell.col(cell))
        for (int beside : facets_.cells.col(facet))
          if (beside >= 0) add(beside, facet);
    }
  }
  CellTrees take() {
    trees_.without_root.push_back(count_of(trees_.cell));
    return std::move(trees_);
  }

 private:
  const Facets<dim>& facets_;
  CellTrees trees_;
  std::size_t next_ = 0;
};

}  // namespace

template <int dim>
CellTrees cell_trees(const Facets<dim>& facets, const std::vector<int>& roots) {
  GrowingTrees<dim> trees(facets);
  for (int facet : roots) trees.add(facets.cells(0, facet), facet);
  trees.grow();
  for (int cell = 0; cell < facets.of_cell.cols(); ++cell)
    if (!trees.has(cell)) trees.add_part(cell);
  return trees.take();
}

template CellTrees cell_trees(const Facets<FFCONTACT_DIMENSION>&,
                              const std::vector<int>&);

}  // namespace ffcontact
