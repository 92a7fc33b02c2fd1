// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/star_columns.hpp"

#include <algorithm>
#include <set>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/linear/dense/cholesky.hpp"

namespace ffcontact {

namespace {

/// The place of a facet in the columns, or -1.
int place_of(const std::vector<int>& facets, int facet) {
  const auto found = std::lower_bound(facets.begin(), facets.end(), facet);
  if (found == facets.end() || *found != facet) return -1;
  return static_cast<int>(found - facets.begin());
}

/// The energy of t and of modes inside the body, both columns of facets in a row.
template <int d>
class ModesInside {
 public:
  using Element = CompositeElement<d>;
  static constexpr int size = Element::moments, modes = Element::modes;

  ModesInside(const FacetTopology<d>& topology, const FacetForms<d>& forms,
              const StarColumns<d>& columns)
      : topology_(topology), forms_(forms), columns_(columns) {
    first_mode_.assign(columns.facet.size(), -1);
    int next = static_cast<int>(columns.Z.cols());
    for (std::size_t k = 0; k < first_mode_.size(); ++k)
      if (!topology.facets.on_boundary(columns.facet[k])) {
        first_mode_[k] = next;
        next += modes;
      }
    A_.setZero(next, next);
    for (int cell : cells_beside<d>(topology.facets, columns.facet))
      add_cell(cell);
  }

  /// Adds the least modes to the columns. @return the energy with them
  MatrixXd put(StarColumns<d>& columns) const {
    const Index given = columns.Z.cols(), inside = A_.rows() - given;
    const MatrixXd coupling = A_.bottomLeftCorner(inside, given),
                   least = -Cholesky(A_.bottomRightCorner(inside, inside))
                                .solve_columns(coupling);
    for (std::size_t k = 0; k < first_mode_.size(); ++k)
      if (first_mode_[k] >= 0)
        columns.Z.template middleRows<modes>(size * k + Element::wrench) +=
            least.middleRows<modes>(first_mode_[k] - given);
    return A_.topLeftCorner(given, given) + coupling.transpose() * least;
  }

 private:
  /// The unknowns of a cell's facets by t and the modes of those inside.
  struct OfCell {
    MatrixXd by_unknowns;
    std::vector<int> unknown;
    std::vector<int> side, place;  ///< of its facets in the columns
  };

  OfCell of_cell(int cell) const {
    OfCell of;
    for (int t = 0; t < columns_.Z.cols(); ++t) of.unknown.push_back(t);
    for (int side = 0; side <= d; ++side) {
      const int k =
          place_of(columns_.facet, topology_.facets.of_cell(side, cell));
      if (k < 0) continue;
      of.side.push_back(side);
      of.place.push_back(k);
      for (int mode = 0; mode < modes && first_mode_[k] >= 0; ++mode)
        of.unknown.push_back(first_mode_[k] + mode);
    }
    of.by_unknowns.setZero(size * count_of(of.side), count_of(of.unknown));
    Index next = columns_.Z.cols();
    for (int i = 0; i < count_of(of.side); ++i) {
      const int k = of.place[i];
      of.by_unknowns.block(size * i, 0, size, columns_.Z.cols()) =
          columns_.of_facet(k);
      if (first_mode_[k] < 0) continue;
      of.by_unknowns.template block<modes, modes>(
          size * i + Element::wrench, next) = MatrixXd::Identity(modes, modes);
      next += modes;
    }
    return of;
  }

  void add_cell(int cell) {
    const OfCell of = of_cell(cell);
    const int count = count_of(of.side);
    MatrixXd H(size * count, size * count);
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j)
        H.template block<size, size>(size * i, size * j) =
            forms_.block(cell, of.side[i], of.side[j]).template cast<double>();
    A_(of.unknown, of.unknown) +=
        of.by_unknowns.transpose() * H * of.by_unknowns;
  }

  const FacetTopology<d>& topology_;
  const FacetForms<d>& forms_;
  const StarColumns<d>& columns_;
  std::vector<int> first_mode_;  ///< unknown, -1 on the boundary
  MatrixXd A_;
};

}  // namespace

template <int d>
std::vector<int> cells_beside(const Facets<d>& facets,
                              const std::vector<int>& some) {
  std::set<int> cells;
  for (int f : some)
    for (int t : facets.cells.col(f))
      if (t >= 0) cells.insert(t);
  return {cells.begin(), cells.end()};
}

template <int d>
StarColumns<d> with_least_modes(const FacetTopology<d>& topology,
                                const FacetForms<d>& forms,
                                StarColumns<d> columns, MatrixXd& form) {
  const StarColumns<d> given = columns;
  form = ModesInside<d>(topology, forms, given).put(columns);
  return columns;
}

template <int d>
VectorXd restricted(const StarColumns<d>& columns, const FacetColumns<d>& g) {
  VectorXd t = VectorXd::Zero(columns.Z.cols());
  for (int k = 0; k < count_of(columns.facet); ++k)
    t += columns.of_facet(k).transpose() * g.col(columns.facet[k]);
  return t;
}

template <int d>
void add_columns(const FacetTopology<d>& topology, const FacetForms<d>& forms,
                 const StarColumns<d>& columns, const VectorXd& t,
                 FacetColumns<d>& corrections, FacetColumns<d>& residual) {
  constexpr int size = CompositeElement<d>::moments;
  FacetColumns<d> added(size, count_of(columns.facet));
  for (int k = 0; k < count_of(columns.facet); ++k) {
    added.col(k) = columns.of_facet(k) * t;
    corrections.col(columns.facet[k]) += added.col(k);
  }
  for (int cell : cells_beside<d>(topology.facets, columns.facet)) {
    CellVector<d> x = CellVector<d>::Zero();
    for (int side = 0; side <= d; ++side) {
      const int k =
          place_of(columns.facet, topology.facets.of_cell(side, cell));
      if (k >= 0) x.template segment<size>(size * side) = added.col(k);
    }
    const CellVector<d> image = forms.times(cell, x);
    for (int side = 0; side <= d; ++side)
      residual.col(topology.facets.of_cell(side, cell)) -=
          image.template segment<size>(size * side);
  }
}

template std::vector<int> cells_beside(const Facets<FFCONTACT_DIMENSION>&,
                                       const std::vector<int>&);
template StarColumns<FFCONTACT_DIMENSION> with_least_modes(
    const FacetTopology<FFCONTACT_DIMENSION>&,
    const FacetForms<FFCONTACT_DIMENSION>&, StarColumns<FFCONTACT_DIMENSION>,
    MatrixXd&);
template VectorXd restricted(const StarColumns<FFCONTACT_DIMENSION>&,
                             const FacetColumns<FFCONTACT_DIMENSION>&);
template void add_columns(const FacetTopology<FFCONTACT_DIMENSION>&,
                          const FacetForms<FFCONTACT_DIMENSION>&,
                          const StarColumns<FFCONTACT_DIMENSION>&,
                          const VectorXd&, FacetColumns<FFCONTACT_DIMENSION>&,
                          FacetColumns<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
