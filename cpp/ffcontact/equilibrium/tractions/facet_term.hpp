// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/tractions/wrench_basis.hpp"

namespace ffcontact {

/// What e^2 has beside the energies of the cells by the moments of a boundary facet, as the
/// error of springs there: where these change by b it grows by
///     b' H b + 2 g' b.
template <int d>
struct FacetTerm {
  int facet;
  FacetMatrix<d> H;
  FacetVector<d> g;
  double before;
};

/// V' H V, in the unknowns (w, y) of the facet.
template <int d>
FacetMatrix<d> form_of(const FacetTopology<d>& topology,
                       const FacetTerm<d>& term) {
  const FacetMatrix<d> V = wrench_basis<d>(topology.facet_corners(term.facet));
  return V.transpose() * term.H * V;
}

/// V' g
template <int d>
FacetVector<d> slope_of(const FacetTopology<d>& topology,
                        const FacetTerm<d>& term) {
  return wrench_basis<d>(topology.facet_corners(term.facet)).transpose() *
         term.g;
}

}  // namespace ffcontact
