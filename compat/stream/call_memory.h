// SPDX-License-Identifier: MIT
// How much memory a call's pointers lead to: the same for who records a call and who plays it.
#pragma once

#include <cstdint>
#include <optional>

#include "compat/stream/call_table.h"
#include "openrt/types.h"

namespace smart::compat {

/// How images lie in memory, as far as their size depends on it.
struct ImageStore {
    uint32_t alignment = 4, rowLength = 0, skipPixels = 0, skipRows = 0;
};
struct ImageStores {
    ImageStore unpack, pack;
};

inline constexpr uint64_t kTooMuch = UINT64_MAX; ///< bytes that no memory has

/// Bytes that the call reads or writes there. Counts below 0, unknown formats and tokens: none.
/// For the kinds of memory whose size follows from the call and these states.
uint64_t memoryBytes(const CallSignature& call, const CallParameter& parameter,
                     const CallValue* arguments, const ImageStores& stores);

/// Where the rows of a rectangle of pixels lie that rtReadPixels writes.
struct ImageRows {
    uint64_t offset = 0, rowBytes = 0, stride = 0, rows = 0;
};
/// None for bitmaps, and for formats and types that there are not.
ImageRows rowsOfReadPixels(const CallSignature& call, const CallValue* arguments,
                           const ImageStores& stores);

/// The argument of the parameter with this name as a whole number.
std::optional<int64_t> argumentNamed(const CallSignature& call, const char* name,
                                     const CallValue* arguments);
/// An argument of a whole number's kind.
int64_t integerOf(ValueKind kind, CallValue value);

/// Bytes of a component of a vertex array, of an index, of a name in rtCallLists; 0: no such type.
std::size_t bytesOfComponent(RTenum type);
std::size_t bytesOfIndex(RTenum type);
std::size_t bytesOfListName(RTenum type);
/// Of a pixel; 0: no such format or type. Of the frame buffer's formats too.
std::size_t bytesOfPixel(RTenum format, RTenum type);
std::size_t bytesOfFrameBufferPixel(RTenum format);
std::size_t bytesOfAuxBufferPixel(RTenum what);

} // namespace smart::compat
