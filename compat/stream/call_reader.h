// SPDX-License-Identifier: MIT
// Records as what they say, before anything is done with it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compat/stream/call_table.h"
#include "compat/stream/record_format.h"
#include "openrt/types.h"

namespace smart::compat {

/// An argument, or one of several pointers that an argument leads to.
struct RecordedArgument {
    PointerTag tag = PointerTag::Null; ///< of pointers
    CallValue value;                   ///< of others, and of PointerTag::Number
    std::span<const std::byte> bytes;
    std::vector<RecordedArgument> pieces;
};

/// Some elements of a vertex array, with their stride.
struct RecordedArray {
    uint8_t kind; ///< of the recorder's kinds of arrays, from 0: see arrayNames()
    RTenum type;
    RTint size;
    uint32_t stride; ///< as it was given
    uint64_t first, elements;
    std::span<const std::byte> bytes;

    uint64_t elementBytes() const;
    uint64_t step() const { return stride ? stride : elementBytes(); }
};

struct CallRecord {
    const CallSignature* call = nullptr;
    std::vector<RecordedArgument> arguments;
    std::vector<RecordedArray> arrays;
    bool hasMapped = false;
    std::span<const std::byte> mapped;
};
struct OutcomeRecord {
    const CallSignature* call = nullptr;
    RTenum error = 0;
    CallValue result;
    uint64_t hash = 0; ///< of pixels that were read; 0: none
    std::vector<RTuint> names;
};
struct PictureRecord {
    uint64_t key = 0;
    uint32_t width = 0, height = 0;
    RTenum format = 0;
    uint64_t stride = 0, hash = 0;
};

/// Understands the records of one stream, whose functions may have other numbers than here. Spans
/// lead into the records. Functions throw StreamError.
class CallReader {
public:
    bool isStarted() const { return isStarted_; }
    const std::string& libraryVersion() const { return libraryVersion_; }
    void readStart(std::span<const std::byte> record);
    void readCall(std::span<const std::byte> record, CallRecord& call) const;
    OutcomeRecord readOutcome(std::span<const std::byte> record) const;
    static PictureRecord readPicture(std::span<const std::byte> record);

private:
    const CallSignature& callOf(uint16_t number) const;

    bool isStarted_ = false;
    std::string libraryVersion_;
    std::vector<const CallSignature*> calls_; ///< nullptr: not in this library
};

/// What the arrays are called: the function that says where one lies, the function that gives its
/// value for a vertex, without digit and type; nullptr: no such kind.
struct ArrayNames {
    const char* pointer;
    const char* immediate;
    bool hasSize;
    unsigned unit = 0; ///< the texture unit that it belongs to
};
const ArrayNames* arrayNames(uint8_t kind);
/// The function that gives an element's value by itself, such as rtVertex3fv; nullptr: none.
const CallSignature* immediateCall(const RecordedArray& array);

} // namespace smart::compat
