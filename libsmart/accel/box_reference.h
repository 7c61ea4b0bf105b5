// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

#include "libsmart/accel/float4.h"
#include "libsmart/base/aabb.h"

namespace smart {

/// An Aabb in two registers; what the fourth lanes hold is no part of it.
struct Box4 {
    Float4 lo = allOf(Aabb::kInf);
    Float4 hi = allOf(-Aabb::kInf);

    Box4() = default;
    Box4(Float4 low, Float4 high) : lo(low), hi(high) {}
    explicit Box4(const Aabb& box)
        : lo{box.lo[0], box.lo[1], box.lo[2], 0.0f}, hi{box.hi[0], box.hi[1], box.hi[2], 0.0f} {}

    void add(const Box4& box) {
        lo = lesserOf(box.lo, lo);
        hi = greaterOf(box.hi, hi);
    }
    void add(Float4 point) {
        lo = lesserOf(point, lo);
        hi = greaterOf(point, hi);
    }
    bool empty() const {
        return !(lo[0] <= hi[0] && lo[1] <= hi[1] && lo[2] <= hi[2]);
    }
    Aabb aabb() const {
        Aabb box;
        for (int k = 0; k < 3; ++k) {
            box.lo[k] = lo[k];
            box.hi[k] = hi[k];
        }
        return box;
    }
    /// A quarter of the sum of both ends: can neither overflow, nor can a difference of two.
    /// Infinite ends count as the largest floats.
    Float4 quarter() const {
        constexpr float kMost = 0x1p126f;
        const Float4 sum = lo * allOf(0.25f) + hi * allOf(0.25f);
        return greaterOf(lesserOf(sum, allOf(kMost)), allOf(-kMost));
    }
};

/// What builders of trees sort: the box of a primitive, of a part of one or of a group of them.
struct BoxReference : Box4 {
    BoxReference() = default;
    BoxReference(const Box4& box, uint32_t number) : Box4(box) {
        lo[3] = std::bit_cast<float>(number + kOffset);
    }
    uint32_t number() const { return std::bit_cast<uint32_t>(float(lo[3])) - kOffset; }

    static constexpr uint32_t kMaxNumber = 1u << 27;

private:
    /// Numbers look like floats of ordinary size: arithmetic on denormal lanes would be slow.
    static constexpr uint32_t kOffset = 0x40000000u;
};

/// Half the area of boxes relative to the scene's size, at least a little: boxes without area are
/// told apart by their edges.
class BoxMeasure {
public:
    explicit BoxMeasure(const Box4& whole) {
        float size = 0;
        for (int k = 0; k < 3; ++k) {
            const float half = 0.5f * whole.hi[k] - 0.5f * whole.lo[k];
            if (half > size) size = half;
        }
        const float scale = 0.5f / size;
        scale_ = allOf(scale < Aabb::kInf ? scale : size > 0 ? 0x1p127f : 0.0f);
        wholeInverse_ = 1.0f / (*this)(whole);
    }
    float operator()(const Box4& box) const {
        const Float4 e = box.hi * scale_ - box.lo * scale_;
        const float area = e[0] * e[1] + e[1] * e[2] + e[2] * e[0] +
                           1e-6f * (e[0] + e[1] + e[2]) + 1e-12f;
        return area < 4.0f ? area : 4.0f;
    }
    /// Of the rays that meet everything, those that meet a box.
    float share(const Box4& box) const { return (*this)(box) * wholeInverse_; }

private:
    Float4 scale_;
    float wholeInverse_ = 1;
};

} // namespace smart
