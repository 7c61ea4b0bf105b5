// SPDX-License-Identifier: MIT
#include "samples/common/radiance_picture.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace samples {
namespace {

using Rgbe = std::array<uint8_t, 4>;

class Reader {
public:
    explicit Reader(std::span<const uint8_t> bytes) : left_(bytes) {}

    std::span<const uint8_t> take(std::size_t count) {
        if (count > left_.size()) throw LoadError("it is cut off");
        const auto taken = left_.first(count);
        left_ = left_.subspan(count);
        return taken;
    }
    uint8_t byte() { return take(1)[0]; }
    std::string_view line() {
        const auto end = std::find(left_.begin(), left_.end(), uint8_t('\n'));
        const auto taken = take(std::size_t(end - left_.begin()) + 1);
        return {reinterpret_cast<const char*>(taken.data()), taken.size() - 1};
    }
    /// Whether a row follows that is run-length encoded, each component by itself.
    bool skipRunMark(std::size_t width) {
        const bool marked = left_.size() >= 4 && left_[0] == 2 && left_[1] == 2 &&
                            (std::size_t(left_[2]) << 8 | left_[3]) == width;
        if (marked) take(4);
        return marked;
    }

private:
    std::span<const uint8_t> left_;
};

struct Size {
    uint32_t width, height;
};

/// `-Y height +X width`.
Size sizeFrom(std::string_view line) {
    const auto number = [&](std::string_view axis) {
        uint32_t value = 0;
        if (!line.starts_with(axis)) throw LoadError("its rows do not lie as those of pictures do");
        line.remove_prefix(axis.size());
        const auto end = std::from_chars(line.data(), line.data() + line.size(), value).ptr;
        line.remove_prefix(std::size_t(end - line.data()));
        return value;
    };
    const uint32_t height = number("-Y ");
    return {number(" +X "), height};
}

Size readHeader(Reader& reader) {
    if (!reader.line().starts_with("#?")) throw LoadError("it does not begin as a picture does");
    bool known = false;
    for (std::string_view line = reader.line(); !line.empty(); line = reader.line()) {
        known = known || line == "FORMAT=32-bit_rle_rgbe";
    }
    if (!known) throw LoadError("its format is not 32-bit_rle_rgbe");
    return sizeFrom(reader.line());
}

void readRuns(Reader& reader, std::span<Rgbe> row) {
    constexpr uint8_t kRun = 128;
    for (std::size_t component = 0; component < 4; ++component) {
        for (std::size_t x = 0; x < row.size();) {
            const uint8_t code = reader.byte();
            const bool run = code > kRun;
            const std::size_t count = run ? code - kRun : code;
            if (count == 0 || count > row.size() - x) throw LoadError("one of its runs is broken");
            const auto values = reader.take(run ? 1 : count);
            for (std::size_t i = 0; i < count; ++i) row[x++][component] = values[run ? 0 : i];
        }
    }
}

void readPlain(Reader& reader, std::span<Rgbe> row) {
    for (Rgbe& pixel : row) {
        const auto values = reader.take(pixel.size());
        std::copy(values.begin(), values.end(), pixel.begin());
    }
}

} // namespace

Environment decodeRadiance(std::span<const uint8_t> bytes, PixelBudget& budget) {
    Reader reader(bytes);
    const auto [width, height] = readHeader(reader);
    takePixels(budget, width, height);
    Environment picture{width, height, {}};
    picture.rgb.reserve(std::size_t(width) * height * 3);
    std::vector<Rgbe> row(width);
    for (uint32_t y = 0; y < height; ++y) {
        if (reader.skipRunMark(width)) {
            readRuns(reader, row);
        } else {
            readPlain(reader, row);
        }
        for (const Rgbe& pixel : row) {
            constexpr int kBias = 128 + 8; // mantissas of eight bits
            const float scale = pixel[3] == 0 ? 0.0f : std::ldexp(1.0f, pixel[3] - kBias);
            for (std::size_t c = 0; c < 3; ++c) picture.rgb.push_back(float(pixel[c]) * scale);
        }
    }
    return picture;
}

} // namespace samples
