// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/estimate/bodies/solved_body.hpp"
#include "ffcontact/interface/bonded_line.hpp"

namespace ffcontact {

/// The solution on a line along which no directions of what is bonded turn: the force on a node
/// is shared among those that take its place by their lengths, so that r_hat may jump at
/// corners and is linear on edges.
SolvedBody<2> unturned_body(const SolvedProblem<2>& solved,
                            const UnturnedLine& unturned);

}  // namespace ffcontact
