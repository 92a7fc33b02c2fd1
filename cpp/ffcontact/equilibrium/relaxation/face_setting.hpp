// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/tractions/contact_face.hpp"
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/equilibrium/tractions/solid_residual.hpp"

namespace ffcontact {

/// What a solid's face moments are relaxed for: the least
///     e^2 = |sigma_hat - sigma|^2 + 2 sum of contact_term
/// with r_hat in the cone.
struct FaceSetting {
  const SolidTopology& topology;
  const HookeTensors<3>& hooke;
  const FaceTractions& boundary;
  const SolidBodyLoadsOfAll& body_loads;
  const Matrix6Xd& stress;  ///< sigma, constant per tetrahedron [MPa]
  /// faces whose tractions, known in `boundary`, may change in the cone
  std::vector<ContactFace> contact = {};

  LoadedFacets<3> loaded() const {
    return {topology, hooke, boundary, body_loads, stress};
  }
};

}  // namespace ffcontact
