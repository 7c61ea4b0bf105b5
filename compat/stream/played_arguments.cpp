// SPDX-License-Identifier: MIT
#include "compat/stream/played_arguments.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "openrt/rt.h"

namespace smart::compat {

namespace {

/// Of which there is never one: ids count from 1.
constexpr uint64_t kNoFrame = 0xFFFFFFFEu;
constexpr uint64_t kNoContext = UINT64_MAX - 1;

bool isOfContext(Meaning meaning) {
    return meaning >= Meaning::Object && meaning <= Meaning::Scene;
}

bool isBound(RTenum binding) {
    RTint name = 0;
    rtGetIntegerv(binding, &name);
    return name != 0;
}

class Maker {
public:
    Maker(const CallRecord& record, uint32_t context, const PlayedNames& names, CallArena& arena,
          PlayedArguments& to)
        : record_(record), call_(*record.call), parameters_(parametersOf(call_)),
          context_(context), names_(names), arena_(arena), to_(to) {}

    void make() {
        // Memory may be counted by a number that stands behind it.
        for (std::size_t i = 0; i < parameters_.size(); ++i)
            if (parameters_[i].kind != ValueKind::Pointer) makeNumber(i);
        for (std::size_t i = 0; i < parameters_.size(); ++i)
            if (parameters_[i].kind == ValueKind::Pointer) makePointer(i);
    }

private:
    template <class T>
    void set(std::size_t i, T* pointer) {
        to_.values[i] = CallValue(static_cast<const void*>(pointer));
    }

    void makeNumber(std::size_t i) {
        const CallValue recorded = record_.arguments[i].value;
        const Meaning meaning = parameters_[i].meaning;
        if (meaning < Meaning::Object)
            to_.values[i] = recorded;
        else if (meaning == Meaning::Context)
            to_.values[i] = CallValue(names_.find(meaning, 0, recorded.as<uint64_t>()));
        else
            to_.values[i] = CallValue(
                uint32_t(names_.find(meaning, context_, recorded.as<uint32_t>())));
    }

    void makePointer(std::size_t i) {
        const CallParameter& parameter = parameters_[i];
        const RecordedArgument& argument = record_.arguments[i];
        set<void>(i, nullptr);
        if (argument.tag == PointerTag::Null) return;
        switch (parameter.memory) {
        case Memory::None: // an object of rtu.h; of others the library would read anything
            to_.values[i] =
                CallValue(names_.find(parameter.meaning, 0, argument.value.as<uint64_t>()));
            return;
        case Memory::FrameBuffer:
        case Memory::AuxBuffer:
        case Memory::ShaderDescriptor:
        case Memory::Callback: return;
        case Memory::Unread: return set(i, arena_.allocate(0));
        case Memory::String: return set(i, arena_.copy(argument.bytes));
        case Memory::Arguments: return makeProgramArguments(argument);
        case Memory::Rays: return makeRays(i, argument);
        case Memory::Hits: return makeHits(i);
        case Memory::Array:
            if (argument.tag == PointerTag::Number && isBound(RT_ARRAY_BUFFER_BINDING))
                to_.values[i] = argument.value;
            return;
        case Memory::Indices:
            if (argument.tag == PointerTag::Number) {
                if (isBound(RT_ELEMENT_ARRAY_BUFFER_BINDING)) to_.values[i] = argument.value;
                return;
            }
            break;
        case Memory::ManyIndices: return makeManyIndices(i, argument);
        default: break;
        }
        makeMemory(i, argument);
    }

    void makeMemory(std::size_t i, const RecordedArgument& argument) {
        const CallParameter& parameter = parameters_[i];
        const bool isImage = parameter.memory == Memory::Image ||
                             parameter.memory == Memory::Bitmap ||
                             parameter.memory == Memory::PackedImage ||
                             parameter.memory == Memory::ScaledImage;
        const uint64_t bytes = memoryBytes(call_, parameter, to_.values,
                                           isImage ? imageStores() : ImageStores());
        if (parameter.isOutput) {
            if (bytes == kTooMuch) to_.lacksMemory = true;
            return set(i, arena_.allocate(bytes == kTooMuch ? 0 : bytes));
        }
        if (argument.tag == PointerTag::Bytes) {
            if (argument.bytes.size() < bytes)
                throw StreamError(std::string(call_.name) + " reads more than was recorded");
            std::byte* const copy = arena_.copy(argument.bytes);
            if (parameter.meaning >= Meaning::Object) translate(copy, bytes, parameter.meaning);
            return set(i, copy);
        }
        const bool isIdle = !rtGetCurrentContext() && call_.kind != CallKind::Query;
        if (bytes > CallArena::kLeast && !isIdle) to_.lacksMemory = true;
        set(i, arena_.allocate(0));
    }

    void translate(std::byte* ids, uint64_t bytes, Meaning meaning) const {
        for (uint64_t at = 0; at + sizeof(uint32_t) <= bytes; at += sizeof(uint32_t)) {
            uint32_t id;
            std::memcpy(&id, ids + at, sizeof id);
            id = uint32_t(names_.find(meaning, context_, id));
            std::memcpy(ids + at, &id, sizeof id);
        }
    }

    void makeProgramArguments(const RecordedArgument& argument) {
        const std::size_t n = argument.pieces.size();
        auto* const count = reinterpret_cast<int*>(arena_.allocate(sizeof(int)));
        auto* const values = reinterpret_cast<char**>(arena_.allocate((n + 1) * sizeof(char*)));
        *count = int(n);
        for (std::size_t k = 0; k < n; ++k)
            if (argument.pieces[k].tag == PointerTag::Bytes)
                values[k] = reinterpret_cast<char*>(arena_.copy(argument.pieces[k].bytes));
        set(0, count);
        set(1, values);
    }

    int64_t countOf(const char* name) const {
        return std::max<int64_t>(argumentNamed(call_, name, to_.values).value_or(0), 0);
    }

    void makeRays(std::size_t i, const RecordedArgument& argument) {
        auto* const rays = reinterpret_cast<RTraystream*>(arena_.allocate(sizeof(RTraystream)));
        set(i, rays);
        if (argument.pieces.size() != 9) return; // all NULL, which is refused
        if (argument.pieces[8].bytes.size() >= sizeof rays->flags)
            std::memcpy(&rays->flags, argument.pieces[8].bytes.data(), sizeof rays->flags);
        const auto count = uint64_t(countOf("count"));
        const float** const places[] = {&rays->ox, &rays->oy, &rays->oz,    &rays->dx,
                                        &rays->dy, &rays->dz, &rays->tnear, &rays->tfar};
        for (std::size_t k = 0; k < std::size(places); ++k) {
            const bool isCommon = k < 3 && (rays->flags & RT_COMMON_ORIGIN);
            const RecordedArgument& piece = argument.pieces[k];
            if (piece.tag != PointerTag::Bytes) continue;
            if (piece.bytes.size() < (isCommon ? 1 : count) * sizeof(float))
                throw StreamError(std::string(call_.name) + " reads more than was recorded");
            *places[k] = reinterpret_cast<const float*>(arena_.copy(piece.bytes));
        }
    }

    void makeHits(std::size_t i) {
        auto* const hits = reinterpret_cast<RThitstream*>(arena_.allocate(sizeof(RThitstream)));
        const uint64_t bytes = uint64_t(countOf("count")) * sizeof(float);
        for (float** const p : {&hits->t, &hits->u, &hits->v, &hits->nx, &hits->ny, &hits->nz})
            *p = reinterpret_cast<float*>(arena_.allocate(bytes));
        for (RTuint** const p : {&hits->primitive, &hits->object, &hits->instance})
            *p = reinterpret_cast<RTuint*>(arena_.allocate(bytes));
        set(i, hits);
    }

    void makeManyIndices(std::size_t i, const RecordedArgument& argument) {
        const auto drawings = std::size_t(countOf("drawcount"));
        const std::size_t size = bytesOfIndex(to_.values[2].as<RTenum>());
        const auto* const counts = to_.values[1].as<const RTsizei*>();
        const bool inBuffer = isBound(RT_ELEMENT_ARRAY_BUFFER_BINDING);
        if (argument.pieces.size() < drawings && argument.tag == PointerTag::Pieces)
            throw StreamError(std::string(call_.name) + " reads more than was recorded");
        auto* const pointers = reinterpret_cast<const void**>(
            arena_.allocate(argument.pieces.size() * sizeof(void*)));
        for (std::size_t k = 0; k < argument.pieces.size(); ++k) {
            const RecordedArgument& piece = argument.pieces[k];
            if (piece.tag == PointerTag::Number && inBuffer)
                pointers[k] = reinterpret_cast<const void*>(uintptr_t(piece.value.as<uint64_t>()));
            if (piece.tag != PointerTag::Bytes) continue;
            if (k < drawings && counts && counts[k] > 0 &&
                piece.bytes.size() < std::size_t(counts[k]) * size)
                throw StreamError(std::string(call_.name) + " reads more than was recorded");
            pointers[k] = arena_.copy(piece.bytes);
        }
        set(i, argument.tag == PointerTag::Pieces ? pointers : nullptr);
    }

    const CallRecord& record_;
    const CallSignature& call_;
    std::span<const CallParameter> parameters_;
    uint32_t context_;
    const PlayedNames& names_;
    CallArena& arena_;
    PlayedArguments& to_;
};

} // namespace

PlayedNames::Key PlayedNames::keyOf(Meaning meaning, uint32_t context, uint64_t name) {
    return {isOfContext(meaning) ? context : 0, name};
}

void PlayedNames::add(Meaning meaning, uint32_t context, uint64_t recorded, uint64_t now) {
    if (recorded != 0) names_[meaning][keyOf(meaning, context, recorded)] = now;
}

void PlayedNames::remove(Meaning meaning, uint64_t recorded) {
    names_[meaning].erase({0, recorded});
}

uint64_t PlayedNames::find(Meaning meaning, uint32_t context, uint64_t recorded) const {
    const auto kind = names_.find(meaning);
    if (kind != names_.end()) {
        const auto found = kind->second.find(keyOf(meaning, context, recorded));
        if (found != kind->second.end()) return found->second;
    }
    if (isOfContext(meaning) || recorded == 0) return recorded;
    if (meaning == Meaning::Context) return kNoContext;
    return meaning == Meaning::Frame || meaning == Meaning::QueryScene
               ? (recorded == RT_INVALID ? RT_INVALID : kNoFrame)
               : 0;
}

void PlayedNames::forgetProcess() {
    for (const Meaning meaning : {Meaning::Frame, Meaning::QueryScene, Meaning::Context})
        names_.erase(meaning);
}

ImageStores imageStores() {
    // Where the state does not tell, rtuScaleImage takes that of the start.
    const auto value = [](RTenum name, RTint start = 0) {
        RTint number = start;
        rtGetIntegerv(name, &number);
        return uint32_t(std::max(number, 0));
    };
    ImageStores stores;
    stores.unpack = {value(RT_UNPACK_ALIGNMENT, 4), value(RT_UNPACK_ROW_LENGTH),
                     value(RT_UNPACK_SKIP_PIXELS), value(RT_UNPACK_SKIP_ROWS)};
    stores.pack = {value(RT_PACK_ALIGNMENT, 4), value(RT_PACK_ROW_LENGTH),
                   value(RT_PACK_SKIP_PIXELS), value(RT_PACK_SKIP_ROWS)};
    return stores;
}

void makeArguments(const CallRecord& record, uint32_t context, const PlayedNames& names,
                   CallArena& arena, PlayedArguments& arguments) {
    Maker(record, context, names, arena, arguments).make();
}

} // namespace smart::compat
