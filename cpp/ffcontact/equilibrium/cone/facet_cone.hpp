// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/tractions/contact_facet.hpp"

namespace ffcontact {

/// Conditions C r >= d on the tractions (r_n, r_t) at the vertices of a contact facet, one
/// vertex after the other, which all that fulfil them have in the cone all along it:
/// EdgeCone in the plane, InnerCone at each vertex in space. Without friction r_t = 0 there
/// is no inequality: it is not in C.
template <int d>
struct FacetCone {
  Matrix<double, Dynamic, d * d> C;
  VectorXd least;
};

/// @param present  tractions in the cone, but for rounding: their conditions are met
/// @param largest  traction around, of which 1e-9 has no direction [MPa]
template <int d>
FacetCone<d> facet_cone(const ContactFacet<d>& facet,
                        const MatrixOf<d>& present, double largest);

/// How far tractions are out of the cone [MPa]; 0 in it. In space the largest of r_n and
/// |r_t| less its bound at the vertices: the cones are convex and their bounds concave. In
/// the plane the largest distance to a condition of EdgeCone.
template <int d>
double cone_violation(const ContactFacet<d>& facet,
                      const MatrixOf<d>& traction);

}  // namespace ffcontact
