// SPDX-License-Identifier: MIT
#include "tests/accuracy/accuracy_report.h"

#include <cstdio>

#include "libsmart/kernel/kernels.h"

namespace smart::test {
namespace {

constexpr std::pair<const char*, Verdict> kColumns[] = {
    {"miss", Verdict::Miss},   {"through", Verdict::Through},    {"slide", Verdict::Slide},
    {"early", Verdict::Early}, {"order", Verdict::Order},        {"false", Verdict::False},
    {"gross", Verdict::Gross}, {"wrongPrim", Verdict::WrongPrim}};

const char* nameOf(Promise promise) {
    switch (promise) {
        case Promise::Right:
            return "right";
        case Promise::NothingLost:
            return "nothing lost";
        case Promise::None:
            break;
    }
    return "none";
}

nlohmann::json jsonOf(const EngineTally& entry) {
    const Tally& tally = entry.tally;
    nlohmann::json line = {{"engine", entry.engine},
                           {"rays", tally.counts.rays},
                           {"hits", tally.counts.hits},
                           {"lost", tally.counts.lost()},
                           {"tMaxUlp", tally.counts.worstT},
                           {"tMeanUlp", tally.meanT()},
                           {"tOfReportedMaxUlp", tally.worstPlaneT},
                           {"uvMax2e-24", tally.counts.worstUv},
                           {"uvMaxUlp", tally.worstUvUlp},
                           {"tNotRoundedCorrectly", tally.beyondHalfT},
                           {"uvNotRoundedCorrectly", tally.beyondHalfUv}};
    for (const auto& [name, verdict] : kColumns) line[name] = tally.counts[verdict];
    return line;
}

nlohmann::json jsonOf(const SceneSpeed& speed) {
    nlohmann::json root = {{"scene", speed.scene},
                           {"triangles", speed.triangles},
                           {"primaryRays", speed.primaryRays},
                           {"shadowRays", speed.shadowRays},
                           {"triangleTestsOfPackets", speed.triangleTests},
                           {"doubleTests", speed.doubleTests},
                           {"exactTests", speed.exactTests}};
    for (const EngineSpeed& engine : speed.engines) {
        root["engines"].push_back({{"engine", engine.engine},
                                   {"kind", nameOf(engine.kind)},
                                   {"nanosecondsPerRay", engine.best()},
                                   {"repeats", engine.nanosecondsPerRay},
                                   {"wrong", engine.mistakes.wrong},
                                   {"differAtEdges", engine.mistakes.ties}});
    }
    return root;
}

/// A line of columns; std::ostream's own formatting would drown the table.
template <typename... Values>
void print(std::ostream& out, const char* format, Values... values) {
    char line[256];
    std::snprintf(line, sizeof line, format, values...);
    out << line << '\n';
}

} // namespace

nlohmann::json AccuracyReport::json() const {
    nlohmann::json root = {{"isa", isa}, {"embree", embree}, {"threads", threads}, {"rays", rays}};
    root["cases"] = root["secondary"] = root["speed"] = nlohmann::json::array();
    for (const CaseResult& result : cases) {
        nlohmann::json entry = {{"case", result.name},
                                {"triangles", result.triangles},
                                {"watertightPromise", nameOf(result.promise)},
                                {"seconds", result.seconds}};
        for (const EngineTally& engine : result.engines) entry["engines"].push_back(jsonOf(engine));
        for (const Identity& identity : result.identities) {
            entry["identity"].push_back({{"mode", identity.mode},
                                         {"variants", identity.variants},
                                         {"rays", identity.rays},
                                         {"differing", identity.differing}});
        }
        root["cases"].push_back(std::move(entry));
    }
    for (const SecondaryResult& result : secondary) {
        root["secondary"].push_back({{"scene", result.scene},
                                     {"engine", result.engine},
                                     {"rays", result.rays},
                                     {"acne", result.acne},
                                     {"leaks", result.leaks}});
    }
    for (const SceneSpeed& speed : speeds) root["speed"].push_back(jsonOf(speed));
    return root;
}

void AccuracyReport::printTable(std::ostream& out) const {
    out << "Of a million rays; lost = miss + through. t in ulp, u and v in 2^-24, at worst.\n";
    print(out, "%-20s %-22s %9s %8s %8s %8s %8s %8s %8s %8s %9s %9s", "case", "engine", "rays",
          "lost", "slide", "early", "order", "false", "gross", "wrongpr", "t", "uv");
    for (const CaseResult& result : cases) {
        for (const EngineTally& entry : result.engines) {
            const VerdictCounts& c = entry.tally.counts;
            const auto rate = [&](std::size_t count) {
                return 1e6 * double(count) / double(c.rays);
            };
            print(out, "%-20s %-22s %9zu %8.6g %8.6g %8.6g %8.6g %8.6g %8.6g %8.6g %9.4g %9.4g",
                  result.name.c_str(), entry.engine.c_str(), c.rays, rate(c.lost()),
                  rate(c[Verdict::Slide]), rate(c[Verdict::Early]), rate(c[Verdict::Order]),
                  rate(c[Verdict::False]), rate(c[Verdict::Gross]), rate(c[Verdict::WrongPrim]),
                  c.worstT, c.worstUv);
        }
        for (const Identity& identity : result.identities) {
            if (identity.differing == 0) continue;
            print(out, "%-20s %-22s %9zu rays, %zu not the same bits in all %zu variants",
                  result.name.c_str(), identity.mode.c_str(), identity.rays, identity.differing,
                  identity.variants);
        }
    }
    if (!secondary.empty()) out << "\nRays that leave a surface\n";
    for (const SecondaryResult& result : secondary) {
        print(out, "H9 %-22s %-22s %9zu rays a side, %zu meet their own surface, %zu leak",
              result.scene.c_str(), result.engine.c_str(), result.rays, result.acne, result.leaks);
    }
    for (const SceneSpeed& speed : speeds) {
        out << '\n' << speed.scene << ", " << speed.triangles << " triangles\n";
        for (const EngineSpeed& engine : speed.engines) {
            print(out, "%-8s %-28s %9.1f ns a ray of one thread's time, %zu wrong",
                  nameOf(engine.kind), engine.engine.c_str(), engine.best(), engine.mistakes.wrong);
        }
        print(out, "precise: %.4f tests a ray in double, %.6f exact, %.2f packet tests a packet",
              double(speed.doubleTests) / double(speed.primaryRays),
              double(speed.exactTests) / double(speed.primaryRays),
              16.0 * double(speed.triangleTests) / double(speed.primaryRays));
    }
}

std::string AccuracyReport::brokenPromises() const {
    std::string text;
    for (const CaseResult& result : cases) text += broken(result);
    for (const SecondaryResult& result : secondary) {
        if (result.mode < int(Precision::Watertight)) continue;
        if (result.acne + result.leaks == 0) continue;
        text += "H9 " + result.scene + ": " + result.engine + ": " + std::to_string(result.acne) +
                " rays meet the surface that they leave, " + std::to_string(result.leaks) +
                " leak\n";
    }
    return text;
}

} // namespace smart::test
