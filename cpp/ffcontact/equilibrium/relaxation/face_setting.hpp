// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/tractions/contact_face.hpp"
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"

namespace ffcontact {

/// What a solid's face moments are relaxed for: the least
///     e^2 = |sigma_hat - sigma|^2 + 2 sum of contact_term
/// with r_hat in the cone.
struct FaceSetting {
  const Topology<3>& topology;
  const HookeTensors<3>& hooke;
  const FaceTractions& boundary;
  const BodyLoadsOfCells<3>& body_loads;
  const LinearStresses<3>& stress;  ///< sigma
  /// faces whose tractions, known in `boundary`, may change in the cone
  std::vector<ContactFace> contact = {};

  LoadedFacets<3> loaded() const {
    return {topology, hooke, boundary, body_loads, stress};
  }
};

}  // namespace ffcontact
