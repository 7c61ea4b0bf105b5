// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "compat/recorder/frame_settings.h"

namespace smart::compat {

/// Which builder an object gets. Where the library is to choose, an object defined for the first
/// time is expected to stay, and gets the tree by the surface area heuristic. One that is defined
/// anew, or updated, is expected to get as many rays from now on as it can have got since it was
/// built last (`raysSince`: camera rays of all frames started meanwhile, all other rays of those
/// that ended, and those of queries); the fast builder is
/// chosen where these are so few that tracing them takes less longer than building takes shorter.
BuildQuality chooseQuality(BuildQuality hint, std::optional<uint64_t> raysSince,
                           std::size_t triangles);

} // namespace smart::compat
