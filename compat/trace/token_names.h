// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace smart::compat {

/// How the headers call a token; nullptr: several things have this value, or none.
const char* tokenName(uint32_t value);

} // namespace smart::compat
