// SPDX-License-Identifier: MIT
#include "libsmart/geometry/triangle_corners.h"

#include <algorithm>

namespace smart {
namespace {

template <class T>
void reserveMore(std::vector<T>& vector, std::size_t n) {
    if (vector.capacity() - vector.size() < n)
        vector.reserve(std::max(vector.size() + n, 2 * vector.capacity()));
}

} // namespace

void TriangleCorners::makeRoom(std::size_t n) {
    reserveMore(runs_, n);
    reserveMore(firstRuns_, n / kTrianglesOfEntry + 1);
}

void TriangleCorners::push_back(const Corners& corners) {
    const uint32_t triangle = uint32_t(size_);
    const auto startRun = [&] {
        Run run;
        run.first = triangle;
        run.start[0] = corners;
        runs_.push_back(run);
    };
    if (runs_.empty()) startRun();
    Run* run = &runs_.back();
    if (run->count == 1) {
        run->start[1] = corners;
    } else if (run->count == 2 || run->count == 3) {
        const std::size_t odd = run->count & 1;
        for (std::size_t k = 0; k < 3; ++k) run->step[odd][k] = corners[k] - run->start[odd][k];
    } else if (run->count > 3 && run->corners(triangle) != corners) {
        startRun();
        run = &runs_.back();
    }
    if (triangle % kTrianglesOfEntry == 0) firstRuns_.push_back(uint32_t(runs_.size() - 1));
    ++run->count;
    ++size_;
}

void TriangleCorners::shrink_to_fit() {
    runs_.shrink_to_fit();
    firstRuns_.shrink_to_fit();
}

bool operator==(const TriangleCorners& a, const TriangleCorners& b) {
    if (a.size_ != b.size_) return false;
    for (std::size_t i = 0; i < a.size_; ++i)
        if (a[i] != b[i]) return false;
    return true;
}

} // namespace smart
