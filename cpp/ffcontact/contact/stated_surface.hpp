// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/condensed/surface_trace.hpp"
#include "ffcontact/contact/stated_contact.hpp"

namespace ffcontact {

/// A problem on a surface, and how its nodes move.
struct StatedSurface : StatedContact<3> {
  /// All of them outlive it.
  StatedSurface(const ContactSurface& surface, const ContactLaw<3>& law,
                const ElasticSystem& system, const ContactSettings& settings,
                const SurfaceTrace& moved)
      : StatedContact<3>{surface,
                         law,
                         system,
                         settings,
                         {moved.held,
                          Matrix3Xd::Zero(3, surface.node_count())}},
        trace(moved) {}

  const SurfaceTrace& trace;
};

}  // namespace ffcontact
