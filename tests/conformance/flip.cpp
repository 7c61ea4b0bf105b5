// SPDX-License-Identifier: MIT
#include "tests/conformance/flip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace conformance {
namespace {

constexpr float kPixelsPerDegree = 67.0f;
constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kWhite[3] = {0.950428545f, 1.0f, 1.088900371f}; // D65

using Plane = std::vector<float>;
using Color = std::array<float, 3>;

struct Planes {
    int width, height;
    std::array<Plane, 3> channel;
};

float toLinear(std::uint8_t value) {
    const float v = float(value) / 255.0f;
    return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

Color toXyz(const Color& c) {
    return {0.4124564f * c[0] + 0.3575761f * c[1] + 0.1804375f * c[2],
            0.2126729f * c[0] + 0.7151522f * c[1] + 0.0721750f * c[2],
            0.0193339f * c[0] + 0.1191920f * c[1] + 0.9503041f * c[2]};
}

Color toRgb(const Color& c) {
    return {3.2404542f * c[0] - 1.5371385f * c[1] - 0.4985314f * c[2],
            -0.9692660f * c[0] + 1.8760108f * c[1] + 0.0415560f * c[2],
            0.0556434f * c[0] - 0.2040259f * c[1] + 1.0572252f * c[2]};
}

// The opponent space in which contrast sensitivity is applied.
Color toYCxCz(const Color& rgb) {
    const Color c = toXyz(rgb);
    const float x = c[0] / kWhite[0], y = c[1] / kWhite[1], z = c[2] / kWhite[2];
    return {116.0f * y - 16.0f, 500.0f * (x - y), 200.0f * (y - z)};
}

Color fromYCxCz(const Color& c) {
    const float y = (c[0] + 16.0f) / 116.0f, x = y + c[1] / 500.0f, z = y - c[2] / 200.0f;
    return toRgb({x * kWhite[0], y * kWhite[1], z * kWhite[2]});
}

// CIE L*a*b* with chroma weakened in the dark (Hunt).
Color toHuntLab(const Color& rgb) {
    const auto f = [](float t) {
        constexpr float delta = 6.0f / 29.0f;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0f / 29.0f;
    };
    const Color c = toXyz(rgb);
    const float x = f(c[0] / kWhite[0]), y = f(c[1] / kWhite[1]), z = f(c[2] / kWhite[2]);
    const float lightness = 116.0f * y - 16.0f, weight = 0.01f * lightness;
    return {lightness, weight * 500.0f * (x - y), weight * 200.0f * (y - z)};
}

float hyab(const Color& a, const Color& b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

Planes opponentPlanes(const Picture& picture) {
    Planes planes{picture.width, picture.height, {}};
    for (Plane& plane : planes.channel) plane.resize(picture.pixels.size());
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const auto& p = picture.pixels[i];
        const Color c = toYCxCz({toLinear(p[0]), toLinear(p[1]), toLinear(p[2])});
        for (std::size_t k = 0; k < 3; ++k) planes.channel[k][i] = c[k];
    }
    return planes;
}

// sum += weight * row, element by element.
void addScaled(float* sum, const float* row, float weight, int count) {
    for (int i = 0; i < count; ++i) sum[i] += weight * row[i];
}

// The plane under kernelX along rows and kernelY along columns; edges repeat.
Plane convolve(const Plane& plane, int width, int height, const Plane& kernelX,
               const Plane& kernelY) {
    const int radius = int(kernelX.size() / 2);
    const auto rowOf = [&](auto& of, int y) {
        return of.data() + std::size_t(std::clamp(y, 0, height - 1)) * std::size_t(width);
    };
    Plane rows(plane.size(), 0.0f), result(plane.size(), 0.0f);
    Plane padded(std::size_t(width + 2 * radius));
    for (int y = 0; y < height; ++y) {
        const float* row = rowOf(plane, y);
        for (int x = -radius; x < width + radius; ++x)
            padded[std::size_t(x + radius)] = row[std::clamp(x, 0, width - 1)];
        for (int k = 0; k <= 2 * radius; ++k)
            addScaled(rowOf(rows, y), padded.data() + k, kernelX[std::size_t(k)], width);
    }
    for (int y = 0; y < height; ++y)
        for (int k = -radius; k <= radius; ++k)
            addScaled(rowOf(result, y), rowOf(rows, y + k), kernelY[std::size_t(k + radius)],
                      width);
    return result;
}

// One Gaussian of a contrast sensitivity function, exp(-pi^2 z^2 / b) with z in degrees; its sum
// over both dimensions is the square of its sum along one.
Plane sensitivityKernel(float b, int radius) {
    Plane kernel;
    for (int k = -radius; k <= radius; ++k) {
        const float z = float(k) / kPixelsPerDegree;
        kernel.push_back(std::exp(-kPi * kPi * z * z / b));
    }
    return kernel;
}

float sumOf(const Plane& plane) {
    float sum = 0;
    for (const float value : plane) sum += value;
    return sum;
}

struct Sensitivity {
    float a1, b1, a2, b2;
};

Plane filtered(const Plane& plane, int width, int height, const Sensitivity& s, int radius) {
    Plane result(plane.size(), 0.0f);
    float total = 0;
    const auto add = [&](float a, float b) {
        const Plane kernel = sensitivityKernel(b, radius);
        const float scale = a * std::sqrt(kPi / b), sum = sumOf(kernel);
        const Plane part = convolve(plane, width, height, kernel, kernel);
        for (std::size_t i = 0; i < part.size(); ++i) result[i] += scale * part[i];
        total += scale * sum * sum;
    };
    add(s.a1, s.b1);
    if (s.a2 > 0) add(s.a2, s.b2);
    for (float& value : result) value /= total;
    return result;
}

// What the eye resolves, as Hunt-adjusted L*a*b*.
std::vector<Color> perceived(const Planes& planes) {
    static constexpr Sensitivity kChannels[3] = {
        {1.0f, 0.0047f, 0.0f, 0.0f}, {1.0f, 0.0053f, 0.0f, 0.0f}, {34.1f, 0.04f, 13.5f, 0.025f}};
    const int radius = int(std::ceil(3 * std::sqrt(0.04f / (2 * kPi * kPi)) * kPixelsPerDegree));
    std::array<Plane, 3> channel;
    for (std::size_t k = 0; k < 3; ++k)
        channel[k] = filtered(planes.channel[k], planes.width, planes.height, kChannels[k], radius);
    std::vector<Color> result(channel[0].size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        Color rgb = fromYCxCz({channel[0][i], channel[1][i], channel[2][i]});
        for (float& value : rgb) value = std::clamp(value, 0.0f, 1.0f);
        result[i] = toHuntLab(rgb);
    }
    return result;
}

// The largest differences are compressed: 0.4 of the largest possible becomes 0.95.
float redistributed(float difference) {
    static const float largest =
        std::pow(hyab(toHuntLab({0.0f, 1.0f, 0.0f}), toHuntLab({0.0f, 0.0f, 1.0f})), 0.7f);
    const float error = std::pow(difference, 0.7f), knee = 0.4f * largest;
    if (error < knee) return error * 0.95f / knee;
    return 0.95f + (error - knee) / (largest - knee) * 0.05f;
}

struct Features {
    Plane edges, points;
};

Plane magnitude(const Plane& x, const Plane& y) {
    Plane result(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) result[i] = std::hypot(x[i], y[i]);
    return result;
}

// First and second derivatives of a Gaussian; positive weights sum to 1, negative ones to -1.
Features featuresOf(const Planes& planes) {
    const float deviation = 0.5f * 0.082f * kPixelsPerDegree;
    const int radius = int(std::ceil(3 * deviation));
    Plane smooth, edge, point;
    for (int k = -radius; k <= radius; ++k) {
        const float x = float(k), g = std::exp(-x * x / (2 * deviation * deviation));
        smooth.push_back(g);
        edge.push_back(-x * g);
        point.push_back((x * x / (deviation * deviation) - 1) * g);
    }
    const float total = sumOf(smooth);
    for (float& value : smooth) value /= total;
    for (Plane* kernel : {&edge, &point}) {
        float positive = 0, negative = 0;
        for (const float value : *kernel) (value > 0 ? positive : negative) += std::abs(value);
        for (float& value : *kernel) value /= value > 0 ? positive : negative;
    }
    Plane luminance = planes.channel[0];
    for (float& value : luminance) value = (value + 16.0f) / 116.0f;
    const auto along = [&](const Plane& x, const Plane& y) {
        return convolve(luminance, planes.width, planes.height, x, y);
    };
    return {magnitude(along(edge, smooth), along(smooth, edge)),
            magnitude(along(point, smooth), along(smooth, point))};
}

} // namespace

std::vector<float> flipErrors(const Picture& reference, const Picture& test) {
    const Planes planesA = opponentPlanes(reference), planesB = opponentPlanes(test);
    const std::vector<Color> colorsA = perceived(planesA), colorsB = perceived(planesB);
    const Features featuresA = featuresOf(planesA), featuresB = featuresOf(planesB);
    std::vector<float> errors(colorsA.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const float color = redistributed(hyab(colorsA[i], colorsB[i]));
        const float difference = std::max(std::abs(featuresA.edges[i] - featuresB.edges[i]),
                                          std::abs(featuresA.points[i] - featuresB.points[i]));
        const float feature = std::sqrt(difference / std::numbers::sqrt2_v<float>);
        errors[i] = std::pow(color, 1.0f - feature);
    }
    return errors;
}

float meanOf(const std::vector<float>& errors) {
    double sum = 0;
    for (const float error : errors) sum += error;
    return errors.empty() ? 0.0f : float(sum / double(errors.size()));
}

} // namespace conformance
