// SPDX-License-Identifier: MIT
// openrt-cave: a scene in a simulated CAVE of four walls, for both eyes of a head that moves along
// a recorded path. All walls and eyes of a moment show the same frozen scene.
#include <openrt/rt.h>
#include <openrt/rtu.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "samples/common/image_file.h"
#include "samples/common/output_file.h"
#include "samples/tools/picture_window.h"
#include "samples/tools/scene_options.h"
#include "samples/vr/cave_room.h"
#include "samples/vr/head_path.h"
#include "samples/vr/latency_report.h"

namespace {

using Clock = std::chrono::steady_clock;

struct CaveOptions : samples::SceneOptions {
    std::string path, output;
    double side = 3.0, scale = 1.0, eyeDistance = 0.064, rate = 30.0;
    bool mono = false, latency = false;
} options;

constexpr std::size_t kWalls = 4;

/// What happens to the pictures of a wall, in this order: each eye is rendered, and they are shown.
std::vector<std::string> wallEvents(std::size_t eyes, bool inWindows) {
    std::vector<std::string> events;
    for (const samples::CaveWall& wall : samples::caveWalls(options.side)) {
        const std::string name = wall.name;
        for (std::size_t eye = 0; eye < eyes; ++eye)
            events.push_back(name + (eyes == 1   ? " rendered"
                                     : eye == 0 ? ", left eye rendered"
                                                : ", right eye rendered"));
        events.push_back(name + (inWindows ? " shown" : " written"));
    }
    return events;
}

/// The pictures of one eye on all walls, or of both.
class WallPictures {
public:
    WallPictures(samples::PictureSize size, int eyes) : size_(size), eyes_(eyes) {
        for (auto& wall : pixels_)
            for (int eye = 0; eye < eyes; ++eye)
                wall.emplace_back(std::size_t(size.width) * size.height * kPixel);
    }

    /// Queues a moment: the first view with the scene, the others of the scene as it is frozen
    /// then; and waits for all, before it throws what went wrong.
    void render(const samples::RtScene& scene, const samples::CavePlace& place,
                const samples::HeadPose& head, samples::LatencyReport& latency) {
        std::vector<RTuint> frames;
        for (std::size_t wall = 0; wall < kWalls; ++wall) {
            for (int eye = 0; eye < eyes_; ++eye) {
                rtSetFrameBuffer(pixels_[wall][std::size_t(eye)].data(), size_.width, size_.height,
                                 RT_RGBA_8);
                look(samples::caveWalls(options.side)[wall], place, eyeOf(head, eye));
                if (frames.empty()) scene.describeWorld();
                frames.push_back(frames.empty() ? rtQueueFrame() : rtQueueView());
            }
        }
        for (std::size_t i = 0; i < frames.size(); ++i) {
            rtWaitFrame(frames[i]);
            const std::size_t eyes = std::size_t(eyes_);
            latency.happened(i / eyes * (eyes + 1) + i % eyes);
        }
        samples::checkRt();
    }

    /// Of a wall with its eyes side by side.
    samples::PictureSize size() const { return {size_.width * uint32_t(eyes_), size_.height}; }
    /// Rows from below.
    std::vector<uint8_t> wall(std::size_t wall) const {
        const std::size_t row = std::size_t(size_.width) * kPixel;
        std::vector<uint8_t> joined;
        joined.reserve(row * size_.height * std::size_t(eyes_));
        for (std::size_t y = 0; y < size_.height; ++y)
            for (const std::vector<uint8_t>& eye : pixels_[wall])
                joined.insert(joined.end(), eye.begin() + std::ptrdiff_t(y * row),
                              eye.begin() + std::ptrdiff_t((y + 1) * row));
        return joined;
    }

private:
    static constexpr std::size_t kPixel = 4;

    glm::dvec3 eyeOf(const samples::HeadPose& head, int eye) const {
        return head.eye(eyes_ == 1 ? 0 : 2 * eye - 1, options.eyeDistance);
    }
    static void look(const samples::CaveWall& wall, const samples::CavePlace& place,
                     const glm::dvec3& eye) {
        const glm::dvec3 at[4] = {place.toScene(wall.lowerLeft), place.toScene(wall.lowerRight),
                                  place.toScene(wall.upperLeft), place.toScene(eye)};
        rtuCameraFromWall(&at[0].x, &at[1].x, &at[2].x, &at[3].x);
    }

    samples::PictureSize size_;
    int eyes_;
    std::array<std::vector<std::vector<uint8_t>>, kWalls> pixels_; ///< by wall and eye
};

/// A window for each wall.
class WallWindows {
public:
    explicit WallWindows(samples::PictureSize size) {
        for (const samples::CaveWall& wall : samples::caveWalls(options.side))
            windows_.push_back(std::make_unique<samples::PictureWindow>(
                display_, size, std::string("openrt-cave: ") + wall.name));
    }
    void show(const WallPictures& pictures, std::size_t eyes, samples::LatencyReport& latency) {
        for (std::size_t wall = 0; wall < kWalls; ++wall) {
            windows_[wall]->draw(pictures.size(), pictures.wall(wall));
            latency.happened(wall * (eyes + 1) + eyes);
        }
        samples::Display::poll();
    }
    bool closed() const {
        for (const auto& window : windows_)
            if (window->wantsToClose()) return true;
        return false;
    }

private:
    samples::Display display_;
    std::vector<std::unique_ptr<samples::PictureWindow>> windows_;
};

/// The output's name with the wall for %s and the frame's number for %d.
std::string fileName(const char* wall, uint32_t frame) {
    std::string name = options.output;
    const auto replace = [&](const std::string& what, const std::string& by) {
        const std::size_t at = name.find(what);
        if (at == std::string::npos || at != name.rfind(what))
            throw CLI::ValidationError("--output wants a name with one %s for the wall and one %d "
                                       "for the frame, such as cave-%s-%d.png");
        name.replace(at, what.size(), by);
    };
    replace("%s", wall);
    replace("%d", std::to_string(frame));
    return name;
}

void writeFiles(const WallPictures& pictures, uint32_t frame, std::size_t eyes,
                samples::LatencyReport& latency) {
    const samples::PictureSize size = pictures.size();
    for (std::size_t wall = 0; wall < kWalls; ++wall) {
        samples::OutputFile file(fileName(samples::caveWalls(options.side)[wall].name, frame));
        file.write(samples::encodePng(size.width, size.height, 4, pictures.wall(wall)));
        latency.happened(wall * (eyes + 1) + eyes);
    }
}

int run() {
    const samples::PictureSize size = samples::sizeFrom(options);
    const samples::Lighting lighting = samples::lightingFrom(options);
    const std::optional<samples::View> wantedView = samples::viewFrom(options);
    if (!(options.side > 0 && options.scale > 0 && options.eyeDistance >= 0 && options.rate > 0))
        throw CLI::ValidationError("--side, --scale and --rate are above 0, --eyes at least 0");
    if (!options.output.empty() && !fileName("front", 0).ends_with(".png"))
        throw CLI::ValidationError("--output " + options.output + ": its name does not end in .png");
    const samples::HeadPath path(options.path);
    rtInit(nullptr, nullptr);
    samples::applySettings(options);
    rtEnable(RT_FRAMEBUFFER_SRGB);
    samples::Bounds bounds;
    const samples::SceneDescription description = samples::loadVisibleScene(options, bounds);
    samples::printNotes(description);
    const samples::View view =
        wantedView ? *wantedView : samples::defaultView(description, bounds, 1.0f);
    const samples::RtScene scene(description, bounds, view, lighting);
    const samples::CavePlace place(view, options.scale);
    const std::size_t eyes = options.mono ? 1 : 2;
    WallPictures pictures(size, int(eyes));
    samples::LatencyReport latency(wallEvents(eyes, options.output.empty()));
    rtFrameDepth(2 * kWalls);

    std::optional<WallWindows> windows;
    if (options.output.empty()) windows.emplace(pictures.size());
    const Clock::time_point start = Clock::now();
    uint32_t frame = 0;
    for (; options.frames == 0 || frame < options.frames; ++frame) {
        const double now = windows ? std::chrono::duration<double>(Clock::now() - start).count()
                                   : frame / options.rate;
        if (now > path.end() && options.frames == 0) break;
        latency.poseRead();
        pictures.render(scene, place, path.at(now), latency);
        if (!windows) {
            writeFiles(pictures, frame, eyes, latency);
            continue;
        }
        windows->show(pictures, eyes, latency);
        if (windows->closed()) break;
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    std::printf("%u moments of %zu views, %.1f a second\n", frame,
                kWalls * eyes, frame / seconds);
    if (options.latency) latency.print();
    rtExit();
    return 0;
}

} // namespace

int main(int argc, char* argv[]) {
    CLI::App app("Shows a scene in a simulated CAVE: front, left, right and floor, for both eyes "
                 "of a head that moves along a recorded path. In a window for each wall, or with "
                 "--output in files.",
                 "openrt-cave");
    options.size = "512x512";
    options.frames = 0;
    options.addSizeTo(app);
    options.addRoomTo(app);
    options.addTo(app);
    app.add_option("--path", options.path, "recorded head: lines of seconds x y z yaw pitch roll")
        ->required();
    app.add_option("--side", options.side, "of a wall, in metres")->capture_default_str();
    app.add_option("--scale", options.scale, "units of the scene to the metre")
        ->capture_default_str();
    app.add_option("--eyes", options.eyeDistance, "distance between them, in metres")
        ->capture_default_str();
    app.add_flag("--mono", options.mono, "one picture a wall, from between the eyes");
    app.add_flag("--report-latency", options.latency,
                 "print how long after the head's pose each wall is rendered and shown");
    app.add_option("--frames", options.frames, "how many moments; 0: to the end of the path")
        ->capture_default_str();
    app.add_option("--rate", options.rate, "moments a second of the path, in files")
        ->capture_default_str();
    app.add_option("-o,--output", options.output,
                   "PNG files: %s stands for the wall, %d for the moment's number");
    return samples::runProgram(app, argc, argv, &run);
}
