// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "compat/recorder/compiled_run.h"
#include "libsmart/geometry/texture_units.h"

namespace smart::compat {

class Context;

/// A call as a display list keeps it.
struct RecordedCall {
    const char* function;
    std::function<void(Context&)> body;
    /// Which of the current values the call replaces as a whole: a later call with the same key
    /// makes this one void.
    uint64_t attribute = 0;
};

enum class ListOp : uint8_t {
    Call,
    Attribute, ///< a call that sets what vertices latch
    BeginFilled,
    BeginOther, ///< points and lines, or no primitive at all
    End,
    Vertex3,
    Vertex4,
    Normal,
    Color,
    TexCoord, ///< of the first texture unit; those of the others follow
};

/// Calls in order: one byte each, and their arguments in the order of reading. The vertices and
/// attributes of a big list are a few bytes each, all other calls closures.
class CallStream {
public:
    /// Between two calls.
    struct Position {
        std::size_t op = 0, word = 0, call = 0;
    };

    // Each throws std::bad_alloc, and may then leave arguments without their call.
    void call(ListOp op, RecordedCall recorded);
    void vertex(const glm::dvec4& position);
    void normal(const glm::vec3& v) { floats(ListOp::Normal, &v.x, 3); }
    void color(const glm::vec4& v) { floats(ListOp::Color, &v.x, 4); }
    void texCoord(const glm::vec4& v, std::size_t unit) {
        floats(ListOp(std::size_t(ListOp::TexCoord) + unit), &v.x, 4);
    }

    Position end() const { return {ops_.size(), words_.size(), calls_.size()}; }
    ListOp op(const Position& at) const { return ops_[at.op]; }
    void advance(Position& at) const;
    glm::dvec4 vertexAt(const Position& at) const;
    glm::vec3 vec3At(const Position& at) const { return {word(at, 0), word(at, 1), word(at, 2)}; }
    glm::vec4 vec4At(const Position& at) const { return {vec3At(at), word(at, 3)}; }
    std::size_t unitAt(const Position& at) const {
        return std::size_t(op(at)) - std::size_t(ListOp::TexCoord);
    }
    const RecordedCall& callAt(const Position& at) const { return calls_[at.call]; }
    const RecordedCall& call(std::size_t number) const { return calls_[number]; }

private:
    void floats(ListOp op, const float* values, std::size_t n);
    float word(const Position& at, std::size_t k) const {
        return std::bit_cast<float>(words_[at.word + k]);
    }

    std::vector<ListOp> ops_;
    std::vector<uint32_t> words_;
    std::vector<RecordedCall> calls_;
};

/// A part of a list: a run of whole primitives and attributes, which is placed as an object, or
/// anything else, which is replayed call by call.
struct ListSegment {
    CallStream::Position begin, end;
    bool isRun = false;

    // What a run leaves as current values.
    std::optional<glm::vec4> color;
    std::array<std::optional<glm::vec4>, kTextureUnits> texCoords;
    std::optional<glm::vec3> normal;
    std::vector<std::size_t> attributeCalls;

    std::optional<CompiledRun> compiled; ///< made when it is needed first
    bool hasErrors = false;              ///< calls of the run fail: it is replayed call by call
};

/// What rtCallList replays.
class DisplayList {
public:
    /// Finds the runs. Throws std::bad_alloc.
    explicit DisplayList(CallStream calls);

    const CallStream& calls() const { return calls_; }
    std::vector<ListSegment>& segments() { return segments_; }

private:
    void addSegment(const CallStream::Position& begin, const CallStream::Position& end,
                    bool isRun);
    void noteWhatIsLeft(ListSegment& run) const;

    CallStream calls_;
    std::vector<ListSegment> segments_;
};

/// A list under compilation. Where memory runs out it loses its contents and nothing else.
class ListRecording {
public:
    ListRecording(uint32_t name, bool executes) : name_(name), executes_(executes) {}

    uint32_t name() const { return name_; }
    bool executes() const { return executes_; }

    // Each keeps a call and returns whether it is to be carried out as well.
    bool call(ListOp op, RecordedCall recorded) noexcept {
        return keep([&] { calls_.call(op, std::move(recorded)); });
    }
    bool vertex(const glm::dvec4& v) noexcept { return keep([&] { calls_.vertex(v); }); }
    bool normal(const glm::vec3& v) noexcept { return keep([&] { calls_.normal(v); }); }
    bool color(const glm::vec4& v) noexcept { return keep([&] { calls_.color(v); }); }
    bool texCoord(const glm::vec4& v, std::size_t unit) noexcept {
        return keep([&] { calls_.texCoord(v, unit); });
    }
    /// A call that there was no memory to copy.
    bool lose() noexcept;

    /// The list; throws std::bad_alloc, also where memory ran out earlier.
    DisplayList finish();

private:
    template <class Keep>
    bool keep(Keep&& keepIt) noexcept {
        if (lost_) return executes_;
        try {
            keepIt();
        } catch (...) {
            return lose();
        }
        return executes_;
    }

    CallStream calls_;
    uint32_t name_;
    bool executes_, lost_ = false;
};

} // namespace smart::compat
