// SPDX-License-Identifier: MIT
#include "tests/bench/dynamic_decay.h"

#include <algorithm>
#include <chrono>
#include <iomanip>
#include <nlohmann/json.hpp>

#include "openrt/rt.h"

namespace smart::bench {
namespace {

constexpr unsigned kMeasured = 10; ///< in so many steps of all
constexpr unsigned kTraces = 5;    ///< of which the fastest counts

double secondsOf(DynamicEngine& engine, const DynamicStep& step) {
    const auto start = std::chrono::steady_clock::now();
    engine.update(step);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    engine.build();
    return seconds;
}

DecaySeries measureMotion(const DynamicScene& scene, const std::string& name,
                          const DynamicOptions& options, unsigned updates,
                          const DynamicProgress& progress) {
    const RaySet rays = primaryRays(scene.view(), options.size);
    std::vector<DynamicFound> found(rays.packets.size());
    const DynamicEnginePtr updated =
        dynamicOpenrt(scene, options.threads, SheetWay::Update, RT_DONT_CARE, "updated");
    DecaySeries series{name, {}, 0, 0};
    std::vector<double> seconds;
    const unsigned every = std::max(1u, updates / kMeasured);
    for (unsigned number = 1; number <= updates; ++number) {
        const DynamicStep step = scene.step(number);
        seconds.push_back(secondsOf(*updated, step));
        if (number % every != 0) {
            timedTrace(*updated, rays, options.threads, found); // as frames would
            continue;
        }
        progress(name + ", update " + std::to_string(number));
        const DynamicEnginePtr fresh =
            dynamicOpenrt(scene, options.threads, SheetWay::New, RT_DONT_CARE, "fresh");
        secondsOf(*fresh, step);
        DecayStep result{number, 1e9, 1e9};
        for (unsigned i = 0; i < kTraces; ++i) {
            result.updated =
                std::min(result.updated, timedTrace(*updated, rays, options.threads, found));
            result.fresh = std::min(result.fresh, timedTrace(*fresh, rays, options.threads, found));
        }
        series.steps.push_back(result);
    }
    series.update = median(seconds);
    series.longest = *std::max_element(seconds.begin(), seconds.end());
    return series;
}

} // namespace

DecayReport measureDecay(const DynamicOptions& options, unsigned updates,
                         const DynamicProgress& progress) {
    DecayReport report;
    const auto measure = [&](SheetMotion motion, const char* name) {
        report.series.push_back(measureMotion(DynamicScene::sheet(options.sheet, motion), name,
                                              options, updates, progress));
    };
    measure(SheetMotion::Waves, "waves");
    measure(SheetMotion::Twist, "twist");
    measure(SheetMotion::Crumple, "crumple");
    return report;
}

nlohmann::json DecayReport::json() const {
    nlohmann::json root = nlohmann::json::array();
    for (const DecaySeries& s : series) {
        nlohmann::json steps = nlohmann::json::array();
        for (const DecayStep& step : s.steps)
            steps.push_back(
                {{"number", step.number}, {"updated", step.updated}, {"fresh", step.fresh}});
        root.push_back(
            {{"motion", s.motion}, {"update", s.update}, {"longest", s.longest}, {"steps", steps}});
    }
    return root;
}

std::ostream& operator<<(std::ostream& out, const DecayReport& report) {
    out << std::fixed << "rays through an updated object, in times of those through a fresh one\n";
    for (const DecaySeries& s : report.series) {
        out << "  " << std::left << std::setw(10) << s.motion << std::right << std::setprecision(1)
            << "update " << std::setw(6) << 1e3 * s.update << " ms, longest " << std::setw(6)
            << 1e3 * s.longest << " ms;" << std::setprecision(2);
        for (const DecayStep& step : s.steps)
            out << "  " << step.number << ": " << step.updated / step.fresh;
        out << '\n';
    }
    return out;
}

} // namespace smart::bench
