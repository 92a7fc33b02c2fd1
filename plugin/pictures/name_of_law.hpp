// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ffcontact::plugin {

/// What pictures call the law of a line or surface.
template <class Law>
const char* name_of_law(const Law& law) {
  if (law.slides_nowhere()) return "bonded";
  return law.slip_bound.size() > 0 ? "tresca" : "coulomb";
}

}  // namespace ffcontact::plugin
