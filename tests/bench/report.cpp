// SPDX-License-Identifier: MIT
#include "tests/bench/report.h"

#include <algorithm>
#include <iomanip>

#include "tests/bench/machine.h"

namespace smart::bench {
namespace {

/// The same engine at one thread; nullptr where it was not measured.
const Result* atOneThread(const std::vector<Series>& all, const Series& series,
                          const Result& result) {
    for (const Series& one : all) {
        if (one.kind != series.kind || one.threads != 1 || series.threads == 1) continue;
        for (const Result& other : one.results)
            if (other.engine == result.engine) return &other;
    }
    return nullptr;
}

void print(std::ostream& out, const std::vector<Series>& all, const Series& series) {
    out << nameOf(series.kind) << " rays: " << series.rays << ", threads: " << series.threads
        << '\n';
    const Result *best = series.bestPeer(false), *robust = series.bestPeer(true);
    for (const Result& result : series.results) {
        if (result.mraysPerSecond.empty()) continue;
        out << "  " << std::left << std::setw(42) << result.engine << std::right;
        if (result.refused) {
            out << "refused: " << result.mistakes.wrong << " of " << series.rays
                << " answers are wrong\n";
            continue;
        }
        const auto [low, high] =
            std::minmax_element(result.mraysPerSecond.begin(), result.mraysPerSecond.end());
        out << std::setw(8) << result.median() << " Mrays/s (" << *low << " to " << *high << ')';
        if (best && !result.peer) out << ", " << ratio(result, *best) << " of the best peer";
        if (robust && !result.peer) out << ", " << ratio(result, *robust) << " of the best robust";
        if (const Result* one = atOneThread(all, series, result))
            out << ", " << gain(result, *one) << " times one thread";
        if (result.mistakes.wrong) out << ", " << result.mistakes.wrong << " wrong";
        if (result.mistakes.ties) out << ", " << result.mistakes.ties << " ties";
        out << '\n';
    }
}

nlohmann::json jsonOf(const std::vector<Series>& all, const Series& series) {
    nlohmann::json entry = {
        {"kind", nameOf(series.kind)}, {"threads", series.threads}, {"rays", series.rays}};
    const Result *best = series.bestPeer(false), *robust = series.bestPeer(true);
    if (best) entry["bestPeer"] = best->engine;
    if (robust) entry["bestRobustPeer"] = robust->engine;
    for (const Result& result : series.results) {
        nlohmann::json line = {{"engine", result.engine}, {"peer", result.peer}};
        if (result.mraysPerSecond.empty()) {
            line["firstLook"] = result.firstLook;
            entry["sortedOut"].push_back(std::move(line));
            continue;
        }
        line["wrong"] = result.mistakes.wrong;
        line["ties"] = result.mistakes.ties;
        line["refused"] = result.refused;
        if (!result.refused) {
            line["mraysPerSecond"] = result.median();
            line["repeats"] = result.mraysPerSecond;
            if (best) line["ofBestPeer"] = ratio(result, *best);
            if (robust) line["ofBestRobustPeer"] = ratio(result, *robust);
            if (const Result* one = atOneThread(all, series, result))
                line["ofOneThread"] = gain(result, *one);
        }
        entry["engines"].push_back(std::move(line));
    }
    return entry;
}

} // namespace

bool Report::anyRefused() const {
    for (const Series& s : series) {
        for (const Result& result : s.results) {
            if (result.refused) return true;
        }
    }
    return false;
}

nlohmann::json Report::json() const {
    nlohmann::json root = {{"scene", scene},
                           {"triangles", triangles},
                           {"size", size},
                           {"isa", isa},
                           {"precision", precision},
                           {"machine", machine()}};
    for (const BuildResult& build : builds) {
        root["builds"].push_back(
            {{"engine", build.engine},
             {"threads", build.threads},
             {"seconds", build.report.seconds},
             {"bytesPerTriangle",
              double(build.report.bytes) / double(std::max<std::size_t>(triangles, 1))}});
    }
    for (const Series& s : series) root["series"].push_back(jsonOf(series, s));
    for (const RayCounts& one : counts) {
        const auto each = [](const TraversalCounts& c, std::size_t n) -> nlohmann::json {
            return {{"nodes", double(c.nodes) / double(n)},
                    {"leaves", double(c.leaves) / double(n)},
                    {"triangles", double(c.triangles) / double(n)}};
        };
        if (one.rays == 0) continue;
        root["counts"].push_back({{"kind", nameOf(one.kind)},
                                  {"aRayAlone", each(one.alone, one.rays)},
                                  {"aPacket", each(one.together, one.packets)}});
    }
    root["limits"] = {{"clockGHz", limits.clockGHz},
                      {"gigaflops", limits.gigaflops},
                      {"cacheGBs", limits.cacheGBs},
                      {"memoryGBs", limits.memoryGBs}};
    return root;
}

std::ostream& operator<<(std::ostream& out, const Report& report) {
    out << report.scene << ": " << report.triangles << " triangles\n"
        << std::fixed << std::setprecision(2);
    for (const BuildResult& build : report.builds) {
        out << "build  " << std::left << std::setw(28) << build.engine << std::right
            << build.threads << " thread(s) " << std::setprecision(3) << std::setw(9)
            << build.report.seconds << " s, " << std::setprecision(1)
            << double(build.report.bytes) / double(std::max<std::size_t>(report.triangles, 1))
            << " bytes a triangle\n"
            << std::setprecision(2);
    }
    for (const Series& s : report.series) print(out, report.series, s);
    return out;
}

} // namespace smart::bench
