// SPDX-License-Identifier: MIT
#include "compat/stream/call_capture.h"

#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <map>
#include <span>

#include "compat/stream/array_capture.h"
#include "libsmart/base/immortal.h"
#include "openrt/rt_query.h"
#include "openrt/rts.h"

namespace smart::compat {

namespace {

/// From this size on a wrong call may name memory that there is not.
constexpr std::size_t kDoubtful = 4096;

bool isReadable(std::byte* to, const void* from, std::size_t bytes) {
    const iovec local{to, bytes}, remote{const_cast<void*>(from), bytes};
    const ssize_t copied = process_vm_readv(getpid(), &local, 1, &remote, 1, 0);
    if (copied == ssize_t(bytes)) return true;
    if (copied >= 0 || errno == EFAULT) return false;
    std::memcpy(to, from, bytes); // not allowed in this process
    return true;
}

void putTag(RecordWriter& record, PointerTag tag) {
    record.put(tag);
}

void putMemory(RecordWriter& record, const void* from, uint64_t bytes) {
    constexpr uint64_t kMost = uint64_t(1) << 32; // no record holds more
    if (!from) return putTag(record, PointerTag::Null);
    if (bytes == 0 || bytes >= kMost) return putTag(record, PointerTag::Unread);
    putTag(record, PointerTag::Bytes);
    record.put(bytes);
    std::byte* const to = record.grow(std::size_t(bytes));
    if (bytes < kDoubtful) {
        std::memcpy(to, from, std::size_t(bytes));
    } else if (!isReadable(to, from, std::size_t(bytes))) {
        record.shrink(std::size_t(bytes) + sizeof(uint64_t) + sizeof(PointerTag));
        putTag(record, PointerTag::Unread);
    }
}

void putText(RecordWriter& record, const char* text) {
    putMemory(record, text, text ? std::strlen(text) + 1 : 0);
}

void putPieces(RecordWriter& record, uint32_t count) {
    putTag(record, PointerTag::Pieces);
    record.put(count);
}

/// argv of rtInit; argc is the call's first argument.
void putArguments(RecordWriter& record, const CallValue* arguments) {
    const int* const argc = arguments[0].as<const int*>();
    char* const* const argv = arguments[1].as<char* const*>();
    if (!argc || !argv || *argc < 0) return putTag(record, PointerTag::Null);
    putPieces(record, uint32_t(*argc));
    for (int i = 0; i < *argc; ++i) putText(record, argv[i]);
}

void putRays(RecordWriter& record, const RTraystream* rays, int64_t count) {
    if (!rays || count <= 0) return putTag(record, rays ? PointerTag::Unread : PointerTag::Null);
    const uint64_t origins = rays->flags & RT_COMMON_ORIGIN ? 1 : uint64_t(count);
    putPieces(record, 9);
    for (const float* p : {rays->ox, rays->oy, rays->oz})
        putMemory(record, p, origins * sizeof *p);
    for (const float* p : {rays->dx, rays->dy, rays->dz, rays->tnear, rays->tfar})
        putMemory(record, p, uint64_t(count) * sizeof *p);
    putMemory(record, &rays->flags, sizeof rays->flags);
}

void putManyIndices(RecordWriter& record, const CallSignature& call, const CallValue* arguments,
                    bool inBuffer) {
    const auto* const indices = arguments[3].as<const void* const*>();
    const auto* const counts = arguments[1].as<const RTsizei*>();
    const int64_t drawings = argumentNamed(call, "drawcount", arguments).value_or(0);
    if (!indices) return putTag(record, PointerTag::Null);
    if (!counts || drawings <= 0) return putTag(record, PointerTag::Unread);
    const std::size_t size = bytesOfIndex(arguments[2].as<RTenum>());
    putPieces(record, uint32_t(drawings));
    for (int64_t i = 0; i < drawings; ++i) {
        if (inBuffer) {
            putTag(record, PointerTag::Number);
            record.put(uint64_t(reinterpret_cast<uintptr_t>(indices[i])));
        } else {
            putMemory(record, indices[i], counts[i] > 0 ? uint64_t(counts[i]) * size : 0);
        }
    }
}

void putNumber(RecordWriter& record, const void* pointer) {
    putTag(record, PointerTag::Number);
    record.put(uint64_t(reinterpret_cast<uintptr_t>(pointer)));
}

void putPointer(RecordWriter& record, const CallSignature& call, const CallParameter& parameter,
                const CallValue* arguments, CallValue argument, Context* context) {
    const void* const pointer = argument.as<const void*>();
    const auto presence = [&](PointerTag tag) {
        putTag(record, pointer ? tag : PointerTag::Null);
    };
    const bool inArrayBuffer = context && context->arrays().arrayBuffer.buffer;
    const bool inElementBuffer = context && context->arrays().elementBuffer.buffer;
    switch (parameter.memory) {
    case Memory::None: return putNumber(record, pointer); // an object of rtu.h
    case Memory::String: return putText(record, static_cast<const char*>(pointer));
    case Memory::Arguments: return putArguments(record, arguments);
    case Memory::Rays:
        return putRays(record, static_cast<const RTraystream*>(pointer),
                       argumentNamed(call, "count", arguments).value_or(0));
    case Memory::ManyIndices: return putManyIndices(record, call, arguments, inElementBuffer);
    case Memory::Array:
        return inArrayBuffer ? putNumber(record, pointer) : presence(PointerTag::Unread);
    case Memory::Indices:
        if (inElementBuffer) return putNumber(record, pointer);
        break;
    case Memory::FrameBuffer:
    case Memory::AuxBuffer:
        presence(PointerTag::Number);
        if (pointer) record.put(keyOfFrameBuffer(pointer));
        return;
    case Memory::ShaderDescriptor: {
        const auto* const known = static_cast<const RTshaderclass*>(pointer);
        const bool isNamed = known && known->structSize == sizeof *known && known->name;
        return isNamed ? putText(record, known->name) : presence(PointerTag::Unread);
    }
    case Memory::Callback:
    case Memory::Unread: return presence(PointerTag::Unread);
    default: break;
    }
    if (parameter.isOutput) return presence(PointerTag::Output);
    if (!context && call.kind != CallKind::Query) return presence(PointerTag::Unread);
    putMemory(record, pointer,
              memoryBytes(call, parameter, arguments, imageStoresOf(context)));
}

ImageStore imageStoreOf(const PixelStore& store) {
    return {store.alignment, store.rowLength, store.skipPixels, store.skipRows};
}

/// What the application has written to a buffer until it unmaps it.
bool captureMapped(RecordWriter& record, const CallValue* arguments, Context& context) {
    const auto target = arguments[0].as<RTenum>();
    const VertexArrays& arrays = context.arrays();
    const BufferPtr& buffer = target == RT_ARRAY_BUFFER           ? arrays.arrayBuffer.buffer
                              : target == RT_ELEMENT_ARRAY_BUFFER ? arrays.elementBuffer.buffer
                                                                  : BufferPtr();
    if (!buffer || !buffer->mapped || buffer->access == RT_READ_ONLY) return false;
    record.put(AttachmentKind::MappedBytes);
    record.put(uint64_t(buffer->bytes.size()));
    record.putBytes(buffer->bytes.data(), buffer->bytes.size());
    return true;
}

/// Under the recording's lock.
std::map<const void*, uint64_t>& frameBufferKeys() {
    static Immortal<std::map<const void*, uint64_t>> keys;
    return keys.get();
}

} // namespace

uint64_t keyOfFrameBuffer(const void* memory) {
    return frameBufferKeys().emplace(memory, frameBufferKeys().size() + 1).first->second;
}

bool isFrameBuffer(const void* memory) { return frameBufferKeys().contains(memory); }

ImageStores imageStoresOf(Context* context) {
    if (!context || context->recorder().insidePrimitive()) return {};
    Recorder& recorder = context->recorder();
    return {imageStoreOf(recorder.pixelStore()), imageStoreOf(recorder.packStore())};
}

void captureArguments(RecordWriter& record, const CallSignature& call, const CallValue* arguments,
                      Context* context) {
    const std::span<const CallParameter> parameters = parametersOf(call);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const CallParameter& parameter = parameters[i];
        if (parameter.kind == ValueKind::Pointer) {
            putPointer(record, call, parameter, arguments, arguments[i], context);
        } else {
            const auto bits = arguments[i].as<uint64_t>();
            record.putBytes(&bits, bytesOf(parameter.kind));
        }
    }
    if (context) {
        static const CallSignature* const unmap = findCall("rtUnmapBuffer");
        if (&call == unmap) captureMapped(record, arguments, *context);
        captureArrays(record, call, arguments, *context);
    }
    record.put(AttachmentKind::None);
}

} // namespace smart::compat
