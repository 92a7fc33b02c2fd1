// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "freefem/outputs.hpp"
#include "parallel/packet.hpp"
#include "parallel/shared_bodies.hpp"

/// What a call on process 0 gives the scripts of the others.
namespace ffcontact::plugin {

/// The outputs as one process gets them: arrays over cells and vertices are those of its
/// parts; all others are those of the whole.
template <int dim>
Outputs outputs_of(const Outputs& whole, const SharedBodies<dim>& bodies,
                   int rank);

void put(const Outputs& outputs, Packet& packet);
Outputs outputs_in(Packet& packet);

}  // namespace ffcontact::plugin
