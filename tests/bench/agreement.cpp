// SPDX-License-Identifier: MIT
#include "tests/bench/agreement.h"

#include <algorithm>
#include <cmath>

namespace smart::bench {
namespace {

constexpr double kEdge = 0x1p-14;     ///< of a barycentric weight
constexpr double kTie = 0x1p-16;      ///< relative, between distances of different triangles
constexpr double kDistance = 0x1p-10; ///< relative, between distances of one triangle

enum class Crossing { None, Near, Clear };

struct Candidate {
    uint32_t triangle;
    double t;
    Crossing crossing;
};

/// The ray's line and one triangle in double. Near: within kEdge of an edge, on either side, or
/// along the plane.
Candidate cross(const std::vector<Triangle>& triangles, uint32_t number, const RayPacket& packet,
                int lane) {
    const Triangle& triangle = triangles[number];
    double a[3], e1[3], e2[3], d[3], n[3], p[3];
    for (int k = 0; k < 3; ++k) {
        d[k] = packet.dir[k][lane];
        a[k] = double(triangle.v0[k]) - packet.org[k][lane];
        e1[k] = double(triangle.v1[k]) - triangle.v0[k];
        e2[k] = double(triangle.v2[k]) - triangle.v0[k];
    }
    double den = 0, size = 0, length = 0, t = 0, u = 0, v = 0;
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        n[k] = e1[i] * e2[j] - e1[j] * e2[i];
        p[k] = d[i] * a[j] - d[j] * a[i];
        den += d[k] * n[k];
        size += n[k] * n[k];
        length += d[k] * d[k];
        t += a[k] * n[k];
        u -= p[k] * e2[k];
        v += p[k] * e1[k];
    }
    t /= den;
    u /= den;
    v /= den;
    const double least = std::min({u, v, 1 - u - v});
    Crossing crossing = least > kEdge ? Crossing::Clear : Crossing::Near;
    if (least < -kEdge) crossing = Crossing::None;
    if (!(std::abs(den) > 1e-6 * std::sqrt(size * length))) crossing = Crossing::Near;
    const double low = packet.tNear[lane], high = packet.tFar[lane];
    if (t < low * (1 - kTie) || t > high * (1 + kTie))
        crossing = Crossing::None;
    else if (crossing == Crossing::Clear && (t < low || t > high))
        crossing = Crossing::Near;
    if (std::abs(t) < 1e-6 && crossing == Crossing::Clear) crossing = Crossing::Near;
    return {number, t, crossing};
}

/// 0 right, 1 wrong, 2 at an edge.
int judge(std::span<const Candidate> candidates, uint32_t triangle, float t) {
    double clear = INFINITY, near = INFINITY; // nearest of each kind
    const Candidate* own = nullptr;
    for (const Candidate& c : candidates) {
        if (c.crossing == Crossing::Clear) clear = std::min(clear, c.t);
        if (c.crossing == Crossing::Near) near = std::min(near, c.t);
        if (c.triangle == triangle) own = &c;
    }
    if (triangle == kNoHit) return clear < INFINITY ? 1 : near < INFINITY ? 2 : 0;
    if (!own || own->crossing == Crossing::None) return 1;
    const double slack = std::abs(own->t) * kTie;
    if (clear < own->t - slack) return 1;
    if (own->crossing == Crossing::Near) return 2;
    if (!(std::abs(t - own->t) <= std::abs(own->t) * kDistance)) return 1;
    return near < own->t - slack ? 2 : 0;
}

void count(Mistakes& mistakes, int verdict) {
    mistakes.wrong += verdict == 1;
    mistakes.edge += verdict == 2;
}

void addCandidate(std::vector<Candidate>& candidates, const std::vector<Triangle>& triangles,
                  uint32_t number, const RayPacket& packet, int lane) {
    if (number >= triangles.size()) return;
    for (const Candidate& c : candidates) {
        if (c.triangle == number) return;
    }
    candidates.push_back(cross(triangles, number, packet, lane));
}

} // namespace

std::vector<Mistakes> judgeClosest(const std::vector<Triangle>& triangles, const RaySet& rays,
                                   std::span<const std::vector<Found>> found) {
    std::vector<Mistakes> mistakes(found.size());
    std::vector<Candidate> candidates;
    for (std::size_t p = 0; p < rays.packets.size(); ++p) {
        for (int lane = 0; lane < kPacketSize; ++lane) {
            if (!(rays.packets[p].active >> lane & 1)) continue;
            const uint32_t triangle = found[0][p].triangle[lane];
            const float t = found[0][p].t[lane];
            const bool agreed = std::all_of(found.begin(), found.end(), [&](const auto& answers) {
                const Found& f = answers[p];
                return f.triangle[lane] == triangle &&
                       (triangle == kNoHit || std::abs(f.t[lane] - t) <= kTie * std::abs(t));
            });
            if (agreed) continue;
            candidates.clear();
            for (const auto& answers : found) {
                addCandidate(candidates, triangles, answers[p].triangle[lane], rays.packets[p],
                             lane);
            }
            for (std::size_t e = 0; e < found.size(); ++e) {
                count(mistakes[e],
                      judge(candidates, found[e][p].triangle[lane], found[e][p].t[lane]));
            }
        }
    }
    return mistakes;
}

std::vector<Mistakes> judgeAny(const std::vector<Triangle>& triangles, const RaySet& rays,
                               std::span<const EnginePtr> engines,
                               std::span<const std::vector<uint32_t>> blocked) {
    std::vector<Mistakes> mistakes(blocked.size());
    std::vector<Candidate> candidates;
    std::vector<Found> named(rays.packets.size());
    for (std::size_t p = 0; p < rays.packets.size(); ++p) {
        uint32_t dispute = 0;
        for (const auto& answers : blocked) dispute |= answers[p] ^ blocked[0][p];
        for (int lane = 0; lane < kPacketSize; ++lane) {
            if (!(dispute & rays.packets[p].active & 1u << lane)) continue;
            candidates.clear();
            for (const EnginePtr& engine : engines) {
                engine->closest(rays, p, 1, named.data());
                addCandidate(candidates, triangles, named[p].triangle[lane], rays.packets[p], lane);
            }
            bool clear = false, near = false;
            for (const Candidate& c : candidates) {
                clear = clear || c.crossing == Crossing::Clear;
                near = near || c.crossing == Crossing::Near;
            }
            for (std::size_t e = 0; e < blocked.size(); ++e) {
                const bool says = blocked[e][p] >> lane & 1;
                if (clear)
                    count(mistakes[e], says ? 0 : 1);
                else
                    count(mistakes[e], near ? 2 : says ? 1 : 0);
            }
        }
    }
    return mistakes;
}

} // namespace smart::bench
