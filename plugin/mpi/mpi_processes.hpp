// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parallel/processes.hpp"

namespace ffcontact::plugin {

/// The processes of an MPI communicator.
/// @param communicator  MPI_Comm*, as FreeFEM hands it to plugins
std::unique_ptr<Processes> mpi_processes(void* communicator);

}  // namespace ffcontact::plugin
