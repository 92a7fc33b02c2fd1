// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "problem/plane_bodies.hpp"
#include "problem/solid_bodies.hpp"

namespace ffcontact::plugin {

template <int d>
using BodiesOf = std::conditional_t<d == 2, PlaneBodies, SolidBodies>;

}  // namespace ffcontact::plugin
