// SPDX-License-Identifier: MIT
#include "tests/accuracy/case_run.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <mutex>
#include <sstream>
#include <thread>

#include "libsmart/kernel/kernels.h"

namespace smart::test {
namespace {

constexpr std::size_t kChunk = 4096;

struct Running {
    EnginePtr engine;
    std::size_t most; ///< rays
};

bool sameBits(const Claim& a, const Claim& b) {
    if (a.triangle != b.triangle) return false;
    if (a.triangle == kNoHit) return true;
    const auto bits = [](float x) { return std::bit_cast<uint32_t>(x); };
    return bits(a.t) == bits(b.t) && bits(a.u) == bits(b.u) && bits(a.v) == bits(b.v);
}

} // namespace

CaseResult runCase(const NamedCase& named, const std::vector<EngineKind>& kinds,
                   const RunSize& size) {
    const auto start = std::chrono::steady_clock::now();
    const HardCase made = named.make();
    CaseResult result;
    result.name = named.name;
    result.triangles = made.geometry.triangles();
    result.promise = made.promise;
    ExactReference reference;
    made.geometry.addTo(reference);
    const ExactScene scene(reference);
    const std::size_t rayCount =
        std::min(made.most, std::max<std::size_t>(1, std::size_t(double(size.rays) * made.share)));

    std::vector<Running> engines;
    std::vector<std::vector<Variant>> variants;
    for (const EngineKind& kind : kinds) {
        if (kind.aborts && made.abortsPeers) continue;
        EnginePtr engine = kind.make(made.geometry);
        if (!engine) continue;
        const std::size_t most = kind.bruteForce
                                     ? std::max<std::size_t>(1, size.bruteTests / result.triangles)
                                     : rayCount;
        engines.push_back({std::move(engine), std::min(most, rayCount)});
        result.engines.push_back({kind.name, kind.mode, {}});
        if (kind.mode < 0 || size.identityRays == 0) continue;
        variants.push_back(openrtVariants(made.geometry, kind.mode));
        result.identities.push_back({modeName(kind.mode), variants.back().size(), 0, 0});
    }

    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    const auto work = [&] {
        std::vector<Tally> tallies(engines.size());
        std::vector<Identity> identities(variants.size());
        std::vector<Claim> claims(kChunk), others(kChunk);
        std::vector<Truth> truths(kChunk);
        for (;;) {
            const std::size_t first = next.fetch_add(kChunk);
            if (first >= rayCount) break;
            const std::size_t count = std::min(kChunk, rayCount - first);
            const std::vector<Ray> rays = made.rays(count, size.seed * 0x9E3779B97F4A7C15u + first);
            for (std::size_t i = 0; i < count; ++i) truths[i] = scene.nearest(rays[i]);
            for (std::size_t e = 0; e < engines.size(); ++e) {
                if (first >= engines[e].most) continue;
                const std::size_t asked = std::min(count, engines[e].most - first);
                engines[e].engine->trace(std::span(rays).first(asked), claims.data());
                for (std::size_t i = 0; i < asked; ++i) {
                    tallies[e].add(scene, truths[i], rays[i], claims[i]);
                }
            }
            if (first >= size.identityRays) continue;
            const std::size_t asked = std::min(count, size.identityRays - first);
            for (std::size_t m = 0; m < variants.size(); ++m) {
                std::vector<uint8_t> differs(asked);
                for (std::size_t v = 0; v < variants[m].size(); ++v) {
                    Claim* const into = v == 0 ? claims.data() : others.data();
                    variants[m][v].engine->trace(std::span(rays).first(asked), into);
                    for (std::size_t i = 0; i < asked && v > 0; ++i) {
                        differs[i] = differs[i] || !sameBits(claims[i], others[i]);
                    }
                }
                identities[m].rays += asked;
                identities[m].differing +=
                    std::size_t(std::count(differs.begin(), differs.end(), uint8_t(1)));
            }
        }
        const std::lock_guard lock(mutex);
        for (std::size_t e = 0; e < engines.size(); ++e) result.engines[e].tally.add(tallies[e]);
        for (std::size_t m = 0; m < identities.size(); ++m) {
            result.identities[m].rays += identities[m].rays;
            result.identities[m].differing += identities[m].differing;
        }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < size.threads; ++i) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

std::string broken(const CaseResult& result) {
    std::ostringstream text;
    const auto accuse = [&](const EngineTally& entry, const char* of) {
        text << result.name << ": " << entry.engine << ' ' << of << ": " << entry.tally.counts
             << '\n';
    };
    for (const EngineTally& entry : result.engines) {
        const VerdictCounts& counts = entry.tally.counts;
        if (entry.mode == int(Precision::Watertight)) {
            if (result.promise != Promise::None && counts.lost() > 0) accuse(entry, "lost rays");
            if (result.promise == Promise::Right && counts.wrong() > 0) accuse(entry, "erred");
            if (result.promise != Promise::None && entry.tally.beyondHalfT > 0)
                accuse(entry, "did not round t correctly");
        }
        if (entry.mode > int(Precision::Watertight)) {
            if (counts[Verdict::Right] != counts.rays) accuse(entry, "is not exact");
            if (entry.tally.beyondHalfT > 0 || entry.tally.beyondHalfUv > 0)
                accuse(entry, "did not round correctly");
        }
    }
    for (const Identity& identity : result.identities) {
        const bool promised = identity.mode == modeName(int(Precision::Watertight))
                                  ? result.promise != Promise::None
                                  : identity.mode != modeName(int(Precision::Fast));
        if (promised && identity.differing > 0) {
            text << result.name << ": " << identity.mode << ": " << identity.differing << " of "
                 << identity.rays << " rays differ between instruction sets or forms\n";
        }
    }
    return text.str();
}

} // namespace smart::test
