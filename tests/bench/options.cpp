// SPDX-License-Identifier: MIT
#include "tests/bench/options.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "libsmart/render/worker.h"
#include "tests/bench/command.h"

namespace smart::bench {

void ViewOptions::add(CLI::App& app) {
    app.add_option("--camera", camera,
                   "ex,ey,ez,tx,ty,tz,ux,uy,uz,fov: eye, target, upwards, "
                   "vertical field of view in degrees")
        ->delimiter(',')
        ->expected(10);
    app.add_option("--light", light, "x,y,z: a point light")->delimiter(',')->expected(3);
    CLI::Option* const file = app.add_option(
        "--cameras", cameras,
        "file of views: on each line a name, the numbers of --camera, and of --light");
    app.add_option("--name", name, "which line of --cameras; the scene's name if not given")
        ->needs(file);
}

View ViewOptions::view(const std::string& scene) const {
    View view;
    if (!cameras.empty()) {
        const std::string file = scene.substr(scene.find_last_of('/') + 1);
        view = readView(cameras, name.empty() ? file.substr(0, file.find('.')) : name);
    }
    if (!camera.empty()) {
        test::CameraPose& pose = view.camera;
        for (std::size_t k = 0; k < 3; ++k) {
            pose.eye[k] = camera[k];
            pose.target[k] = camera[3 + k];
            pose.up[k] = camera[6 + k];
        }
        pose.fov = camera[9];
    }
    if (!light.empty()) std::copy_n(light.begin(), 3, view.light);
    return view;
}

std::vector<unsigned> threadCounts(unsigned most) {
    if (most == 1) return {1};
    return {1, most};
}

void addScene(CLI::App& app, std::string& scene) {
    app.add_option("--scene", scene, "a .tri file, or generated:N")->required();
}

void addSize(CLI::App& app, uint32_t& size) {
    app.add_option("--size", size, "width and height in pixels, a multiple of 4")
        ->check(CLI::Range(4, 16384))
        ->check([](const std::string& text) {
            return std::stoul(text) % 4 == 0 ? std::string() : text + " is no multiple of 4";
        })
        ->capture_default_str();
}

void addThreads(CLI::App& app, unsigned& threads, const std::string& what) {
    const auto set = [&threads](unsigned count) { threads = count > 0 ? count : coreCount(); };
    set(0);
    app.add_option_function<unsigned>("--threads", set, what + ", 0 for all cores")
        ->check(CLI::Range(0, 1024))
        ->default_str("0");
}

void addRepeat(CLI::App& app, unsigned& repeat) {
    app.add_option("--repeat", repeat, "measurements of each kind")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
}

void addIsa(CLI::App& app, std::string& isa) {
    app.add_option("--isa", isa, "instruction set: generic, sse4, avx2, avx512, neon")
        ->check(CLI::IsMember({"generic", "sse4", "avx2", "avx512", "neon"}));
}

void addPrecision(CLI::App& app, std::string& precision) {
    app.add_option("--precision", precision, "how exact our intersections are")
        ->check(CLI::IsMember({"fast", "watertight", "precise"}))
        ->capture_default_str();
}

void addPeers(CLI::App& app, std::vector<std::string>& peers) {
    app.add_option("--peers", peers, "what to compare with: embree")
        ->delimiter(',')
#ifdef OPENRT_BENCH_EMBREE
        ->check(CLI::IsMember({"embree"}));
#else
        ->check([](const std::string&) {
            return std::string("this program was built without Embree");
        });
#endif
}

void selectIsa(const std::string& isa) {
    if (!isa.empty() && !selectKernels(isa.c_str()))
        throw UsageError("--isa " + isa + ": not in this library or machine");
}

Precision precisionOf(const std::string& name) {
    return name == "fast"      ? Precision::Fast
           : name == "precise" ? Precision::Precise
                               : Precision::Watertight;
}

bool wantsEmbree(const std::vector<std::string>& peers) {
    return std::find(peers.begin(), peers.end(), "embree") != peers.end();
}

void showProgress(const std::string& text) {
    static const bool terminal = isatty(STDERR_FILENO);
    if (terminal) std::cerr << '\r' << text << "\033[K" << std::flush;
}

} // namespace smart::bench
