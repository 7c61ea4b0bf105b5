// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace smart {

/// What the linker calls the library or program that this code is part of, in hexadecimal digits;
/// empty where it gave it no name.
std::string buildId();

} // namespace smart
