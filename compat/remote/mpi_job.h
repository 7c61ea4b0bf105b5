// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "compat/mpi/mpi_component.h"

namespace smart::compat {

/// Whether this process shall render together with others that MPI started: the environment says
/// so, that of mpirun and the like or OPENRT_MPI (1: yes, 0: no). Never in set-uid programs.
bool isMpiAskedFor();

/// Opens libOpenRT-mpi, which starts MPI; nullptr: why is in `problem`.
MpiRanks* openMpi(std::string& problem);

} // namespace smart::compat
