// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

/// @param apart  [mm]
/// @throws std::invalid_argument  always: supports hold bonded bodies off each other
[[noreturn]] inline void refuse_held_apart(double apart,
                                           const std::string& place) {
  refuse("prescribed displacements hold what is bonded ", apart, " apart at ",
         place, ": make them the same on both sides, or free one of them");
}

}  // namespace ffcontact
