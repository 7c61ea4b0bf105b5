// SPDX-License-Identifier: MIT
#include "compat/stream/record_format.h"

#include <limits>
#include <stdexcept>

#include "compat/stream/call_player.h"

namespace smart::compat {

namespace {

constexpr std::size_t kChecked = offsetof(RecordHead, kind); ///< where the checksum begins

} // namespace

uint32_t checksumOf(std::span<const std::byte> bytes) {
    uint64_t hash = 0x9E3779B97F4A7C15u ^ bytes.size();
    const auto mix = [&](uint64_t word) {
        hash = (hash ^ word) * 0xff51afd7ed558ccdu; // odd: no word can change without a trace
        hash ^= hash >> 32;
    };
    std::size_t at = 0;
    for (uint64_t word = 0; at + sizeof word <= bytes.size(); at += sizeof word) {
        std::memcpy(&word, bytes.data() + at, sizeof word);
        mix(word);
    }
    uint64_t last = 0;
    if (at < bytes.size()) std::memcpy(&last, bytes.data() + at, bytes.size() - at);
    mix(last);
    return uint32_t(hash);
}

uint64_t hashOfRows(const std::byte* first, std::size_t rowBytes, std::size_t stride,
                    uint64_t rows) {
    Hash hash;
    for (uint64_t y = 0; y < rows; ++y) hash.add({first + y * stride, rowBytes});
    return hash.value();
}

void RecordWriter::begin(RecordKind kind, uint8_t depth, uint16_t thread, uint32_t context) {
    bytes_.clear();
    put(RecordHead{0, 0, kind, depth, thread, context});
}

void RecordWriter::putBytes(const void* data, std::size_t size) {
    if (size > 0) std::memcpy(grow(size), data, size);
}

void RecordWriter::putText(std::string_view text) {
    put(uint64_t(text.size()));
    putBytes(text.data(), text.size());
}

std::byte* RecordWriter::grow(std::size_t size) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + size);
    return bytes_.data() + at;
}

std::span<const std::byte> RecordWriter::end() {
    if (bytes_.size() > std::numeric_limits<uint32_t>::max())
        throw std::length_error("a call with more than 4 GiB of memory");
    const auto size = uint32_t(bytes_.size());
    const uint32_t checksum = checksumOf(std::span(bytes_).subspan(kChecked));
    std::memcpy(bytes_.data() + offsetof(RecordHead, bytes), &size, sizeof size);
    std::memcpy(bytes_.data() + offsetof(RecordHead, checksum), &checksum, sizeof checksum);
    return bytes_;
}

std::span<const std::byte> RecordReader::takeBytes(uint64_t size) {
    if (size > rest_.size()) throw StreamError("a record ends before what it holds does");
    const std::span<const std::byte> bytes = rest_.first(std::size_t(size));
    rest_ = rest_.subspan(std::size_t(size));
    return bytes;
}

std::string_view RecordReader::takeText() {
    const std::span<const std::byte> bytes = takeBytes(take<uint64_t>());
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::size_t bytesOfWholeRecords(std::span<const std::byte> stream) {
    std::size_t whole = 0, last = 0;
    for (uint32_t bytes = 0; stream.size() - whole >= sizeof(RecordHead); whole += bytes) {
        std::memcpy(&bytes, stream.data() + whole, sizeof bytes);
        if (bytes < sizeof(RecordHead) || bytes > stream.size() - whole) break;
        last = whole;
    }
    if (whole == stream.size() || whole == 0) return whole;
    // The one under way at the end may have its head alone.
    RecordHead head;
    std::memcpy(&head, stream.data() + last, sizeof head);
    const std::span<const std::byte> checked =
        stream.subspan(last + kChecked, head.bytes - kChecked);
    return checksumOf(checked) == head.checksum ? whole : last;
}

std::span<const std::byte> takeRecord(std::span<const std::byte>& stream, RecordHead& head) {
    if (stream.size() < sizeof head) throw StreamError("the stream ends within a record's head");
    std::memcpy(&head, stream.data(), sizeof head);
    if (head.bytes < sizeof head) throw StreamError("a record is shorter than its head");
    if (head.bytes > stream.size()) throw StreamError("the stream ends within a record");
    const std::span<const std::byte> record = stream.first(head.bytes);
    if (checksumOf(record.subspan(kChecked)) != head.checksum)
        throw StreamError("a record is damaged: its checksum is another one");
    stream = stream.subspan(head.bytes);
    return record.subspan(sizeof head);
}

} // namespace smart::compat
