// SPDX-License-Identifier: MIT
// How calls lie in a stream. A record is its head, then as many bytes as its kind needs:
//
//   Start    magic, byte order, version of the format, size of a pointer, version of the library,
//            the fingerprint of each function by its number
//   Call     the function's number, its arguments, attachments
//   Outcome  of a thread's latest call, once it has returned: function, error, result, names that
//            were made, hash of what was read; only where there is something to be told
//   Picture  after the call that has waited for a frame: where it lies, size, format, its hash
//
// All in the byte order of the machine; a number lies at any address. An argument is its value or,
// of a pointer, a tag and what belongs to it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace smart::compat {

inline constexpr char kStreamMagic[8] = {'O', 'p', 'e', 'n', 'R', 'T', 'c', 's'};
inline constexpr uint32_t kByteOrder = 0x01020304u;
inline constexpr uint16_t kStreamVersion = 1;

enum class RecordKind : uint8_t { Start = 1, Call, Outcome, Picture };

struct RecordHead {
    uint32_t bytes;    ///< of the record, this included
    uint32_t checksum; ///< of all that follows here
    RecordKind kind;
    uint8_t depth;    ///< 1 and more: by a callback of the application, during the call of less
    uint16_t thread;  ///< from 0
    uint32_t context; ///< current there before the call; 0: none
};
static_assert(sizeof(RecordHead) == 16);

enum class PointerTag : uint8_t {
    Null,
    Unread, ///< not NULL, and nothing was looked at
    Number, ///< an offset into a buffer, a key of a frame buffer, an object of rtu.h
    Bytes,  ///< a 64-bit size, and what lay there
    Output, ///< room for results
    Pieces  ///< a 32-bit number of pointers, each as an argument
};

/// What a call needs besides its arguments.
enum class AttachmentKind : uint8_t { None, VertexArray, MappedBytes };

uint32_t checksumOf(std::span<const std::byte> bytes);

/// FNV-1a of 64 bits, of several pieces as of one.
class Hash {
public:
    void add(std::span<const std::byte> bytes) {
        for (const std::byte b : bytes) value_ = (value_ ^ uint64_t(b)) * 0x100000001b3u;
    }
    uint64_t value() const { return value_; }

private:
    uint64_t value_ = 0xcbf29ce484222325u;
};
/// Of a picture's rows without what lies between them.
uint64_t hashOfRows(const std::byte* first, std::size_t rowBytes, std::size_t stride,
                    uint64_t rows);

/// Makes one record after the other in the same memory.
class RecordWriter {
public:
    void begin(RecordKind kind, uint8_t depth, uint16_t thread, uint32_t context);
    template <class T>
    void put(T value) {
        static_assert(std::is_trivially_copyable_v<T>);
        const std::size_t at = bytes_.size();
        bytes_.resize(at + sizeof value);
        std::memcpy(bytes_.data() + at, &value, sizeof value);
    }
    void putBytes(const void* data, std::size_t size);
    void putText(std::string_view text);
    /// Room for so many bytes, to be filled.
    std::byte* grow(std::size_t size);
    void shrink(std::size_t by) { bytes_.resize(bytes_.size() - by); }
    /// The whole record. Throws std::length_error where it is larger than a record may be.
    std::span<const std::byte> end();

private:
    std::vector<std::byte> bytes_;
};

/// Takes a record apart. Throws StreamError where it ends too early.
class RecordReader {
public:
    explicit RecordReader(std::span<const std::byte> bytes) : rest_(bytes) {}
    template <class T>
    T take() {
        T value;
        std::memcpy(&value, takeBytes(sizeof value).data(), sizeof value);
        return value;
    }
    std::span<const std::byte> takeBytes(uint64_t size);
    std::string_view takeText();
    bool isAtEnd() const { return rest_.empty(); }

private:
    std::span<const std::byte> rest_;
};

/// Bytes of the whole records that a stream begins with, by their heads; what a process that was
/// killed leaves behind is not one.
std::size_t bytesOfWholeRecords(std::span<const std::byte> stream);

/// Takes the first record off a stream, after a check of its head and checksum; `head` is what it
/// says. Returns what follows the head. Throws StreamError where the record is damaged.
std::span<const std::byte> takeRecord(std::span<const std::byte>& stream, RecordHead& head);

} // namespace smart::compat
