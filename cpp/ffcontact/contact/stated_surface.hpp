// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/checks/balance.hpp"
#include "ffcontact/contact/condensed/surface_trace.hpp"
#include "ffcontact/contact/contact_settings.hpp"

namespace ffcontact {

/// The problem as it was stated, and how its surface moves.
struct StatedSurface {
  const ContactSurface& surface;
  const SurfaceLaw& law;
  const ElasticSystem& system;
  const ContactSettings& settings;
  const SurfaceTrace& trace;
  const NodalLaw cones = nodal_law(law, surface);

  /// Forces of the nodes on all dofs.
  VectorXd load_of(const Matrix3Xd& force) const {
    return nodal_load(surface, force, system.dof_count());
  }
  /// v of a displacement on all dofs, with a layer under the forces of the nodes.
  VectorXd v_of(const VectorXd& displacement, const Matrix3Xd& force) const {
    return without(trace.held,
                   displacement_against_foundation(
                       surface, on_layer(law, lumped_pressures(surface, force)),
                       displacement))
        .reshaped();
  }
};

}  // namespace ffcontact
