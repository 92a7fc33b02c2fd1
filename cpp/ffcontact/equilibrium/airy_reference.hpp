// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/equilibrium/composite_stress.hpp"

namespace ffcontact {

/// On the reference triangle (0,0), (1,0), (0,1) the unknowns of an Airy function
/// (AirySpace) are (A, A_xi, A_eta) at the vertices and, in the middle of each edge e, the
/// derivative along e turned to the right, outwards and as long as e.
using ReferenceUnknowns = Matrix<double, 12, 1>;
/// Corner stresses (CompositeStress by columns) of each unknown.
using ReferenceStress = Matrix<double, 27, 12>;
using ReferenceEnergy = Matrix<double, 12, 12>;

/// Computed once.
const ReferenceStress& reference_stress();

/// S with x' S x = sum over p, q of W_pq int s_p s_q over the reference triangle, s the
/// stress of the unknowns x in Voigt order.
/// @param W  symmetric
ReferenceEnergy weighted_products(const Matrix3d& W);

/// Corner values times the mass matrix of their subtriangle, A/12 (1 + delta), for a
/// triangle of area 3 A.
CompositeStress massed(const CompositeStress& values, double area);

}  // namespace ffcontact
