// SPDX-License-Identifier: MIT
#include "libsmart/render/line_raster.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace smart {
namespace {

constexpr int64_t kHalf = kSubpixels / 2;

int64_t floorDivide(int64_t a, int64_t b) {
    const int64_t quotient = a / b;
    return quotient - (a % b != 0 && (a < 0) != (b < 0));
}

int64_t centerOf(int64_t pixel) {
    return pixel * kSubpixels + kHalf;
}
/// The first pixel whose centre is not below, the last whose centre is below.
int64_t firstFrom(int64_t position) {
    return -floorDivide(kHalf - position, kSubpixels);
}
int64_t lastBelow(int64_t position) {
    return firstFrom(position) - 1;
}

} // namespace

int64_t toSubpixels(double coordinate) {
    return int64_t(std::floor(coordinate * kSubpixels + 0.5));
}

LineCoverage::LineCoverage(const glm::dvec2& from, const glm::dvec2& to, uint32_t width)
    : width_(width) {
    const int64_t ax = toSubpixels(from.x), ay = toSubpixels(from.y);
    const int64_t bx = toSubpixels(to.x), by = toSubpixels(to.y);
    steep_ = std::abs(by - ay) > std::abs(bx - ax);
    const int64_t shift = (int64_t(width) - 1) * kHalf;
    fromMajor_ = steep_ ? ay : ax;
    toMajor_ = steep_ ? by : bx;
    fromMinor_ = (steep_ ? ax : ay) - shift;
    toMinor_ = (steep_ ? bx : by) - shift;
    forward_ = toMajor_ >= fromMajor_;
    if (fromMajor_ == toMajor_) return;

    // The line's part in a diamond always reaches the diamond's middle, as it is not steeper than
    // the sides: a step belongs to the line if that middle does, and near the ends if the end
    // lies in the diamond.
    int64_t last;
    if (forward_) {
        first_ = firstFrom(fromMajor_);
        if (diamondHolds(fromMajor_, fromMinor_, first_ - 1)) --first_;
        last = lastBelow(toMajor_);
        if (diamondHolds(toMajor_, toMinor_, last)) --last;
    } else {
        first_ = lastBelow(fromMajor_);
        if (diamondHolds(fromMajor_, fromMinor_, first_ + 1)) ++first_;
        last = firstFrom(toMajor_);
        if (diamondHolds(toMajor_, toMinor_, last)) ++last;
    }
    const int64_t length = forward_ ? last - first_ + 1 : first_ - last + 1;
    length_ = uint32_t(std::max<int64_t>(length, 0));
}

int64_t LineCoverage::lowestAt(int64_t major) const {
    const int64_t run = toMajor_ - fromMajor_, rise = toMinor_ - fromMinor_;
    const int64_t numerator = fromMinor_ * run + rise * (centerOf(major) - fromMajor_);
    const int64_t pixel = floorDivide(numerator, run * kSubpixels);
    // Exactly between two pixels: moving the ends takes the line down, or to the left; a line
    // that rises to the right it takes up.
    const bool tie = numerator == pixel * run * kSubpixels;
    const bool rises = !steep_ && rise != 0 && (rise > 0) == (run > 0);
    return tie && !rises ? pixel - 1 : pixel;
}

// Of a step's lowest pixel, with the end moved by (-e, -e * e).
bool LineCoverage::diamondHolds(int64_t major, int64_t minor, int64_t pixel) const {
    const int64_t alongMajor = major - centerOf(pixel);
    const int64_t alongMinor = minor - centerOf(lowestAt(pixel));
    const int64_t distance = std::abs(alongMajor) + std::abs(alongMinor);
    if (distance != kHalf) return distance < kHalf;
    return (steep_ ? alongMinor : alongMajor) > 0;
}

LineRectangle::LineRectangle(const glm::dvec2& from, const glm::dvec2& to, double width)
    : from_(from), halfWidth_(width / 2), length_(glm::length(to - from)) {
    if (!(length_ > 0)) return;
    direction_ = (to - from) / length_;
    const glm::dvec2 side(-direction_.y * halfWidth_, direction_.x * halfWidth_);
    corners_[0] = from - side;
    corners_[1] = to - side;
    corners_[2] = to + side;
    corners_[3] = from + side;
}

double LineRectangle::along(const glm::dvec2& point) const {
    return glm::dot(point - from_, direction_);
}

double LineRectangle::across(const glm::dvec2& point) const {
    const glm::dvec2 offset = point - from_;
    return direction_.x * offset.y - direction_.y * offset.x;
}

bool LineRectangle::contains(const glm::dvec2& point) const {
    const double t = along(point), s = across(point);
    return t >= 0 && t < length_ && s >= -halfWidth_ && s < halfWidth_;
}

// The area of the rectangle clipped by the sides of the square.
double LineRectangle::coverage(int64_t x, int64_t y) const {
    glm::dvec2 polygon[8], clipped[8];
    int count = 4;
    std::copy(corners_, corners_ + 4, polygon);
    for (int side = 0; side < 4; ++side) {
        const int axis = side / 2;
        const double sign = side % 2 == 0 ? 1.0 : -1.0;
        const double limit = double(axis == 0 ? x : y) + side % 2;
        int kept = 0;
        for (int i = 0; i < count; ++i) {
            const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % count];
            const double da = sign * (a[axis] - limit), db = sign * (b[axis] - limit);
            if (da >= 0) clipped[kept++] = a;
            if ((da >= 0) != (db >= 0)) clipped[kept++] = a + (b - a) * (da / (da - db));
        }
        count = kept;
        std::copy(clipped, clipped + count, polygon);
    }
    double doubleArea = 0.0;
    for (int i = 0; i < count; ++i) {
        const glm::dvec2 a = polygon[i] - polygon[0], b = polygon[(i + 1) % count] - polygon[0];
        doubleArea += a.x * b.y - a.y * b.x;
    }
    return std::min(std::abs(doubleArea) / 2, 1.0);
}

} // namespace smart
