// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/hooke.hpp"

namespace ffcontact {

/// What an estimate is made of fits together and is finite, as far as bodies in the plane
/// and solids have it in common.
/// @param multiplier  what the contact carries at its nodes, of the name given
template <class Solved>
void require_sound_body(const Solved& solved, Index nodes,
                        const std::string& name,
                        const Ref<const MatrixXd>& multiplier) {
  const auto& mesh = solved.topology.mesh;
  const auto& body = solved.body;
  const Index dofs = mesh.vertices.size();
  require_elliptic(body.hooke, mesh.cell_count());
  require_size("A", solved.system.dof_count(), dofs);
  require_size("u", body.displacement.size(), dofs);
  require_finite("u", body.displacement);
  require_size(name + "s", multiplier.cols(), nodes);
  require_finite(name, multiplier.reshaped());
  require_size("body loads", body.body_loads.cols(), mesh.cell_count());
  require_finite("body load", body.body_loads.reshaped());
  require_valid(body.initial, mesh.cell_count());
}

}  // namespace ffcontact
