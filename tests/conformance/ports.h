// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tests/conformance/comparison.h"
#include "tests/conformance/conformance_case.h"

namespace conformance {

struct Port {
    const char* name;
    Kind kind;
};

struct Size {
    int width, height;

    std::string text() const { return std::to_string(width) + "x" + std::to_string(height); }
};

const std::vector<Port>& ports();

// Mesa's two: llvmpipe filters textures of bytes in integers, softpipe in floats.
enum class Rasterizer { kLlvmpipe, kSoftpipe };

const char* nameOf(Rasterizer rasterizer);

// One port in one size: the frames of both, rendered when they are asked for.
class PortRun {
public:
    PortRun(const Settings& settings, std::string port, Size size, int frames,
            Rasterizer rasterizer);
    ~PortRun();
    PortRun(const PortRun&) = delete;
    PortRun& operator=(const PortRun&) = delete;

    // Each throws std::runtime_error with what went wrong.
    void renderReference();
    void renderTest();

    Reference reference(int frame) const;
    Frame shifted(int frame) const; // OSMesa moved by half a pixel, for the control
    Frame test(int frame) const;

    std::string picturePath(const char* which, int frame) const;
    const std::string& stem() const { return stem_; }

private:
    void renderOpenGl(const std::string& report);
    bool isRendered(const std::string& report) const;
    std::string pattern(const char* which, const char* extension) const;
    Frame read(const char* which, int frame, int variant) const;

    const Settings& settings_;
    std::string port_, stem_;
    Size size_;
    int frames_;
    Rasterizer rasterizer_;
    std::array<std::uint8_t, 3> clear_{};
};

} // namespace conformance
