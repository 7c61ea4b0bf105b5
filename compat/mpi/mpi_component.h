// SPDX-License-Identifier: MIT
// What libOpenRT asks of libOpenRT-mpi, which it opens when the program was started by MPI.
#pragma once

#include <chrono>
#include <cstddef>

#include "libsmart/remote/byte_codec.h"
#include "libsmart/remote/transport.h"
#include "openrt/version.h"

namespace smart::compat {

/// Messages between the ranks of a job. Rank 0 has all others as its peers, in their order; they
/// have rank 0 alone.
class MpiRanks : public Transport {
public:
    virtual unsigned rank() const = 0;
    virtual const ByteCodec& codec() const = 0;
    /// Ends MPI in this process, together with the other ranks; false: they did not join in, and
    /// for so long nothing moved between them.
    virtual bool finish(std::chrono::milliseconds timeout) noexcept = 0;
};

/// Both libraries have to be of one build: the interface between them is C++.
#define OPENRT_MPI_COMPONENT OPENRT_VERSION_STRING "/2"

/// Of the library's two symbols: openrtMpiComponent is the text above, openrtMpiOpen starts MPI.
/// nullptr: why is in `problem`. The result lives until the process ends.
using MpiOpen = MpiRanks* (*)(char* problem, std::size_t size);

} // namespace smart::compat
