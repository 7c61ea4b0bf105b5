// SPDX-License-Identifier: MIT
#include "compat/stream/call_reader.h"

#include <algorithm>
#include <map>

#include "compat/stream/call_memory.h"
#include "compat/stream/call_player.h"
#include "openrt/enums.h"

namespace smart::compat {

namespace {

constexpr int kMostNesting = 2; ///< pieces of a pointer are no pieces themselves

RecordedArgument readPointer(RecordReader& reader, int nesting = 0) {
    RecordedArgument argument;
    argument.tag = reader.take<PointerTag>();
    switch (argument.tag) {
    case PointerTag::Null:
    case PointerTag::Unread:
    case PointerTag::Output: break;
    case PointerTag::Number: argument.value = CallValue(reader.take<uint64_t>()); break;
    case PointerTag::Bytes: argument.bytes = reader.takeBytes(reader.take<uint64_t>()); break;
    case PointerTag::Pieces: {
        if (nesting + 1 == kMostNesting) throw StreamError("pointers in pointers in pointers");
        const auto count = reader.take<uint32_t>();
        for (uint32_t i = 0; i < count; ++i)
            argument.pieces.push_back(readPointer(reader, nesting + 1));
        break;
    }
    default: throw StreamError("a pointer of a kind that there is not");
    }
    return argument;
}

CallValue readScalar(RecordReader& reader, ValueKind kind) {
    uint64_t bits = 0;
    const std::span<const std::byte> bytes = reader.takeBytes(bytesOf(kind));
    std::memcpy(&bits, bytes.data(), bytes.size());
    return CallValue(bits);
}

RecordedArray readArray(RecordReader& reader) {
    RecordedArray array{};
    array.kind = reader.take<uint8_t>();
    array.type = reader.take<RTenum>();
    array.size = reader.take<RTint>();
    array.stride = reader.take<uint32_t>();
    array.first = reader.take<uint64_t>();
    array.elements = reader.take<uint64_t>();
    array.bytes = reader.takeBytes(reader.take<uint64_t>());
    if (!arrayNames(array.kind) || bytesOfComponent(array.type) == 0 || array.size < 1 ||
        array.size > 4)
        throw StreamError("a vertex array of a kind that there is not");
    const std::string immediate = arrayNames(array.kind)->immediate;
    if ((immediate == "rtNormal" || immediate == "rtSecondaryColor") && array.size != 3)
        throw StreamError("a vertex array of a size that there is not");
    constexpr uint64_t kMost = uint64_t(1) << 33; // indices have 32 bits
    const uint64_t last = array.elements - 1;
    if (array.elements == 0 || array.elements > kMost || array.first > kMost ||
        array.bytes.size() < array.elementBytes() ||
        (array.bytes.size() - array.elementBytes()) != last * array.step())
        throw StreamError("a vertex array has another size than its elements");
    return array;
}

} // namespace

uint64_t RecordedArray::elementBytes() const {
    return uint64_t(size) * bytesOfComponent(type);
}

void CallReader::readStart(std::span<const std::byte> record) {
    RecordReader reader(record);
    const std::span<const std::byte> magic = reader.takeBytes(sizeof kStreamMagic);
    if (std::memcmp(magic.data(), kStreamMagic, sizeof kStreamMagic) != 0)
        throw StreamError("no recording of calls");
    if (reader.take<uint32_t>() != kByteOrder)
        throw StreamError("recorded on a machine with another byte order");
    if (reader.take<uint16_t>() != kStreamVersion)
        throw StreamError("recorded in a format of another version");
    if (reader.take<uint8_t>() != sizeof(void*))
        throw StreamError("recorded on a machine with pointers of another size");
    libraryVersion_ = reader.takeText();
    std::map<uint32_t, const CallSignature*> known;
    for (const CallSignature& call : callTable()) known[call.fingerprint] = &call;
    calls_.assign(reader.take<uint16_t>(), nullptr);
    for (const CallSignature*& call : calls_) {
        const auto found = known.find(reader.take<uint32_t>());
        if (found != known.end()) call = found->second;
    }
    isStarted_ = true;
}

const CallSignature& CallReader::callOf(uint16_t number) const {
    if (!isStarted_) throw StreamError("the recording does not begin at its start");
    if (number >= calls_.size() || !calls_[number])
        throw StreamError("function " + std::to_string(number) + " of OpenRT " + libraryVersion_ +
                          " is not the same in this library");
    return *calls_[number];
}

void CallReader::readCall(std::span<const std::byte> record, CallRecord& call) const {
    RecordReader reader(record);
    call.call = &callOf(reader.take<uint16_t>());
    call.arguments.clear();
    call.arrays.clear();
    call.hasMapped = false;
    for (const CallParameter& parameter : parametersOf(*call.call)) {
        if (parameter.kind == ValueKind::Pointer)
            call.arguments.push_back(readPointer(reader));
        else
            call.arguments.emplace_back().value = readScalar(reader, parameter.kind);
    }
    for (;;) {
        const auto kind = reader.take<AttachmentKind>();
        if (kind == AttachmentKind::None) break;
        if (kind == AttachmentKind::VertexArray) {
            call.arrays.push_back(readArray(reader));
        } else if (kind == AttachmentKind::MappedBytes) {
            call.hasMapped = true;
            call.mapped = reader.takeBytes(reader.take<uint64_t>());
        } else {
            throw StreamError("an attachment of a kind that there is not");
        }
    }
    if (!reader.isAtEnd()) throw StreamError("a record is longer than its call");
}

OutcomeRecord CallReader::readOutcome(std::span<const std::byte> record) const {
    RecordReader reader(record);
    OutcomeRecord outcome;
    outcome.call = &callOf(reader.take<uint16_t>());
    outcome.error = reader.take<RTenum>();
    outcome.result = reader.take<CallValue>();
    outcome.hash = reader.take<uint64_t>();
    const auto count = reader.take<uint32_t>();
    const std::span<const std::byte> names = reader.takeBytes(uint64_t(count) * sizeof(RTuint));
    outcome.names.resize(count);
    if (count > 0) std::memcpy(outcome.names.data(), names.data(), names.size());
    return outcome;
}

PictureRecord CallReader::readPicture(std::span<const std::byte> record) {
    RecordReader reader(record);
    PictureRecord picture;
    picture.key = reader.take<uint64_t>();
    picture.width = reader.take<uint32_t>();
    picture.height = reader.take<uint32_t>();
    picture.format = reader.take<RTenum>();
    picture.stride = reader.take<uint64_t>();
    picture.hash = reader.take<uint64_t>();
    return picture;
}

const ArrayNames* arrayNames(uint8_t kind) {
    // In the order of ArrayKind; index arrays are never read.
    static constexpr ArrayNames kNames[] = {
        {"rtEdgeFlagPointer", "rtEdgeFlag", false},
        {"rtTexCoordPointer", "rtTexCoord", true},
        {"rtColorPointer", "rtColor", true},
        {"rtSecondaryColorPointer", "rtSecondaryColor", true},
        {"rtNormalPointer", "rtNormal", false},
        {"rtFogCoordPointer", "rtFogCoord", false},
        {"rtIndexPointer", "rtIndex", false},
        {"rtVertexPointer", "rtVertex", true},
        {"rtTexCoordPointer", "rtMultiTexCoord", true, 1},
        {"rtTexCoordPointer", "rtMultiTexCoord", true, 2},
        {"rtTexCoordPointer", "rtMultiTexCoord", true, 3}};
    return kind < std::size(kNames) ? &kNames[kind] : nullptr;
}

const CallSignature* immediateCall(const RecordedArray& array) {
    const ArrayNames& names = *arrayNames(array.kind);
    std::string name = names.immediate;
    if (name == "rtEdgeFlag") return array.size == 1 ? findCall("rtEdgeFlagv") : nullptr;
    if (name != "rtFogCoord" && name != "rtIndex") name += std::to_string(array.size);
    const char* suffix = nullptr;
    switch (array.type) {
    case RT_BYTE: suffix = "bv"; break;
    case RT_UNSIGNED_BYTE: suffix = "ubv"; break;
    case RT_SHORT: suffix = "sv"; break;
    case RT_UNSIGNED_SHORT: suffix = "usv"; break;
    case RT_INT: suffix = "iv"; break;
    case RT_UNSIGNED_INT: suffix = "uiv"; break;
    case RT_FLOAT: suffix = "fv"; break;
    default: suffix = "dv"; break;
    }
    return findCall((name + suffix).c_str());
}

} // namespace smart::compat
