// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpi.h>

#include "parallel/processes.hpp"

namespace ffcontact::plugin {

/// By MUMPS: distributed entries (ICNTL(18) = 3) in the order in which they are given
/// (ICNTL(7) = 1), Schur's complement on process 0 (ICNTL(19) = 1).
/// @throws std::runtime_error  as Processes::factorised
std::unique_ptr<SharedFactor> mumps_factor(MPI_Comm communicator,
                                           MatrixPart part, int rows, int kept,
                                           Precision precision);

}  // namespace ffcontact::plugin
