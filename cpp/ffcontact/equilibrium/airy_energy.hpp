// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/equilibrium/airy_function.hpp"

namespace ffcontact {

/// The energy of one triangle when its stress changes by that of an Airy function with
/// local unknowns x:
///     int tau : C^-1 tau   grows by   x' K x + 2 g' x,   tau the composite stress before [N/mm times mm].
/// K by 3 x 3 blocks, symmetric and with the constant and linear functions in its kernel;
/// all indices count modulo three.
struct AiryEnergy {
  Matrix3d own[3];     ///< vertex k with itself
  Matrix3d next[3];    ///< vertex k (rows) with vertex k + 1
  Matrix3d edge[3];    ///< edge k with vertex k + r in column r
  Vector3d edge_own;   ///< edge k with itself
  Vector3d edge_next;  ///< edge k with edge k + 1
  LocalAiry slope;     ///< g
  double before;       ///< int tau : C^-1 tau

  LocalAiry times(const LocalAiry& x) const;  ///< K x
};

/// The sum of products of all unknowns.
inline double dot(const LocalAiry& x, const LocalAiry& y) {
  return x.at_vertices.cwiseProduct(y.at_vertices).sum() +
         x.on_edges.dot(y.on_edges);
}

/// @param compliance  C^-1 in Voigt order with engineering shear [1/MPa]
/// @param difference  edge loads of tau
/// @param body_loads  body loads of tau
AiryEnergy airy_energy(const AirySpace& space, int triangle,
                       const Matrix3d& compliance, const EdgeLoads& difference,
                       const BodyLoads& body_loads);

}  // namespace ffcontact
