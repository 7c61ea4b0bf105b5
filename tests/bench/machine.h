// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace smart::bench {

/// The machine as the operating system names it: processor, cores, caches in bytes, load, and the
/// compiler of this program.
nlohmann::json machine();

} // namespace smart::bench
