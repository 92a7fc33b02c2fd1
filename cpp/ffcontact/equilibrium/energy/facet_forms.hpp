// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <type_traits>
#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/equilibrium/energy/facet_energy.hpp"
#include "ffcontact/equilibrium/energy/tiled_factor.hpp"
#include "ffcontact/equilibrium/tractions/facet_term.hpp"

namespace ffcontact {

using Matrix9Xd = FacetColumns<3>;

/// facet_energy of every cell in the wrenches and modes of its facets, while it stays
/// balanced: the wrench on one facet is what balances the others (balancing_shift),
///     x = T z,   z = x without that wrench [9 or 30],   x' H x = z' (T' H T) z.
/// That facet is the largest, to which shifts are small: where its wrench vanishes, as
/// around a ridge of the others, terms of their square cancel.
///
/// Stored in single precision in space: the forms only steer a descent, whose corrections
/// are balanced by themselves. Products are of double precision: last digits of x turn
/// last digits of H x alone.
template <int d>
class FacetForms {
 public:
  using Element = CompositeElement<d>;
  /// Unknowns in z, those of the facets after the dependent one, then its modes; and the
  /// numbers that are stored of a cell.
  static constexpr int free_unknowns = Element::loads - Element::wrench;
  static constexpr Index stored =
      d == 2 ? free_unknowns * (free_unknowns + 1) / 2 + 1
             : factor_size(free_unknowns);
  using Stored = std::conditional_t<d == 2, double, float>;
  using Block = Matrix<Stored, Element::moments, Element::moments>;

  /// @param terms  added to the forms of the cells beside them
  FacetForms(const FacetTopology<d>& topology, const HookeTensors<d>& hooke,
             const std::vector<FacetTerm<d>>& terms = {});

  /// H x of one cell that x leaves balanced, but for what no such x has a product with: it
  /// is 0 for the dependent wrench.
  CellVector<d> times(int cell, const CellVector<d>& x) const;

  /// Block (k, l) of the form: the unknowns of facet k with those of facet l, 0 for the
  /// dependent wrench.
  Block block(int cell, int k, int l) const;

 private:
  void put_form(const CellForm<d, Stored>& H, int cell);
  const Stored* form(int cell) const { return forms_.get() + stored * cell; }

  Flags dependent_;  ///< the facet, 0 to d
  // Not a vector, which would be filled with zeros by one thread first.
  std::unique_ptr<Stored[]> forms_;
};

/// The unknowns of a cell's facets among those of all.
template <int d>
CellVector<d> unknowns_at(const Facets<d>& facets,
                          const FacetColumns<d>& of_all, int cell) {
  constexpr int size = CompositeElement<d>::moments;
  CellVector<d> unknowns;
  for (int k = 0; k <= d; ++k)
    unknowns.template segment<size>(size * k) =
        of_all.col(facets.of_cell(k, cell));
  return unknowns;
}

}  // namespace ffcontact
