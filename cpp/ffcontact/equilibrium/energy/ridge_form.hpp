// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/energy/facet_forms.hpp"
#include "ffcontact/equilibrium/tractions/facet_tractions.hpp"

namespace ffcontact {

/// The self-equilibrated corrections of the m facets around a ridge: one wrench w that all
/// of them carry and the modes of each, x = (w, y_1, .., y_m) [r + (d^2 - r) m], which
/// WrenchShift makes the unknowns of the facets, Z x.
template <int d>
int unknowns_around(const Ridges<d>& ridges, int ridge) {
  return CompositeElement<d>::wrench +
         CompositeElement<d>::modes * ridges.facet_count(ridge);
}

/// The m facets.
template <int d>
std::vector<int> facets_around(const Ridges<d>& ridges, int ridge) {
  const auto facets = ridges.facets_of(ridge);
  return {facets.begin(), facets.end()};
}

/// A cell at a ridge with its two facets there.
struct Wedge {
  int cell;
  int place[2];  ///< among the facets around the ridge
  int local[2];  ///< among those of the cell
};
template <int d>
std::vector<Wedge> wedges_of(const FacetTopology<d>& topology, int ridge);

/// wrench_shift of the m facets.
template <int d>
using WrenchShifts = std::vector<WrenchShift<d>>;
template <int d>
WrenchShifts<d> shifts_around(const FacetTopology<d>& topology, int ridge);

/// A = Z' H Z, their energy.
/// @param shifts  of the m facets
template <int d>
MatrixXd ridge_form(const FacetTopology<d>& topology, int ridge,
                    const WrenchShift<d>* shifts, const FacetForms<d>& forms);

/// Z_a' H Z_b of two ridges, over the cells at both.
/// @param shifts_a, shifts_b  of the facets around each
template <int d>
MatrixXd coupling_form(const FacetTopology<d>& topology, int a,
                       const WrenchShift<d>* shifts_a, int b,
                       const WrenchShift<d>* shifts_b,
                       const FacetForms<d>& forms);

/// Rows that are zero for corrections that leave known boundary tractions alone.
/// @param shifts      of the m facets
/// @param directions  known alone
template <int d>
MatrixXd ridge_conditions(const FacetTopology<d>& topology, int ridge,
                          const WrenchShift<d>* shifts,
                          const KnownTractions<d>& known,
                          const KnownDirections<d>& directions = {});

/// Z' g
template <int d>
VectorXd restricted(const FacetTopology<d>& topology, int ridge,
                    const FacetColumns<d>& g);

/// Z x of the facet at a place among those around the ridge: its wrench and its modes.
template <int d>
FacetVector<d> at_place(const FacetTopology<d>& topology, int ridge, int place,
                        const VectorXd& x);

/// Adds the corrections x around a ridge and takes what they change from the residual,
/// -(g + H x) of all facets.
template <int d>
void add_around(const FacetTopology<d>& topology, const FacetForms<d>& forms,
                int ridge, const VectorXd& x, FacetColumns<d>& corrections,
                FacetColumns<d>& residual);

}  // namespace ffcontact
