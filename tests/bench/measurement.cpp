// SPDX-License-Identifier: MIT
#include "tests/bench/measurement.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <barrier>
#include <chrono>
#include <ctime>
#include <numeric>
#include <thread>

namespace smart::bench {
namespace {

constexpr std::size_t kChunk = 256;      // packets that a thread takes at a time
constexpr std::size_t kFirstLook = 8;    // one of so many chunks is traced at the first look
constexpr double kAmongFastest = 0.85;   // of the fastest peer at the first look
constexpr std::size_t kMostPeers = 4;    // of each kind, plain and robust

double processorSeconds() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// The calling thread stays on the n-th processor that the program may use.
void pin(unsigned n) {
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0 || CPU_COUNT(&allowed) == 0) return;
    unsigned left = n % unsigned(CPU_COUNT(&allowed));
    for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
        if (!CPU_ISSET(cpu, &allowed) || left-- > 0) continue;
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(cpu, &one);
        pthread_setaffinity_np(pthread_self(), sizeof one, &one);
        return;
    }
}

struct Seconds {
    double clock;     ///< from the moment when all threads are ready to the end of the last
    double processor; ///< of all threads together
};

template <typename Work>
Seconds timed(const Engine& engine, std::size_t packets, unsigned threads, const Work& work) {
    std::atomic<std::size_t> next{0};
    auto start = std::chrono::steady_clock::now();
    const auto begin = [&start]() noexcept { start = std::chrono::steady_clock::now(); };
    std::barrier ready(std::ptrdiff_t(threads), begin);
    std::vector<double> busy(threads);
    std::vector<std::thread> workers;
    for (unsigned i = 0; i < threads; ++i) {
        workers.emplace_back([&, i] {
            if (threads > 1) pin(i);
            engine.enterThread();
            ready.arrive_and_wait();
            const double entered = processorSeconds();
            for (;;) {
                const std::size_t first = next.fetch_add(kChunk);
                if (first >= packets) break;
                work(first, std::min(kChunk, packets - first));
            }
            busy[i] = processorSeconds() - entered;
        });
    }
    for (std::thread& worker : workers) worker.join();
    const std::chrono::duration<double> clock = std::chrono::steady_clock::now() - start;
    return {clock.count(), std::accumulate(busy.begin(), busy.end(), 0.0)};
}

/// What one engine says about a set of rays.
struct Answers {
    std::vector<Found> found;
    std::vector<uint32_t> blocked;
};

Seconds trace(Engine& engine, const RaySet& rays, Query query, unsigned threads, Answers& answers) {
    const std::size_t packets = rays.packets.size();
    if (query == Query::Closest) answers.found.resize(packets);
    if (query == Query::Any) answers.blocked.resize(packets);
    engine.load(rays, query);
    const Seconds seconds =
        timed(engine, packets, threads, [&](std::size_t first, std::size_t count) {
            if (query == Query::Closest)
                engine.closest(rays, first, count, answers.found.data());
            else
                engine.any(rays, first, count, answers.blocked.data());
        });
    engine.unload(rays, answers.found.data(), answers.blocked.data());
    return seconds;
}

double mrays(const RaySet& rays, double seconds) {
    return double(rays.active) / std::max(seconds, 1e-9) * 1e-6;
}

RaySet part(const RaySet& rays) {
    RaySet some;
    for (std::size_t p = 0; p < rays.packets.size(); ++p) {
        if (p / kChunk % kFirstLook == 0) some.add(rays.packets[p]);
    }
    return some;
}

/// Which engines are worth measuring: all of ours, and the fastest peers.
std::vector<std::size_t> firstLook(const RaySet& rays, Query query,
                                   std::span<const EnginePtr> engines,
                                   std::vector<Result>& results, const Progress& progress) {
    const RaySet some = part(rays);
    Answers answers;
    for (std::size_t e = 0; e < engines.size(); ++e) {
        progress("first look: " + engines[e]->name());
        for (int turn = 0; turn < 3; ++turn) {
            const double speed =
                mrays(some, trace(*engines[e], some, query, 1, answers).processor);
            if (turn > 0) results[e].firstLook = std::max(results[e].firstLook, speed);
        }
    }
    std::vector<std::size_t> chosen;
    for (const bool robust : {false, true}) {
        std::vector<std::size_t> peers;
        for (std::size_t e = 0; e < engines.size(); ++e)
            if (results[e].peer && results[e].robust == robust) peers.push_back(e);
        std::sort(peers.begin(), peers.end(), [&](std::size_t a, std::size_t b) {
            return results[a].firstLook > results[b].firstLook;
        });
        for (std::size_t i = 0; i < std::min(peers.size(), kMostPeers); ++i) {
            if (results[peers[i]].firstLook >= kAmongFastest * results[peers[0]].firstLook)
                chosen.push_back(peers[i]);
        }
    }
    for (std::size_t e = 0; e < engines.size(); ++e)
        if (!results[e].peer) chosen.push_back(e);
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

void judge(const Truth& truth, const RaySet& rays, Query query,
           const std::vector<std::size_t>& chosen, std::vector<Answers>& answers,
           const Answers* referee, std::vector<Result>& results) {
    std::vector<Mistakes> mistakes;
    if (query == Query::Closest) {
        std::vector<std::vector<Found>> found;
        for (const std::size_t e : chosen) found.push_back(std::move(answers[e].found));
        if (referee) found.push_back(referee->found);
        mistakes = judgeClosest(truth, rays, found);
    } else {
        std::vector<std::vector<uint32_t>> blocked;
        for (const std::size_t e : chosen) blocked.push_back(std::move(answers[e].blocked));
        if (referee) blocked.push_back(referee->blocked);
        mistakes = judgeAny(truth, rays, blocked);
    }
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        results[chosen[i]].mistakes.wrong += mistakes[i].wrong;
        results[chosen[i]].mistakes.ties += mistakes[i].ties;
    }
}

double medianRatio(const std::vector<double>& values, const std::vector<double>& others) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(values.size(), others.size()); ++i)
        ratios.push_back(values[i] / others[i]);
    return medianOf(std::move(ratios));
}

} // namespace

const char* nameOf(Kind kind) {
    switch (kind) {
    case Kind::Primary: return "primary";
    case Kind::Shadow: return "shadow";
    case Kind::Ao: return "ao";
    case Kind::Bounce: break;
    }
    return "bounce";
}

Query queryOf(Kind kind) {
    return kind == Kind::Primary || kind == Kind::Bounce ? Query::Closest : Query::Any;
}

bool coherent(Kind kind) {
    return kind == Kind::Primary || kind == Kind::Shadow;
}

double medianOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    if (n == 0) return 0;
    return n % 2 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

double Result::median() const {
    return medianOf(mraysPerSecond);
}

const Result* Series::bestPeer(bool robustOnly) const {
    const Result* best = nullptr;
    for (const Result& result : results) {
        if (!result.peer || result.mraysPerSecond.empty() || (robustOnly && !result.robust))
            continue;
        if (!best || result.median() > best->median()) best = &result;
    }
    return best;
}

double ratio(const Result& result, const Result& other) {
    return medianRatio(result.mraysPerSecond, other.mraysPerSecond);
}

double gain(const Result& several, const Result& one) {
    return medianRatio(several.undisturbed, one.undisturbed);
}

std::vector<Series> measure(const Truth& truth, const Plan& plan,
                            std::span<const EnginePtr> engines, const Progress& progress) {
    const Query query = queryOf(plan.kind);
    std::vector<Result> fresh;
    for (const EnginePtr& engine : engines) {
        Result& result = fresh.emplace_back();
        result.engine = engine->name();
        result.peer = engine->peer();
        result.robust = engine->robust();
    }
    const std::vector<std::size_t> chosen =
        firstLook(plan.rays(0), query, engines, fresh, progress);
    std::vector<Series> all;
    for (const unsigned threads : plan.threads) all.push_back({plan.kind, threads, 0, fresh});
    for (unsigned repeat = 1; repeat <= plan.repeats; ++repeat) {
        const RaySet rays = plan.rays(repeat);
        Answers referee;
        if (plan.referee) trace(*plan.referee, rays, query, 1, referee);
        for (Series& series : all) {
            std::vector<Answers> answers(engines.size());
            for (const std::size_t e : chosen) {
                progress(std::string(nameOf(plan.kind)) + ", " + std::to_string(series.threads) +
                         " thread(s), repeat " + std::to_string(repeat) + " of " +
                         std::to_string(plan.repeats) + ": " + engines[e]->name());
                const Seconds seconds =
                    trace(*engines[e], rays, query, series.threads, answers[e]);
                Result& result = series.results[e];
                result.mraysPerSecond.push_back(
                    mrays(rays, series.threads == 1 ? seconds.processor : seconds.clock));
                result.undisturbed.push_back(series.threads * mrays(rays, seconds.processor));
            }
            progress("comparing the answers");
            judge(truth, rays, query, chosen, answers, plan.referee ? &referee : nullptr,
                  series.results);
            series.rays += rays.active;
        }
    }
    for (Series& series : all) {
        for (Result& result : series.results)
            result.refused = !result.peer && result.mistakes.wrong > 0 &&
                             double(result.mistakes.wrong) >= kWrongLimit * double(series.rays);
    }
    return all;
}

} // namespace smart::bench
