// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/conformance/conformance_case.h"

namespace conformance {

// Why programs would run without this library: ld.so passes over in silence what it can not load.
// Empty: they would run with it.
std::string faultOfLibrary(const std::string& file);

// What programs on OpenRT get beside `others`, so that they run with the library of the settings.
std::vector<std::string> withLibrary(const Settings& settings,
                                     std::vector<std::string> others = {});

} // namespace conformance
