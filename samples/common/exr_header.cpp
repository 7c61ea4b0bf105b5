// SPDX-License-Identifier: MIT
#include "samples/common/exr_header.h"

#include <algorithm>
#include <set>
#include <string>

namespace samples {
namespace {

constexpr uint32_t kMagic = 0x01312f76, kVersion = 2, kTiled = 0x200, kLongNames = 0x400;
constexpr uint64_t kMaxBlockBytes = uint64_t(256) << 20; ///< that OpenEXR unpacks at once
constexpr uint64_t kMaxBlockRows = 256;                  ///< of lines, by any compression

class Bytes {
public:
    explicit Bytes(std::span<const uint8_t> bytes) : left_(bytes) {}

    std::span<const uint8_t> take(uint64_t count) {
        if (count > left_.size()) throw LoadError("its header reaches beyond its end");
        const auto taken = left_.first(std::size_t(count));
        left_ = left_.subspan(taken.size());
        return taken;
    }
    uint8_t byte() { return take(1)[0]; }
    uint32_t word() {
        const auto b = take(4);
        return b[0] | uint32_t(b[1]) << 8 | uint32_t(b[2]) << 16 | uint32_t(b[3]) << 24;
    }
    int64_t integer() { return int32_t(word()); }
    /// A text up to a zero; empty at the end of a list.
    std::string text() {
        const auto end = std::find(left_.begin(), left_.end(), uint8_t(0));
        const auto taken = take(uint64_t(end - left_.begin()) + 1);
        return {taken.begin(), taken.end() - 1};
    }

private:
    std::span<const uint8_t> left_;
};

class HeaderCheck {
public:
    HeaderCheck(uint64_t fileBytes, PixelBudget& budget) : fileBytes_(fileBytes), budget_(budget) {}

    void take(const std::string& name, Bytes value) {
        if (!names_.insert(name).second) throw LoadError("its header repeats itself");
        if (name == "channels") takeChannels(value);
        if (name == "dataWindow") takeWindow(value);
        if (name == "tiles") tileWidth_ = value.word(), tileHeight_ = value.word();
        if (name == "envmap" && value.byte() != 0) {
            throw LoadError("it is a cube map, not a picture by latitude and longitude");
        }
    }

    void finish(bool tiled) const {
        for (const char* name : {"channels", "dataWindow"}) {
            if (!names_.contains(name)) throw LoadError(std::string("its header has no ") + name);
        }
        if (!tiled) return checkBlock(width_, kMaxBlockRows);
        if (tileWidth_ == 0 || tileHeight_ == 0) throw LoadError("its header has no tiles");
        checkBlock(tileWidth_, tileHeight_);
        const uint64_t tiles = ((width_ - 1) / tileWidth_ + 1) * ((height_ - 1) / tileHeight_ + 1);
        if (tiles > fileBytes_ / sizeof(uint64_t)) { // each has a place in a table
            throw LoadError("its header announces more tiles than the file holds");
        }
    }

private:
    void takeChannels(Bytes& value) {
        while (!value.text().empty()) {
            const uint32_t kind = value.word();
            value.take(12); // its other properties
            pixelBytes_ += kind == 1 ? 2 : 4;
        }
    }
    void takeWindow(Bytes& value) {
        const int64_t left = value.integer(), top = value.integer();
        const int64_t right = value.integer(), bottom = value.integer();
        width_ = uint64_t(std::max<int64_t>(right - left + 1, 0));
        height_ = uint64_t(std::max<int64_t>(bottom - top + 1, 0));
        takePixels(budget_, width_, height_);
    }
    void checkBlock(uint64_t width, uint64_t height) const {
        if (width > kMaxBlockBytes || height > kMaxBlockBytes / width ||
            pixelBytes_ > kMaxBlockBytes / (width * height)) {
            throw LoadError("its channels, or tiles, are too large");
        }
    }

    uint64_t fileBytes_;
    PixelBudget& budget_;
    std::set<std::string> names_;
    uint64_t width_ = 0, height_ = 0, tileWidth_ = 0, tileHeight_ = 0, pixelBytes_ = 0;
};

} // namespace

void checkExrHeader(std::span<const uint8_t> bytes, PixelBudget& budget) {
    Bytes left(bytes);
    if (left.word() != kMagic) throw LoadError("it does not begin as an OpenEXR file does");
    const uint32_t version = left.word();
    if ((version & ~(kTiled | kLongNames)) != kVersion) {
        throw LoadError("it has several parts, deep pixels, or a later version than 2");
    }
    HeaderCheck check(bytes.size(), budget);
    for (std::string name = left.text(); !name.empty(); name = left.text()) {
        left.text(); // its type
        const uint32_t size = left.word();
        check.take(name, Bytes(left.take(size)));
    }
    check.finish(version & kTiled);
}

} // namespace samples
