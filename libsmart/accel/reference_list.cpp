// SPDX-License-Identifier: MIT
#include "libsmart/accel/reference_list.h"

#include <algorithm>

#include "libsmart/base/error.h"

namespace smart {
namespace {

template <class Visit>
void visitBoxes(std::span<const Aabb> boxes, std::size_t part, const Visit& visit) {
    const std::size_t begin = part * kBoxesOfPart;
    const std::size_t end = std::min(boxes.size(), begin + kBoxesOfPart);
    for (std::size_t i = begin; i < end; ++i)
        if (!boxes[i].empty()) visit(i);
}

} // namespace

std::vector<uint32_t> countBoxes(std::span<const Aabb> boxes, BuildCrew& crew) {
    constexpr const char* kTooMany = "box tree: more than 2^27 primitives";
    if (boxes.size() > BoxReference::kMaxNumber) throw Error(ErrorCode::OutOfMemory, kTooMany);
    const std::size_t parts = partsOfBoxes(boxes.size());
    std::vector<uint32_t> before(parts + 1);
    crew.forEach(parts, [&](std::size_t part) {
        uint32_t count = 0;
        visitBoxes(boxes, part, [&](std::size_t) { ++count; });
        before[part + 1] = count;
    });
    for (std::size_t part = 0; part < parts; ++part) before[part + 1] += before[part];
    return before;
}

ReferenceList listReferences(std::span<const Aabb> boxes, double extraShare, BuildCrew& crew) {
    const std::vector<uint32_t> before = countBoxes(boxes, crew);
    ReferenceList list;
    list.count = before.back();
    const std::size_t count = list.count, extra = std::size_t(double(count) * extraShare);
    list.references.resize(
        std::max(count, std::min<std::size_t>(count + extra, BoxReference::kMaxNumber)));
    std::vector<ReferenceBounds> bounds(before.size());
    crew.forEach(before.size() - 1, [&](std::size_t part) {
        uint32_t at = before[part];
        ReferenceBounds ofPart;
        visitBoxes(boxes, part, [&](std::size_t i) {
            const auto reference = BoxReference(Box4(boxes[i]), uint32_t(i));
            list.references[at++] = reference;
            ofPart.add(reference);
        });
        bounds[part] = ofPart;
    });
    for (const ReferenceBounds& ofPart : bounds) list.bounds.add(ofPart);
    return list;
}

} // namespace smart
