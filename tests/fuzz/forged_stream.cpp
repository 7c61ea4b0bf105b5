// SPDX-License-Identifier: MIT
#include "tests/fuzz/forged_stream.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "compat/stream/call_memory.h"

namespace openrt::test {

using namespace smart::compat;

namespace {

constexpr uint64_t kFrameKey = 1;

CallValue asRecorded(ValueKind kind, const Value& value) {
    switch (kind) {
        case ValueKind::Float:
            return CallValue(value.to<float>());
        case ValueKind::Double:
            return CallValue(value.to<double>());
        default:
            return CallValue(value.to<int64_t>());
    }
}

bool isText(Memory memory) {
    return memory == Memory::String || memory == Memory::ShaderDescriptor;
}

} // namespace

ForgedStream::ForgedStream(Input& input) : input_(input) {
    start();
    for (int i = 0; i < kMaxCalls && !input_.atEnd(); ++i) next();
}

void ForgedStream::start() {
    writer_.begin(RecordKind::Start, 0, 0, 0);
    writer_.putBytes(kStreamMagic, sizeof kStreamMagic);
    writer_.put(kByteOrder);
    writer_.put(kStreamVersion);
    writer_.put(uint8_t(sizeof(void*)));
    writer_.putText("forged");
    writer_.put(uint16_t(callTable().size()));
    for (const CallSignature& call : callTable()) writer_.put(call.fingerprint);
    end(0);
}

void ForgedStream::begin(RecordKind kind, uint8_t where) {
    const bool isUsual = where < 224;
    writer_.begin(kind, uint8_t(isUsual ? 0 : where & 3), uint16_t(isUsual ? 0 : where >> 2 & 3),
                  isUsual ? 1 : where >> 4 & 1);
}

/// The record as it is, or, with much damage, with some bytes changed.
void ForgedStream::end(uint8_t damage) {
    std::span<const std::byte> record = writer_.end();
    const std::size_t at = bytes_.size();
    bytes_.insert(bytes_.end(), record.begin(), record.end());
    if (damage < 248) return;
    const std::span<std::byte> forged = std::span(bytes_).subspan(at + sizeof(RecordHead));
    for (int n = 1 + input_.byte() % 3; n > 0 && !forged.empty(); --n)
        forged[input_.word() % forged.size()] = std::byte(input_.byte());
    const uint32_t checksum =
        checksumOf(std::span(bytes_).subspan(at + offsetof(RecordHead, kind)));
    std::memcpy(bytes_.data() + at + offsetof(RecordHead, checksum), &checksum, sizeof checksum);
}

void ForgedStream::next() {
    const uint8_t what = input_.byte();
    if (what < 208 || !last_) return call();
    if (what < 232) return outcome(*last_, false);
    picture();
}

void ForgedStream::call() {
    const ApiFunction& function = functionOf(input_.word());
    const CallSignature* const call = findCall(function.name);
    if (!call || parametersOf(*call).size() != function.parameters.size()) std::abort();
    last_ = call;
    begin(RecordKind::Call, input_.byte());
    writer_.put(call->number);
    // What counts memory may stand behind it: numbers are chosen first.
    std::vector<uint8_t> choices;
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        choices.push_back(input_.byte());
        if (parametersOf(*call)[i].kind != ValueKind::Pointer)
            values_[i] = asRecorded(parametersOf(*call)[i].kind,
                                    argumentOf(function.parameters[i], choices[i], input_));
    }
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const ValueKind kind = parametersOf(*call)[i].kind;
        if (kind == ValueKind::Pointer)
            putPointer(*call, i, function.parameters[i], choices[i]);
        else
            writer_.putBytes(&values_[i], bytesOf(kind));
    }
    putAttachments();
    end(input_.byte());
    if (call->resultMeaning != Meaning::Plain) outcome(*call, true);
}

void ForgedStream::putPointer(const CallSignature& call, std::size_t i,
                              const ApiParameter& parameter, uint8_t choice) {
    if (choice >= kLegal) return putAnyPointer();
    const CallParameter& wanted = parametersOf(call)[i];
    const auto* const text = parameter.kind == Kind::Text ? parameter.legal.as<const char*>()
                                                          : nullptr;
    if (isText(wanted.memory)) {
        writer_.put(text ? PointerTag::Bytes : PointerTag::Null);
        if (text) writer_.putText(text);
        return;
    }
    switch (wanted.memory) {
        case Memory::None:
        case Memory::FrameBuffer:
        case Memory::AuxBuffer:
            writer_.put(PointerTag::Number);
            return writer_.put(kFrameKey);
        case Memory::Callback:
        case Memory::Unread:
            return writer_.put(PointerTag::Unread);
        case Memory::Arguments:
        case Memory::Array:
            return writer_.put(PointerTag::Null);
        case Memory::Rays: {
            const uint64_t count = uint64_t(
                std::clamp<int64_t>(argumentNamed(call, "count", values_).value_or(0), 0, 64));
            writer_.put(PointerTag::Pieces);
            writer_.put(uint32_t(9));
            for (int k = 0; k < 8; ++k) putBytes(count * sizeof(float), uint8_t(choice + k));
            return putBytes(sizeof(RTbitfield), 0);
        }
        case Memory::ManyIndices:
            writer_.put(PointerTag::Pieces);
            writer_.put(uint32_t(4));
            for (int k = 0; k < 4; ++k) putBytes(16, 2);
            return;
        default:
            break;
    }
    if (wanted.isOutput) return writer_.put(PointerTag::Output);
    const uint64_t bytes = memoryBytes(call, wanted, values_, {});
    putBytes(bytes == kTooMuch ? 0 : std::min<uint64_t>(bytes, 1 << 16), choice);
}

void ForgedStream::putAnyPointer(int nesting) {
    const auto tag = PointerTag(input_.byte() % 7); // the last there is not
    writer_.put(tag);
    switch (tag) {
        case PointerTag::Number:
            writer_.put(uint64_t(input_.byte()));
            break;
        case PointerTag::Bytes: {
            const uint16_t bytes = input_.word();
            writer_.shrink(sizeof tag);
            putBytes(bytes & 0x7FF, uint8_t(bytes >> 11));
            break;
        }
        case PointerTag::Pieces: {
            const auto count = uint32_t(input_.byte() % 10);
            writer_.put(count);
            for (uint32_t i = 0; i < count && nesting < 3; ++i) putAnyPointer(nesting + 1);
            break;
        }
        default:
            break;
    }
}

/// A pointer to memory of small numbers.
void ForgedStream::putBytes(uint64_t count, uint8_t pattern) {
    writer_.put(PointerTag::Bytes);
    writer_.put(count);
    static const float floats[] = {0, 1, -1, 0.5f, 2};
    const uint8_t own = pattern % 4 == 3 ? input_.byte() : 0;
    for (uint64_t at = 0; at < count; at += 4) {
        uint32_t word = pattern % 4 == 2 ? uint32_t(at / 4 % 6) : own * 0x01010101u;
        if (pattern % 4 == 1) std::memcpy(&word, &floats[at / 4 % 5], sizeof word);
        writer_.putBytes(&word, std::min<uint64_t>(sizeof word, count - at));
    }
}

void ForgedStream::putAttachments() {
    for (int n = input_.byte() - 224; n > 0; n -= 8) {
        const uint8_t choice = input_.byte();
        if (choice & 1) {
            const uint64_t bytes = input_.byte();
            writer_.put(AttachmentKind::MappedBytes);
            writer_.put(bytes);
            std::memset(writer_.grow(std::size_t(bytes)), choice, std::size_t(bytes));
            continue;
        }
        static constexpr RTenum types[] = {RT_FLOAT, RT_DOUBLE,         RT_INT,  RT_UNSIGNED_BYTE,
                                           RT_SHORT, RT_UNSIGNED_SHORT, RT_BYTE, RT_TRIANGLES};
        const RTenum type = types[choice >> 1 & 7];
        const auto size = RTint(1 + (choice >> 4 & 3));
        const uint8_t stride = input_.byte();
        const uint64_t first = input_.byte() % 16, elements = input_.byte() % 64;
        writer_.put(AttachmentKind::VertexArray);
        writer_.put(uint8_t(input_.byte() % 9));
        writer_.put(type);
        writer_.put(size);
        writer_.put(uint32_t(stride));
        writer_.put(first);
        writer_.put(elements);
        const uint64_t element = uint64_t(size) * bytesOfComponent(type);
        const uint64_t step = stride ? stride : element;
        const uint64_t bytes = elements ? (elements - 1) * step + element : 0;
        writer_.put(bytes);
        std::memset(writer_.grow(std::size_t(bytes)), choice & 64 ? 0x3F : 0, std::size_t(bytes));
    }
    writer_.put(AttachmentKind::None);
}

void ForgedStream::outcome(const CallSignature& call, bool isHonest) {
    begin(RecordKind::Outcome, isHonest ? 0 : input_.byte());
    writer_.put(call.number);
    writer_.put(RTenum(isHonest ? RT_NO_ERROR : 0x500 + input_.byte() % 8));
    writer_.put(CallValue(isHonest ? ++made_[call.resultMeaning] : uint64_t(input_.byte())));
    writer_.put(uint64_t(isHonest ? 0 : input_.byte()));
    const auto names = uint32_t(isHonest ? 0 : input_.byte() % 4);
    writer_.put(names);
    for (uint32_t i = 0; i < names; ++i) writer_.put(RTuint(input_.byte()));
    end(isHonest ? 0 : input_.byte());
}

void ForgedStream::picture() {
    static constexpr RTenum formats[] = {RT_RGBA_8,  RT_BGRA_8,   RT_RGB_8,
                                         RT_RGB_32F, RT_RGBA_32F, 0};
    begin(RecordKind::Picture, input_.byte());
    writer_.put(uint64_t(input_.byte() % 4));
    writer_.put(uint32_t(input_.byte()));
    writer_.put(uint32_t(input_.byte()));
    writer_.put(formats[input_.byte() % std::size(formats)]);
    writer_.put(uint64_t(input_.word()));
    writer_.put(uint64_t(0));
    end(input_.byte());
}

} // namespace openrt::test
