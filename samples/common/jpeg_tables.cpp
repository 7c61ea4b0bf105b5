// SPDX-License-Identifier: MIT
#include "samples/common/jpeg_tables.h"

#include <numeric>

#include "samples/common/scene_description.h"

namespace samples {
namespace {

constexpr uint8_t kHuffmanTables = 0xC4, kEnd = 0xD9;
constexpr std::size_t kLengths = 16; // of codes, in bits
constexpr unsigned kSymbols = 256;

/// Markers without a segment: restarts, and what stands for a byte 0xFF in compressed data.
bool standsAlone(uint8_t marker) {
    return marker <= 0x01 || (marker >= 0xD0 && marker <= 0xD8);
}

void checkTables(std::span<const uint8_t> segment) {
    while (!segment.empty()) {
        if (segment.size() <= kLengths) throw LoadError("a JPEG picture with a damaged table");
        const auto counts = segment.subspan(1, kLengths);
        const unsigned codes = std::accumulate(counts.begin(), counts.end(), 0u);
        if (codes > kSymbols || segment.size() < 1 + kLengths + codes)
            throw LoadError("a JPEG picture with a damaged table");
        segment = segment.subspan(1 + kLengths + codes);
    }
}

} // namespace

void checkJpegTables(std::span<const uint8_t> bytes) {
    std::size_t at = 2; // behind the start of the image
    while (true) {
        while (at < bytes.size() && bytes[at] != 0xFF) ++at; // compressed data, or padding
        while (at < bytes.size() && bytes[at] == 0xFF) ++at;
        if (at >= bytes.size()) return;
        const uint8_t marker = bytes[at++];
        if (marker == kEnd) return;
        if (standsAlone(marker)) continue;
        if (bytes.size() - at < 2) return;
        const std::size_t length = std::size_t(bytes[at]) << 8 | bytes[at + 1];
        if (length < 2 || length > bytes.size() - at) {
            // A decoder has nothing to go on with behind a segment that is cut off, but may read
            // it.
            if (marker == kHuffmanTables) throw LoadError("a JPEG picture with a damaged table");
            return;
        }
        if (marker == kHuffmanTables) checkTables(bytes.subspan(at + 2, length - 2));
        at += length;
    }
}

} // namespace samples
