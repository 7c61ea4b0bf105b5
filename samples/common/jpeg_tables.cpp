// SPDX-License-Identifier: MIT
#include "samples/common/jpeg_tables.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "samples/common/scene_description.h"

namespace samples {
namespace {

constexpr uint8_t kProgressive = 0xC2, kHuffmanTables = 0xC4, kEnd = 0xD9, kScan = 0xDA,
                  kQuantization = 0xDB;
constexpr std::size_t kLengths = 16; // of codes, in bits
constexpr unsigned kSymbols = 256;
using Segment = std::span<const uint8_t>;

[[noreturn]] void refuse() { throw LoadError("a JPEG picture with a damaged table"); }

/// Markers without a segment: restarts, and what stands for a byte 0xFF in compressed data.
bool standsAlone(uint8_t marker) {
    return marker <= 0x01 || (marker >= 0xD0 && marker <= 0xD8);
}

/// The tables that a file has defined so far, and what its scans ask of them.
class Tables {
public:
    void defineHuffman(Segment segment) {
        while (!segment.empty()) {
            if (segment.size() <= kLengths) refuse();
            const auto counts = segment.subspan(1, kLengths);
            const unsigned codes = std::accumulate(counts.begin(), counts.end(), 0u);
            if (codes > kSymbols || segment.size() < 1 + kLengths + codes) refuse();
            huffman_.insert(segment[0]);
            segment = segment.subspan(1 + kLengths + codes);
        }
    }
    void defineQuantization(Segment segment) {
        constexpr std::size_t kValues = 64;
        while (!segment.empty()) {
            const std::size_t size = 1 + (segment[0] >> 4 ? 2 : 1) * kValues;
            if (segment.size() < size) refuse();
            quantization_.insert(segment[0] & 15);
            segment = segment.subspan(size);
        }
    }
    /// A frame's components each name a table of quantization.
    void beginFrame(Segment segment, bool progressive) {
        progressive_ = progressive;
        for (std::size_t at = 8; at < segment.size(); at += 3) asked_.insert(segment[at]);
    }
    void beginScan(Segment segment) const {
        if (segment.empty() || segment.size() < std::size_t(4 + 2 * segment[0])) refuse();
        if (!std::ranges::includes(quantization_, asked_)) refuse();
        const Segment range = segment.subspan(1 + 2u * segment[0]);
        const bool first = range[0] == 0, refined = range[2] >> 4 != 0;
        for (std::size_t i = 0; i < segment[0]; ++i) {
            const uint8_t names = segment[2 + 2 * i];
            const bool asksDc = !progressive_ || (first && !refined);
            const bool asksAc = !progressive_ || !first;
            if ((asksDc && !huffman_.contains(names >> 4)) ||
                (asksAc && !huffman_.contains(uint8_t(kOfAc | (names & 15)))))
                refuse();
        }
    }

private:
    static constexpr uint8_t kOfAc = 0x10; ///< class of a Huffman table, beside its number
    std::set<uint8_t> huffman_, quantization_;
    std::set<uint8_t> asked_; ///< of quantization, by the frame
    bool progressive_ = false;
};

bool beginsFrame(uint8_t marker) { return marker >= 0xC0 && marker <= kProgressive; }

} // namespace

void checkJpegTables(std::span<const uint8_t> bytes) {
    Tables tables;
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
            if (marker == kHuffmanTables || marker == kQuantization || marker == kScan) refuse();
            return;
        }
        const Segment segment = bytes.subspan(at + 2, length - 2);
        if (marker == kHuffmanTables) tables.defineHuffman(segment);
        if (marker == kQuantization) tables.defineQuantization(segment);
        if (beginsFrame(marker)) tables.beginFrame(segment, marker == kProgressive);
        if (marker == kScan) tables.beginScan(segment);
        at += length;
    }
}

} // namespace samples
