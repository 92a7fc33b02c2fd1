// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/interface/contact_surface.hpp"

namespace ffcontact {

/// Several surfaces of one mesh, one after the other.
ContactSurface joined_surfaces(const std::vector<ContactSurface>& surfaces);

}  // namespace ffcontact
