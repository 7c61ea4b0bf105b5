// SPDX-License-Identifier: MIT
#include "libsmart/render/point_raster.h"

#include <glm/geometric.hpp>

#include "libsmart/render/line_raster.h"

namespace smart {

double limitedSize(float size) {
    return size > 1.0f ? double(std::min(size, kMaxPixelSize)) : 1.0;
}

uint32_t wholePixels(float size) {
    return uint32_t(limitedSize(size) + 0.5);
}

float pointSizeAt(const FixedRaster& raster, const glm::dvec3& eye) {
    double size = raster.pointSize;
    if (raster.pointAttenuation != glm::vec3(1.0f, 0.0f, 0.0f)) {
        const glm::dvec3 attenuation(raster.pointAttenuation);
        const double squared = glm::dot(eye, eye);
        const double left =
            attenuation.x + attenuation.y * std::sqrt(squared) + attenuation.z * squared;
        size /= std::sqrt(left); // infinite, or no number: the limits remain
    }
    size = size < raster.pointSizeMax ? size : double(raster.pointSizeMax);
    return float(size > raster.pointSizeMin ? size : double(raster.pointSizeMin));
}

PixelBox pointSquare(const glm::dvec2& at, float size) {
    const int64_t side = wholePixels(size);
    // Both cases in one: the lowest pixel is floor(at - side / 2 + 1/2).
    const auto lowest = [side](double coordinate) {
        const int64_t place = toSubpixels(coordinate) - (side - 1) * (kSubpixels / 2);
        return int64_t(std::floor(double(place) / kSubpixels));
    };
    const int64_t x = lowest(at.x), y = lowest(at.y);
    return {x, y, x + side, y + side};
}

PointDisc::PointDisc(const glm::dvec2& at, float size)
    : center_(at), radius_(limitedSize(size) / 2) {}

PixelBox PointDisc::box() const {
    const auto low = [this](double c) { return int64_t(std::floor(c - radius_)); };
    const auto high = [this](double c) { return int64_t(std::floor(c + radius_)) + 1; };
    return {low(center_.x), low(center_.y), high(center_.x), high(center_.y)};
}

bool PointDisc::contains(const glm::dvec2& point) const {
    const glm::dvec2 offset = point - center_;
    return offset.x * offset.x + offset.y * offset.y < radius_ * radius_;
}

double PointDisc::coverage(uint32_t x, uint32_t y) const {
    constexpr int kSide = 16;
    constexpr double kHalfDiagonal = 0.70710678118654752;
    const glm::dvec2 offset = glm::dvec2(x + 0.5, y + 0.5) - center_;
    const double distance = std::sqrt(offset.x * offset.x + offset.y * offset.y);
    if (distance <= radius_ - kHalfDiagonal) return 1.0;
    if (distance >= radius_ + kHalfDiagonal) return 0.0;
    int inside = 0;
    for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i)
            inside += contains({x + (i + 0.5) / kSide, y + (j + 0.5) / kSide});
    return double(inside) / (kSide * kSide);
}

} // namespace smart
