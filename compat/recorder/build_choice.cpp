// SPDX-License-Identifier: MIT
#include "compat/recorder/build_choice.h"

namespace smart::compat {
namespace {

/// From so many rays a triangle on, the better tree pays: building it takes some 0.4
/// microseconds a triangle longer, while few rays are more than 0.05 slower through the fast one.
constexpr uint64_t kRaysOfTriangle = 8;

} // namespace

BuildQuality chooseQuality(BuildQuality hint, std::optional<uint64_t> raysSince,
                           std::size_t triangles) {
    if (hint != BuildQuality::DontCare || !raysSince) return hint;
    return *raysSince / kRaysOfTriangle < triangles ? BuildQuality::Fastest
                                                    : BuildQuality::DontCare;
}

} // namespace smart::compat
