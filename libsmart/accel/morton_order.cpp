// SPDX-License-Identifier: MIT
#include "libsmart/accel/morton_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "libsmart/accel/reference_list.h"

namespace smart {
namespace {

constexpr int kBitsOfAxis = 10;
constexpr int kDigitBits = 10, kDigits = 1 << kDigitBits;
constexpr std::size_t kLeastToShare = 32768; ///< keys that are worth several threads
constexpr std::size_t kLeastForRadix = 1024;
constexpr std::size_t kLongRun = 16; ///< of keys with one code: these go along a finer curve
constexpr int kFinest = 8;           ///< curves within curves

/// A cube around all centres, in steps of the curve.
class Curve {
public:
    explicit Curve(const Box4& centres) : low_(centres.lo) {
        low_[3] = 0;
        float extent = 0;
        for (int k = 0; k < 3; ++k) extent = std::max(extent, centres.hi[k] - centres.lo[k]);
        const float scale = float(1 << kBitsOfAxis) * 0.9999f / extent;
        scale_ = scale < Aabb::kInf ? scale : 0.0f;
    }
    uint32_t code(const Box4& box) const {
        const Float4 place = (box.quarter() - low_) * allOf(scale_);
        const float last = float((1 << kBitsOfAxis) - 1);
        Int4 x = toIntegers(greaterOf(lesserOf(place, allOf(last)), allOf(0.0f)));
        // Two free bits between each two.
        x = (x | x << 16) & 0x030000FF;
        x = (x | x << 8) & 0x0300F00F;
        x = (x | x << 4) & 0x030C30C3;
        x = (x | x << 2) & 0x09249249;
        return uint32_t(x[0]) << 2 | uint32_t(x[1]) << 1 | uint32_t(x[2]);
    }

private:
    Float4 low_;
    float scale_;
};

MortonKey makeKey(uint32_t code, uint32_t number) { return MortonKey(code) << 32 | number; }

/// By code, stable, the least digit first; parts of the keys by several threads.
void sortByCode(std::vector<MortonKey>& keys, BuildCrew& crew) {
    if (keys.size() < kLeastForRadix) {
        std::sort(keys.begin(), keys.end());
        return;
    }
    const std::size_t parts = keys.size() < kLeastToShare ? 1 : crew.threads();
    const std::size_t size = (keys.size() + parts - 1) / parts;
    std::vector<std::array<uint32_t, kDigits>> counts(parts);
    std::vector<MortonKey> other(keys.size());
    for (int shift = 32; shift < 32 + 3 * kBitsOfAxis; shift += kDigitBits) {
        const auto digit = [shift](MortonKey key) {
            return std::size_t(key >> shift) & (kDigits - 1);
        };
        const auto partOf = [&](std::size_t part) {
            const std::size_t begin = std::min(keys.size(), part * size);
            return std::span(keys).subspan(begin, std::min(size, keys.size() - begin));
        };
        crew.forEach(parts, [&](std::size_t part) {
            counts[part].fill(0);
            for (const MortonKey key : partOf(part)) ++counts[part][digit(key)];
        });
        uint32_t at = 0;
        for (std::size_t d = 0; d < kDigits; ++d)
            for (auto& count : counts) at += std::exchange(count[d], at);
        crew.forEach(parts, [&](std::size_t part) {
            for (const MortonKey key : partOf(part)) other[counts[part][digit(key)]++] = key;
        });
        keys.swap(other);
    }
}

/// Puts keys of one code in the order of a curve through their own bounds.
void refine(std::span<MortonKey> keys, std::span<const Aabb> boxes, int finer) {
    Box4 centres;
    for (const MortonKey key : keys) centres.add(Box4(boxes[mortonNumber(key)]).quarter());
    const Curve curve(centres);
    const uint32_t code = mortonCode(keys[0]);
    for (MortonKey& key : keys)
        key = makeKey(curve.code(Box4(boxes[mortonNumber(key)])), mortonNumber(key));
    std::sort(keys.begin(), keys.end());
    if (finer < kFinest && mortonCode(keys.front()) != mortonCode(keys.back())) {
        for (std::size_t i = 0, end; i < keys.size(); i = end) {
            for (end = i; end < keys.size() && mortonCode(keys[end]) == mortonCode(keys[i]);) ++end;
            if (end - i > kLongRun) refine(keys.subspan(i, end - i), boxes, finer + 1);
        }
    }
    for (MortonKey& key : keys) key = makeKey(code, mortonNumber(key));
}

} // namespace

MortonOrder mortonOrder(std::span<const Aabb> boxes, BuildCrew& crew) {
    const std::vector<uint32_t> before = countBoxes(boxes, crew);
    const std::size_t parts = before.size() - 1;
    const auto visit = [&](std::size_t part, const auto& what) {
        const std::size_t begin = part * kBoxesOfPart;
        const std::size_t end = std::min(boxes.size(), begin + kBoxesOfPart);
        for (std::size_t i = begin; i < end; ++i)
            if (!boxes[i].empty()) what(uint32_t(i), Box4(boxes[i]));
    };
    std::vector<ReferenceBounds> boundsOfParts(parts);
    crew.forEach(parts, [&](std::size_t part) {
        ReferenceBounds bounds;
        visit(part, [&](uint32_t number, const Box4& box) {
            bounds.add(BoxReference(box, number));
        });
        boundsOfParts[part] = bounds;
    });
    ReferenceBounds bounds;
    for (const ReferenceBounds& part : boundsOfParts) bounds.add(part);
    const Curve curve(bounds.centres);
    std::vector<MortonKey> keys(before.back());
    crew.forEach(parts, [&](std::size_t part) {
        std::size_t at = before[part];
        visit(part, [&](uint32_t number, const Box4& box) {
            keys[at++] = makeKey(curve.code(box), number);
        });
    });
    sortByCode(keys, crew);
    for (std::size_t i = 0; i + kLongRun < keys.size();) {
        if (mortonCode(keys[i]) != mortonCode(keys[i + kLongRun])) {
            ++i;
            continue;
        }
        std::size_t end = i + kLongRun;
        while (end < keys.size() && mortonCode(keys[end]) == mortonCode(keys[i])) ++end;
        refine(std::span(keys).subspan(i, end - i), boxes, 1);
        i = end;
    }
    return {std::move(keys), bounds.box};
}

std::size_t mortonSplit(std::span<const MortonKey> keys) {
    const uint32_t first = mortonCode(keys.front()), last = mortonCode(keys.back());
    if (first == last) return keys.size() / 2;
    const uint32_t bit = std::bit_floor(first ^ last);
    const auto right = std::partition_point(keys.begin(), keys.end(), [bit](MortonKey key) {
        return (mortonCode(key) & bit) == 0;
    });
    return std::size_t(right - keys.begin());
}

} // namespace smart
