// SPDX-License-Identifier: MIT
#include "libsmart/render/point_values.h"

#include <cstddef>
#include <cstring>

namespace smart {
namespace {

/// Where a value lies; members of a value follow one another.
struct Place {
    uint32_t value;
    std::size_t inPacket; ///< each number of the point is an array of lanes there
    std::size_t inState;
    std::size_t numbers; ///< of four bytes
};
constexpr Place kPlaces[] = {
    {RTS_READS_RAY, offsetof(RTSpacket, rayOrigin), offsetof(RTSstate, rayOrigin), 7},
    {RTS_READS_POSITION, offsetof(RTSpacket, position), offsetof(RTSstate, position), 3},
    {RTS_READS_NORMAL, offsetof(RTSpacket, geometricNormal), offsetof(RTSstate, geometricNormal),
     3},
    {RTS_READS_SHADING_NORMAL, offsetof(RTSpacket, shadingNormal),
     offsetof(RTSstate, shadingNormal), 3},
    {RTS_READS_RAW_NORMAL, offsetof(RTSpacket, rawNormal), offsetof(RTSstate, rawNormal), 3},
    {RTS_READS_BARYCENTRIC, offsetof(RTSpacket, barycentric), offsetof(RTSstate, barycentric), 3},
    {RTS_READS_TEXCOORD, offsetof(RTSpacket, texCoord), offsetof(RTSstate, texCoord), 4},
    {RTS_READS_COLOR, offsetof(RTSpacket, color), offsetof(RTSstate, color), 4},
    {RTS_READS_IDS, offsetof(RTSpacket, object), offsetof(RTSstate, object), 3},
    {RTS_READS_PIXEL, offsetof(RTSpacket, pixel), offsetof(RTSstate, pixel), 3},
    {RTS_READS_FOOTPRINT, offsetof(RTSpacket, footprint), offsetof(RTSstate, footprint), 2}};

constexpr std::size_t kNumber = 4;
static_assert(sizeof(RTSfloats) == kNumber * RTS_PACKET_SIZE &&
              sizeof(RTSids) == kNumber * RTS_PACKET_SIZE);
static_assert(offsetof(RTSpacket, rayDistance) - offsetof(RTSpacket, rayOrigin) ==
                  6 * sizeof(RTSfloats) &&
              offsetof(RTSpacket, primitive) - offsetof(RTSpacket, object) == 2 * sizeof(RTSids) &&
              offsetof(RTSpacket, sample) - offsetof(RTSpacket, pixel) == 2 * sizeof(RTSids) &&
              offsetof(RTSpacket, texCoordDensity) - offsetof(RTSpacket, footprint) ==
                  sizeof(RTSfloats));
static_assert(
    offsetof(RTSstate, rayDistance) - offsetof(RTSstate, rayOrigin) == 6 * kNumber &&
    offsetof(RTSstate, primitive) - offsetof(RTSstate, object) == 2 * kNumber &&
    offsetof(RTSstate, sample) - offsetof(RTSstate, pixel) == 2 * kNumber &&
    offsetof(RTSstate, texCoordDensity) - offsetof(RTSstate, footprint) == kNumber);

template <class Function>
void forEachPlace(uint32_t values, Function&& function) {
    for (const Place& place : kPlaces)
        if (values & place.value) function(place);
}

std::byte* bytesOf(void* points) {
    return static_cast<std::byte*>(points);
}

} // namespace

void clearValues(RTSpacket& points, uint32_t values) {
    if (values == 0) return;
    forEachPlace(values, [&](const Place& place) {
        std::memset(bytesOf(&points) + place.inPacket, 0, place.numbers * sizeof(RTSfloats));
    });
    if (values & RTS_READS_NORMAL) points.frontFace = 0;
}

void clearValues(RTSstate& point, uint32_t values) {
    forEachPlace(values, [&](const Place& place) {
        std::memset(bytesOf(&point) + place.inState, 0, place.numbers * kNumber);
    });
    if (values & RTS_READS_NORMAL) point.frontFace = 0;
}

void copyValues(const RTSpacket& from, int lane, uint32_t values, RTSpacket& to) {
    const auto* const source = reinterpret_cast<const std::byte*>(&from);
    forEachPlace(values, [&](const Place& place) {
        const std::size_t first = place.inPacket + std::size_t(lane) * kNumber;
        for (std::size_t i = 0; i < place.numbers; ++i)
            std::memcpy(bytesOf(&to) + first + i * sizeof(RTSfloats),
                        source + first + i * sizeof(RTSfloats), kNumber);
    });
    const uint32_t bit = 1u << lane;
    if (values & RTS_READS_NORMAL) to.frontFace = (to.frontFace & ~bit) | (from.frontFace & bit);
}

} // namespace smart
