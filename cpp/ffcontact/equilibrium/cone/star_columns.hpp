// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/energy/facet_forms.hpp"

namespace ffcontact {

/// Self-equilibrated corrections of some facets by a few unknowns t: their wrenches and modes
/// are Z t. Facets that are not among them stay.
template <int d>
struct StarColumns {
  std::vector<int> facet;  ///< ascending
  MatrixXd Z;              ///< [d^2 facets x unknowns]

  auto of_facet(int k) const {
    constexpr int size = CompositeElement<d>::moments;
    return Z.template middleRows<size>(size * k);
  }
};

/// The cells beside its facets, ascending.
template <int d>
std::vector<int> cells_beside(const Facets<d>& facets,
                              const std::vector<int>& some);

/// The columns with the modes of facets inside the body that make their energy the least.
/// @param form  takes their energy, Z' H Z
template <int d>
StarColumns<d> with_least_modes(const FacetTopology<d>& topology,
                                const FacetForms<d>& forms,
                                StarColumns<d> columns, MatrixXd& form);

/// Z' g
template <int d>
VectorXd restricted(const StarColumns<d>& columns, const FacetColumns<d>& g);

/// Adds Z t and takes what that changes from the residual, as add_around.
template <int d>
void add_columns(const FacetTopology<d>& topology, const FacetForms<d>& forms,
                 const StarColumns<d>& columns, const VectorXd& t,
                 FacetColumns<d>& corrections, FacetColumns<d>& residual);

}  // namespace ffcontact
