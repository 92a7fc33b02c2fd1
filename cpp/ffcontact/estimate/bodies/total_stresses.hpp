// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/stress/linear_stress.hpp"

namespace ffcontact {

/// sigma = C eps(u) + tau0.
/// @param body  SolvedBody<2> or SolvedBody<3>
template <int d, class Body>
LinearStresses<d> total_stresses(const SimplexMesh<d>& mesh, const Body& body,
                                 const Ref<const VectorXd>& displacement) {
  return LinearStresses<d>(stresses(mesh, body.hooke, displacement)) +
         body.initial;
}

}  // namespace ffcontact
