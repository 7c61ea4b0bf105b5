// SPDX-License-Identifier: MIT
// Built-in rendering objects: which camera rays make a pixel.
#pragma once

#include <algorithm>

#include "libsmart/shading/builtin/sample_limit.h"
#include "openrt/shader.hpp"

namespace smart::builtin {

using namespace openrt;

/// The mean of the samples that rtSamples asks for: what a frame without a rendering object shows,
/// to the bit.
struct Default {
    Color renderPixel(PixelContext& pixel) const {
        const RTuint n = pixel.samples() > 1 ? pixel.samples() : 1u;
        Vec4 sum;
        for (RTuint i = 0; i < n; ++i) sum = sum + pixel.trace(pixel.samplePosition(i, n));
        pixel.setAlpha(sum.w / float(n));
        return {sum.x / float(n), sum.y / float(n), sum.z / float(n)};
    }
};

/// The mean of `minSamples` samples; where their contrast (highest - lowest) / (highest + lowest)
/// exceeds `contrast` in a channel, of `maxSamples`. Mitchell, "Generating antialiased images at
/// low sampling densities", SIGGRAPH 1987.
struct Antialias {
    float contrast = 0.1f; ///< 0 to 1
    int minSamples = 4;    ///< 2 to 4096; others count as the nearest of these
    int maxSamples = 16;   ///< minSamples to 4096; likewise

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<float>("contrast", PER_SHADER, offsetof(Antialias, contrast));
        r.registerParam<int>("minSamples", PER_SHADER, offsetof(Antialias, minSamples));
        r.registerParam<int>("maxSamples", PER_SHADER, offsetof(Antialias, maxSamples));
    }
    Color renderPixel(PixelContext& pixel) const {
        const auto least = RTuint(std::clamp(minSamples, 2, kMaxSamples));
        const auto most = RTuint(std::clamp(maxSamples, int(least), kMaxSamples));
        Vec4 sum;
        Color low, high;
        RTuint taken = 0;
        const auto take = [&] {
            const Vec4 sample = pixel.trace(pixel.samplePosition(taken, most));
            const Color color(sample.x, sample.y, sample.z);
            low = taken ? Color(min(low.r, color.r), min(low.g, color.g), min(low.b, color.b))
                        : color;
            high = taken ? Color(max(high.r, color.r), max(high.g, color.g), max(high.b, color.b))
                         : color;
            sum = sum + sample;
            ++taken;
        };
        while (taken < least) take();
        if (differs(low.r, high.r) || differs(low.g, high.g) || differs(low.b, high.b))
            while (taken < most) take();
        pixel.setAlpha(sum.w / float(taken));
        return {sum.x / float(taken), sum.y / float(taken), sum.z / float(taken)};
    }

private:
    bool differs(float low, float high) const { return high - low > contrast * (high + low); }
};

/// The mean of `samples` paths (Kajiya, "The rendering equation", 1986): each surface adds the
/// light of one random direction in the place of ambient and environment approximations. Lights
/// are asked at every point of a path, so that geometry that glows should not be in their places
/// as well. Paths end where they meet nothing, at the frame's recursion limit (rtRecursionLimit;
/// it darkens where many reflections matter: raise it), and by Russian roulette where their share
/// of the pixel is small, which darkens nothing; see continuePath.
struct PathTracer {
    int samples = 0; ///< at most 4096; less than 1: what rtSamples asks for

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<int>("samples", PER_SHADER, offsetof(PathTracer, samples));
    }
    Color renderPixel(PixelContext& pixel) const {
        const RTuint asked =
            samples > 0 ? RTuint(std::min(samples, kMaxSamples)) : pixel.samples();
        const RTuint n = asked > 1 ? asked : 1u;
        Vec4 sum;
        for (RTuint i = 0; i < n; ++i) sum = sum + pixel.tracePath(pixel.samplePosition(i, n));
        pixel.setAlpha(sum.w / float(n));
        return {sum.x / float(n), sum.y / float(n), sum.z / float(n)};
    }
};

} // namespace smart::builtin
