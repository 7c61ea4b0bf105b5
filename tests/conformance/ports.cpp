// SPDX-License-Identifier: MIT
#include "tests/conformance/ports.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/conformance/child_process.h"
#include "tests/conformance/tested_library.h"

namespace conformance {
namespace {

// A 128th of a pixel each way, and the control's half.
constexpr const char* kShifts[] = {"0.0078125,0.0078125", "-0.0078125,0.0078125",
                                   "0.0078125,-0.0078125", "-0.0078125,-0.0078125"};
constexpr const char* kControlShift = "0.5,0.5";
constexpr int kShiftCount = 4, kControl = 5;

std::string variantName(const std::string& pattern, int frame, int variant) {
    char path[4096];
    std::snprintf(path, sizeof path, pattern.c_str(), frame);
    if (variant == 0) return path;
    const std::filesystem::path whole(path);
    return whole.parent_path() /
           (whole.stem().string() + ".v" + std::to_string(variant) + whole.extension().string());
}

void runOrThrow(const std::vector<std::string>& arguments,
                const std::vector<std::string>& environment, int seconds) {
    const Outcome outcome = runProgram(arguments, environment, seconds);
    const std::string failure = outcome.failure(arguments[0]);
    if (!failure.empty()) throw std::runtime_error(failure);
}

} // namespace

const std::vector<Port>& ports() {
    static const std::vector<Port> list = {
        {"checker", Kind::kEqual},    {"clip", Kind::kEqual},
        {"fog", Kind::kEqual},        {"gears", Kind::kEqual},
        {"isosurface", Kind::kEqual}, {"lightmap", Kind::kEqual},
        {"material_grid", Kind::kEqual}, {"mirror", Kind::kGeometry},
        {"model", Kind::kEqual},      {"movelight", Kind::kEqual},
        {"nested_lists", Kind::kEqual}, {"overlay", Kind::kEqual},
        {"panes", Kind::kEqual},      {"planet", Kind::kEqual},
        {"revolution", Kind::kEqual}, {"robot", Kind::kEqual},
        {"scene", Kind::kEqual},      {"shadows", Kind::kGeometry},
        {"spots", Kind::kEqual},      {"terrain", Kind::kEqual},
        {"texbind", Kind::kEqual},    {"text", Kind::kEqual},
        {"torus", Kind::kEqual},      {"varray", Kind::kEqual}};
    return list;
}

const char* nameOf(Rasterizer rasterizer) {
    return rasterizer == Rasterizer::kLlvmpipe ? "llvmpipe" : "softpipe";
}

PortRun::PortRun(const Settings& settings, std::string port, Size size, int frames,
                 Rasterizer rasterizer)
    : settings_(settings),
      port_(std::move(port)),
      stem_(port_ + "-" + size.text() + "-" + nameOf(rasterizer)),
      size_(size),
      frames_(frames),
      rasterizer_(rasterizer) {}

PortRun::~PortRun() {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(settings_.work, ignored)) {
        const std::string name = entry.path().filename();
        if (name.rfind(stem_ + "-", 0) != 0) continue;
        const bool kept = settings_.keepPictures && entry.path().extension() == ".png" &&
                          name.find(".v") == std::string::npos;
        if (!kept) std::filesystem::remove(entry.path(), ignored);
    }
}

std::string PortRun::pattern(const char* which, const char* extension) const {
    const bool isTest = std::string(which) == "rt" || settings_.openGlPictures.empty();
    const std::filesystem::path& folder = isTest ? settings_.work : settings_.openGlPictures;
    return folder / (stem_ + "-" + which + "-%03d" + extension);
}

// The report is written last.
bool PortRun::isRendered(const std::string& report) const {
    return !settings_.openGlPictures.empty() && std::filesystem::exists(report);
}

std::string PortRun::picturePath(const char* which, int frame) const {
    return variantName(pattern(which, ".png"), frame, 0);
}

void PortRun::renderReference() {
    const std::filesystem::path& folder =
        settings_.openGlPictures.empty() ? settings_.work : settings_.openGlPictures;
    const std::string report = folder / (stem_ + "-" + std::to_string(frames_) + "-report.json");
    if (!isRendered(report)) renderOpenGl(report);
    const nlohmann::json told = nlohmann::json::parse(std::ifstream(report));
    for (std::size_t k = 0; k < 3; ++k)
        clear_[k] = std::uint8_t(std::lround(255.0 * told["clear"][k].get<double>()));
}

void PortRun::renderOpenGl(const std::string& report) {
    const std::string program = settings_.openGlPrograms / port_;
    // One thread, so that the picture depends on nothing; leaks of Mesa are not ours.
    const std::vector<std::string> environment = {
        std::string("GALLIUM_DRIVER=") + nameOf(rasterizer_), "LP_NUM_THREADS=0",
        "ASAN_OPTIONS=detect_leaks=0"};
    runOrThrow({program, "-geometry", size_.text(), "--rt-offscreen", std::to_string(frames_),
                "--rt-output", pattern("split", ".png"), "--rt-depth", pattern("split", ".pfm"),
                "--rt-split", "first", "--rt-buffer", "float"},
               environment, settings_.seconds);
    std::vector<std::string> arguments = {program,
                                          "-geometry",
                                          size_.text(),
                                          "--rt-offscreen",
                                          std::to_string(frames_),
                                          "--rt-output",
                                          pattern("gl", ".png"),
                                          "--rt-depth",
                                          pattern("gl", ".pfm"),
                                          "--rt-report",
                                          report};
    for (const char* shift : kShifts) arguments.insert(arguments.end(), {"--rt-variant", shift});
    arguments.insert(arguments.end(), {"--rt-variant", kControlShift});
    runOrThrow(arguments, environment, settings_.seconds);
}

void PortRun::renderTest() {
    runOrThrow({settings_.openRtPrograms / port_, "-geometry", size_.text(), "--rt-offscreen",
                std::to_string(frames_), "--rt-output", pattern("rt", ".png"), "--rt-depth",
                pattern("rt", ".pfm")},
               withLibrary(settings_), settings_.seconds);
}

Frame PortRun::read(const char* which, int frame, int variant) const {
    return {readPng(variantName(pattern(which, ".png"), frame, variant)),
            readPfm(variantName(pattern(which, ".pfm"), frame, variant))};
}

Reference PortRun::reference(int frame) const {
    Reference reference{read("gl", frame, 0), {}, clear_};
    for (int variant = 1; variant <= kShiftCount; ++variant)
        reference.others.push_back(read("gl", frame, variant));
    reference.others.push_back(read("split", frame, 0));
    return reference;
}

Frame PortRun::shifted(int frame) const {
    return read("gl", frame, kControl);
}

Frame PortRun::test(int frame) const {
    return read("rt", frame, 0);
}

} // namespace conformance
