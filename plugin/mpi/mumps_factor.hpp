// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpi.h>

#include "parallel/processes.hpp"

namespace ffcontact::plugin {

/// By MUMPS: distributed entries (ICNTL(18) = 3) in the order in which they are given
/// (ICNTL(7) = 1), Schur's complement on process 0 (ICNTL(19) = 1), or, distributed, all of
/// its entries by blocks on a grid of processes (ICNTL(19) = 3).
/// @throws std::runtime_error  as Processes::factorised
std::unique_ptr<SharedFactor> mumps_factor(MPI_Comm communicator,
                                           MatrixPart part, int rows, int kept,
                                           Precision precision,
                                           SchurStorage storage);

}  // namespace ffcontact::plugin
