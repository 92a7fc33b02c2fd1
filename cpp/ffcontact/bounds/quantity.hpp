// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/stress/linear_stress.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// A quantity of interest that is linear in the displacement,
///     l(v) = int p . v + int q : eps(v) + int_boundary w . v + constant,
/// with p as composite stresses have body forces, q linear on each cell and w linear on each
/// labelled facet: stresses in equilibrium with l are exact then.
template <int d>
struct Quantity {
  BodyLoadsOfCells<d> body_loads;  ///< int p phi_i per cell
  LinearStresses<d> stress{};      ///< q; empty: 0
  FacetColumns<d> tractions;       ///< moments of w [d^2 x boundary]
  double constant = 0;
};

/// l of the hat functions [dofs]; constant apart.
template <int d>
VectorXd load_of(const SimplexMesh<d>& mesh, const Quantity<d>& quantity);

}  // namespace ffcontact
