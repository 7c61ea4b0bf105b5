// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace smart::compat {

/// Version and build of this library. Pictures are equal to the bit where it is.
std::string libraryIdentity();

} // namespace smart::compat
