// SPDX-License-Identifier: MIT
#include "tests/bench/agreement.h"

#include <algorithm>
#include <cmath>

namespace smart::bench {
namespace {

constexpr double kSameDistance = 0x1p-16; // relative, between answers that name one triangle
constexpr std::size_t kSample = 50'021;   // of rays on which all agree every so many-th is judged

void count(Mistakes& mistakes, Verdict verdict) {
    mistakes.wrong += verdict == Verdict::Wrong;
    mistakes.ties += verdict == Verdict::Tie;
}

Ray rayOf(const RayPacket& packet, int lane) {
    return {{packet.org[0][lane], packet.org[1][lane], packet.org[2][lane]},
            {packet.dir[0][lane], packet.dir[1][lane], packet.dir[2][lane]},
            packet.tNear[lane],
            packet.tFar[lane]};
}

} // namespace

std::vector<Mistakes> judgeClosest(const Truth& truth, const RaySet& rays,
                                   std::span<const std::vector<Found>> found) {
    std::vector<Mistakes> mistakes(found.size());
    for (std::size_t p = 0; p < rays.packets.size(); ++p) {
        for (int lane = 0; lane < kPacketSize; ++lane) {
            if (!(rays.packets[p].active >> lane & 1)) continue;
            const uint32_t triangle = found[0][p].triangle[lane];
            const float t = found[0][p].t[lane];
            const bool agreed = std::all_of(found.begin(), found.end(), [&](const auto& answers) {
                const Found& f = answers[p];
                return f.triangle[lane] == triangle &&
                       (triangle == kNoHit || std::abs(f.t[lane] - t) <= kSameDistance * t);
            });
            if (agreed && (p * kPacketSize + std::size_t(lane)) % kSample != 0) continue;
            const Ray ray = rayOf(rays.packets[p], lane);
            for (std::size_t e = 0; e < found.size(); ++e) {
                const Found& f = found[e][p];
                count(mistakes[e], truth.closest(ray, f.triangle[lane], f.t[lane]));
            }
        }
    }
    return mistakes;
}

std::vector<Mistakes> judgeAny(const Truth& truth, const RaySet& rays,
                               std::span<const std::vector<uint32_t>> blocked) {
    std::vector<Mistakes> mistakes(blocked.size());
    for (std::size_t p = 0; p < rays.packets.size(); ++p) {
        uint32_t judged = 0;
        for (const auto& answers : blocked) judged |= answers[p] ^ blocked[0][p];
        if (p % (kSample / kPacketSize) == 0) judged |= 1u << p % kPacketSize;
        judged &= rays.packets[p].active;
        for (int lane = 0; lane < kPacketSize; ++lane) {
            if (!(judged >> lane & 1)) continue;
            const Ray ray = rayOf(rays.packets[p], lane);
            const Verdict verdicts[2] = {truth.any(ray, false), truth.any(ray, true)};
            for (std::size_t e = 0; e < blocked.size(); ++e)
                count(mistakes[e], verdicts[blocked[e][p] >> lane & 1]);
        }
    }
    return mistakes;
}

} // namespace smart::bench
