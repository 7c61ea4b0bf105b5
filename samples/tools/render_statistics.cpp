// SPDX-License-Identifier: MIT
#include "samples/tools/render_statistics.h"

#include <openrt/rt.h>

#include <algorithm>
#include <iomanip>
#include <numeric>
#include <ostream>
#include <sstream>
#include <utility>

namespace samples {
namespace {

int64_t count(RTenum what) {
    RTint64 value = 0;
    rtGetInteger64v(what, &value);
    return value;
}

double ratio(double a, double b) { return b > 0 ? a / b : 0.0; }

std::string fixed(double value, int digits) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

std::string quoted(const std::string& text) {
    std::ostringstream out;
    out << '"';
    for (unsigned char c : text) {
        if (c == '"' || c == '\\') {
            out << '\\' << char(c);
        } else if (c < 0x20) {
            out << "\\u" << std::hex << std::setw(4) << std::setfill('0') << int(c) << std::dec;
        } else {
            out << char(c);
        }
    }
    out << '"';
    return out.str();
}

} // namespace

void RenderStatistics::query() {
    isa = reinterpret_cast<const char*>(rtGetString(RT_ISA));
    triangles = count(RT_STAT_TRIANGLES);
    instances = count(RT_STAT_INSTANCES);
    nodes = count(RT_STAT_NODES);
    leaves = count(RT_STAT_LEAVES);
    references = count(RT_STAT_REFERENCES);
    bytes = count(RT_STAT_BYTES);
    droppedTriangles = count(RT_STAT_DROPPED_TRIANGLES);
    droppedInstances = count(RT_STAT_DROPPED_INSTANCES);
    badPixels = count(RT_STAT_BAD_PIXELS);
    primaryRays = count(RT_STAT_PRIMARY_RAYS);
    shadowRays = count(RT_STAT_SHADOW_RAYS);
    secondaryRays = count(RT_STAT_SECONDARY_RAYS);
    buildSeconds = double(count(RT_STAT_BUILD_MICROSECONDS)) * 1e-6;
}

double RenderStatistics::bestFrameSeconds() const {
    return frameSeconds.empty() ? 0.0 : *std::min_element(frameSeconds.begin(), frameSeconds.end());
}

double RenderStatistics::raysPerSecond() const {
    return ratio(double(primaryRays + shadowRays + secondaryRays), bestFrameSeconds());
}

void RenderStatistics::printText(std::ostream& out) const {
    const auto line = [&](const char* name, const std::string& value) {
        out << std::left << std::setw(20) << name << value << '\n';
    };
    const auto integer = [](int64_t value) { return std::to_string(value); };
    line("scene", scene);
    if (!output.empty()) line("picture", output);
    line("size", integer(width) + "x" + integer(height) + ", " + integer(samples) +
                     (samples == 1 ? " sample" : " samples") + " a pixel");
    line("kernels", isa + ", " + precision);
    line("triangles", integer(triangles));
    line("instances", integer(instances));
    line("tree nodes", integer(nodes));
    line("leaves", integer(leaves));
    line("duplication", fixed(ratio(double(references), double(triangles)), 3));
    line("bytes a triangle", fixed(ratio(double(bytes), double(triangles)), 1));
    line("dropped triangles", integer(droppedTriangles));
    line("dropped instances", integer(droppedInstances));
    line("load seconds", fixed(loadSeconds, 3));
    line("build seconds", fixed(buildSeconds, 3));
    line("primary rays", integer(primaryRays));
    line("shadow rays", integer(shadowRays));
    line("secondary rays", integer(secondaryRays));
    line("bad pixels", integer(badPixels));
    line("Mrays/s", fixed(raysPerSecond() * 1e-6, 2));
    line("frame seconds", fixed(bestFrameSeconds(), 4));
    if (frameSeconds.size() > 1) {
        const double sum = std::accumulate(frameSeconds.begin(), frameSeconds.end(), 0.0);
        line("mean frame seconds", fixed(sum / double(frameSeconds.size()), 4));
    }
}

void RenderStatistics::printJson(std::ostream& out) const {
    const char* separator = "{\n";
    const auto entry = [&](const char* name, const auto& value) {
        out << std::exchange(separator, ",\n") << "  \"" << name << "\": " << value;
    };
    entry("scene", quoted(scene));
    entry("output", quoted(output));
    entry("width", width);
    entry("height", height);
    entry("samples", samples);
    entry("isa", quoted(isa));
    entry("precision", quoted(precision));
    entry("triangles", triangles);
    entry("instances", instances);
    entry("nodes", nodes);
    entry("leaves", leaves);
    entry("references", references);
    entry("duplication", fixed(ratio(double(references), double(triangles)), 6));
    entry("bytes", bytes);
    entry("bytes_per_triangle", fixed(ratio(double(bytes), double(triangles)), 3));
    entry("dropped_triangles", droppedTriangles);
    entry("dropped_instances", droppedInstances);
    entry("load_seconds", fixed(loadSeconds, 6));
    entry("build_seconds", fixed(buildSeconds, 6));
    entry("primary_rays", primaryRays);
    entry("shadow_rays", shadowRays);
    entry("secondary_rays", secondaryRays);
    entry("bad_pixels", badPixels);
    entry("mrays_per_second", fixed(raysPerSecond() * 1e-6, 6));
    entry("frame_seconds", fixed(bestFrameSeconds(), 6));
    std::string all = "[";
    for (double seconds : frameSeconds) all += (all.size() > 1 ? ", " : "") + fixed(seconds, 6);
    entry("all_frame_seconds", all + "]");
    out << "\n}\n";
}

} // namespace samples
