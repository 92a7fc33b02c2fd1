// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/parallel/face_part.hpp"
//
#include "parallel/packet.hpp"

namespace ffcontact::plugin {

/// The part of a solid that another process relaxes.
void put(const FacePart& part, Packet& packet);
FacePart face_part_in(Packet& packet);

}  // namespace ffcontact::plugin
