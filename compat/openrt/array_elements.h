// SPDX-License-Identifier: MIT
// What vertex arrays hold, made into the calls that immediate mode would make.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "compat/recorder/context.h"
#include "openrt/types.h"

namespace smart::compat {

ComponentType componentTypeOf(RTenum type);
RTenum tokenOf(ComponentType type);
std::size_t sizeOf(ComponentType type);

/// Where memory that a pointer names begins, and how much of it may be read.
struct ReadableMemory {
    const std::byte* data = nullptr;
    uint64_t bytes = UINT64_MAX; ///< of the application's own memory nothing is known
};
/// Throws Error where there is none, or the buffer is mapped.
ReadableMemory readable(const void* pointer, const BufferBinding& buffer);

/// The enabled arrays, resolved for reading. Keeps nothing alive.
class ArrayElements {
public:
    /// Throws Error where an enabled array can not be read.
    explicit ArrayElements(Context& context);

    /// Throws Error unless every enabled array reaches so far.
    void requireElement(uint64_t index) const;
    /// Whether there are vertices at all; what has none draws nothing.
    bool hasVertices() const { return enabled_[std::size_t(ArrayKind::Vertex)]; }
    /// Sets the attributes of an element, then its vertex.
    void make(uint64_t index) const;
    /// The current values that the enabled arrays change, as they were at the start.
    void restoreAttributes() const;

private:
    using Fetch = void (*)(const std::byte* from, int n, double* to);
    struct Source {
        Fetch fetch = nullptr;
        const std::byte* data = nullptr;
        uint64_t bytes = 0;
        std::size_t stride = 0, elementBytes = 0;
        int size = 0;
    };
    void resolve(ArrayKind kind, const VertexArray& array);
    /// The element's components; the others are left alone.
    bool fetch(ArrayKind kind, uint64_t index, double* to) const {
        if (!enabled_[std::size_t(kind)]) return false;
        const Source& source = sources_[std::size_t(kind)];
        source.fetch(source.data + index * source.stride, source.size, to);
        return true;
    }

    Context& context_;
    Attributes before_;
    std::array<bool, kArrayKinds> enabled_{};
    std::array<Source, kArrayKinds> sources_;
};

} // namespace smart::compat
