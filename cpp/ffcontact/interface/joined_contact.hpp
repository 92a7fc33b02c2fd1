// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/interface/line_or_surface.hpp"

namespace ffcontact {

/// Several lines or surfaces of one mesh as one: their nodes, facets and what these face, one
/// after the other.
template <int d>
LineOrSurface<d> joined_contact(const std::vector<LineOrSurface<d>>& parts);

}  // namespace ffcontact
