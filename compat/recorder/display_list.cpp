// SPDX-License-Identifier: MIT
#include "compat/recorder/display_list.h"

#include <algorithm>
#include <new>

namespace smart::compat {

namespace {

bool hasCall(ListOp op) {
    return op <= ListOp::End;
}

std::size_t wordCount(ListOp op) {
    switch (op) {
    case ListOp::Vertex3:
    case ListOp::Normal: return 3;
    case ListOp::Color: return 4;
    case ListOp::Vertex4: return 8;
    default: return op >= ListOp::TexCoord ? 4 : 0;
    }
}

bool isAttribute(ListOp op) {
    return op == ListOp::Attribute || op >= ListOp::Normal;
}

} // namespace

void CallStream::call(ListOp op, RecordedCall recorded) {
    calls_.push_back(std::move(recorded));
    ops_.push_back(op);
}

void CallStream::vertex(const glm::dvec4& position) {
    const glm::vec3 single(position);
    if (position.w == 1.0 && glm::dvec3(single) == glm::dvec3(position)) {
        floats(ListOp::Vertex3, &single.x, 3);
        return;
    }
    for (int k = 0; k < 4; ++k) {
        const uint64_t bits = std::bit_cast<uint64_t>(position[k]);
        words_.push_back(uint32_t(bits));
        words_.push_back(uint32_t(bits >> 32));
    }
    ops_.push_back(ListOp::Vertex4);
}

void CallStream::floats(ListOp op, const float* values, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) words_.push_back(std::bit_cast<uint32_t>(values[i]));
    ops_.push_back(op);
}

void CallStream::advance(Position& at) const {
    const ListOp op = ops_[at.op++];
    at.word += wordCount(op);
    at.call += hasCall(op);
}

glm::dvec4 CallStream::vertexAt(const Position& at) const {
    if (op(at) == ListOp::Vertex3) return {glm::dvec3(vec3At(at)), 1.0};
    glm::dvec4 position;
    for (int k = 0; k < 4; ++k) {
        const std::size_t low = at.word + 2 * std::size_t(k);
        position[k] = std::bit_cast<double>(words_[low] | uint64_t(words_[low + 1]) << 32);
    }
    return position;
}

// A run starts and ends outside of begin and end, and holds whole primitives only. A primitive
// that is not whole belongs to the calls around it, as does a vertex or an end without a begin:
// the list may be meant to be called between another's begin and end.
DisplayList::DisplayList(CallStream calls) : calls_(std::move(calls)) {
    using Position = CallStream::Position;
    const Position end = calls_.end();
    Position start;        // of the segment under way
    Position begun;        // of the primitive under way
    bool run = false;      // the segment under way is a run
    bool complete = false; // and has a primitive
    bool inside = false;
    const auto cut = [&](const Position& at) {
        addSegment(start, at, run && complete);
        start = at;
        complete = false;
    };
    Position at;
    while (at.op < end.op) {
        const ListOp op = calls_.op(at);
        if (run && inside && (hasCall(op) && op != ListOp::End && op != ListOp::Attribute)) {
            cut(begun);
            run = false;
        } else if (!inside && !run && (isAttribute(op) || op == ListOp::BeginFilled)) {
            cut(at);
            run = true;
        } else if (!inside && run && !isAttribute(op) && op != ListOp::BeginFilled) {
            cut(at);
            run = false;
        }
        if (op == ListOp::BeginFilled || op == ListOp::BeginOther) {
            begun = at;
            inside = true;
        } else if (op == ListOp::End) {
            complete = inside;
            inside = false;
        }
        calls_.advance(at);
    }
    if (run && inside) {
        cut(begun);
        run = false;
    }
    cut(end);
}

void DisplayList::addSegment(const CallStream::Position& begin, const CallStream::Position& end,
                             bool isRun) {
    if (begin.op == end.op) return;
    if (!isRun && !segments_.empty() && !segments_.back().isRun) {
        segments_.back().end = end;
        return;
    }
    ListSegment& segment = segments_.emplace_back();
    segment.begin = begin;
    segment.end = end;
    segment.isRun = isRun;
    if (isRun) noteWhatIsLeft(segment);
}

void DisplayList::noteWhatIsLeft(ListSegment& run) const {
    for (CallStream::Position at = run.begin; at.op < run.end.op; calls_.advance(at)) {
        const ListOp op = calls_.op(at);
        if (op == ListOp::Color) run.color = calls_.vec4At(at);
        if (op >= ListOp::TexCoord) run.texCoords[calls_.unitAt(at)] = calls_.vec4At(at);
        if (op == ListOp::Normal) run.normal = calls_.vec3At(at);
        if (op == ListOp::Attribute) run.attributeCalls.push_back(at.call);
    }
    // Of calls that replace the same value the last one counts.
    std::vector<uint64_t> replaced;
    std::vector<std::size_t> last;
    for (auto call = run.attributeCalls.rbegin(); call != run.attributeCalls.rend(); ++call) {
        const uint64_t key = calls_.call(*call).attribute;
        if (std::find(replaced.begin(), replaced.end(), key) != replaced.end()) continue;
        replaced.push_back(key);
        last.push_back(*call);
    }
    run.attributeCalls.assign(last.rbegin(), last.rend());
}

bool ListRecording::lose() noexcept {
    lost_ = true;
    calls_ = CallStream();
    return executes_;
}

DisplayList ListRecording::finish() {
    if (lost_) throw std::bad_alloc();
    return DisplayList(std::move(calls_));
}

} // namespace smart::compat
