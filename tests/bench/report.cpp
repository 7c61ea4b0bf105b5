// SPDX-License-Identifier: MIT
#include "tests/bench/report.h"

#include <algorithm>
#include <iomanip>

namespace smart::bench {
namespace {

const char* nameOf(Kind kind) {
    return kind == Kind::Primary ? "primary" : "shadow";
}

/// The fastest peer; 0 if there is none.
double bestPeer(const Series& series) {
    double best = 0;
    for (const Result& result : series.results) {
        if (result.peer) best = std::max(best, result.median());
    }
    return best;
}

void print(std::ostream& out, const Series& series) {
    out << nameOf(series.kind) << " rays: " << series.rays << ", threads: " << series.threads
        << '\n';
    const double best = bestPeer(series);
    for (const Result& result : series.results) {
        out << "  " << std::left << std::setw(30) << result.engine << std::right;
        if (result.refused) {
            out << "refused: " << result.mistakes.wrong << " of " << series.rays
                << " answers are wrong\n";
            continue;
        }
        const auto [low, high] =
            std::minmax_element(result.mraysPerSecond.begin(), result.mraysPerSecond.end());
        out << std::setw(8) << result.median() << " Mrays/s (" << *low << " to " << *high << ')';
        if (best > 0) out << ", " << result.median() / best << " of the best peer";
        if (result.mistakes.wrong) out << ", " << result.mistakes.wrong << " wrong";
        if (result.mistakes.edge) out << ", " << result.mistakes.edge << " differ at edges";
        out << '\n';
    }
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
    nlohmann::json root = {{"scene", scene}, {"triangles", triangles}};
    for (const BuildResult& build : builds) {
        root["builds"].push_back(
            {{"engine", build.engine},
             {"threads", build.threads},
             {"seconds", build.report.seconds},
             {"bytesPerTriangle", double(build.report.bytes) / double(triangles)}});
    }
    for (const Series& s : series) {
        nlohmann::json entry = {{"kind", nameOf(s.kind)}, {"threads", s.threads}, {"rays", s.rays}};
        const double best = bestPeer(s);
        for (const Result& result : s.results) {
            nlohmann::json line = {{"engine", result.engine},
                                   {"wrong", result.mistakes.wrong},
                                   {"differAtEdges", result.mistakes.edge},
                                   {"refused", result.refused}};
            if (!result.refused) {
                line["mraysPerSecond"] = result.median();
                line["repeats"] = result.mraysPerSecond;
                if (best > 0) line["ofBestPeer"] = result.median() / best;
            }
            entry["engines"].push_back(std::move(line));
        }
        root["series"].push_back(std::move(entry));
    }
    return root;
}

std::ostream& operator<<(std::ostream& out, const Report& report) {
    out << report.scene << ": " << report.triangles << " triangles\n"
        << std::fixed << std::setprecision(2);
    for (const BuildResult& build : report.builds) {
        out << "build  " << std::left << std::setw(28) << build.engine << std::right
            << build.threads << " thread(s) " << std::setprecision(3) << std::setw(9)
            << build.report.seconds << " s, " << std::setprecision(1)
            << double(build.report.bytes) / double(report.triangles) << " bytes a triangle\n"
            << std::setprecision(2);
    }
    for (const Series& s : report.series) print(out, s);
    return out;
}

} // namespace smart::bench
