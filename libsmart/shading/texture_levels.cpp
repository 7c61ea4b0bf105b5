// SPDX-License-Identifier: MIT
#include "libsmart/shading/texture_levels.h"

#include <algorithm>
#include <bit>
#include <exception>
#include <string>

#include "libsmart/base/error.h"

namespace smart {

namespace {

/// Which texels of a side one texel of the next level covers, and how much of each. The weights
/// are whole numbers, the same multiple of the covered shares everywhere; products with floats
/// and their sums are exact in double for sides up to 16384, so equal texels stay what they are.
struct Taps {
    uint32_t first, count;
    double weights[3];
};

Taps tapsOf(uint32_t index, uint32_t side) {
    if (side == 1) return {0, 1, {1, 0, 0}};
    if (side % 2 == 0) return {2 * index, 2, {1, 1, 0}};
    const uint32_t next = side / 2;
    return {2 * index, 3, {double(next - index), double(next), double(index + 1)}};
}

/// Sum of the weights of one texel.
double totalWeight(uint32_t side) {
    return side == 1 ? 1 : side % 2 == 0 ? 2 : side;
}

} // namespace

uint32_t levelCount(uint32_t width, uint32_t height) {
    return uint32_t(std::bit_width(std::max(width, height)));
}

TextureImage reducedImage(const TextureImage& image) {
    const uint32_t width = nextLevelSide(image.width()), height = nextLevelSide(image.height());
    const uint32_t channels = image.channels();
    const std::size_t count = std::size_t(width) * channels;
    const std::size_t rowBytes = count * bytesPerChannel(image.type());
    const double total = totalWeight(image.width()) * totalWeight(image.height());
    std::vector<float> source(std::size_t(image.width()) * channels);
    std::vector<double> sums(count);
    std::vector<std::byte> texels(rowBytes * height);
    for (uint32_t y = 0; y < height; ++y) {
        std::fill(sums.begin(), sums.end(), 0.0);
        const Taps rows = tapsOf(y, image.height());
        for (uint32_t j = 0; j < rows.count; ++j) {
            image.readRow(rows.first + j, source.data());
            for (uint32_t x = 0; x < width; ++x) {
                const Taps columns = tapsOf(x, image.width());
                for (uint32_t i = 0; i < columns.count; ++i) {
                    const double weight = rows.weights[j] * columns.weights[i];
                    const float* texel = &source[std::size_t(columns.first + i) * channels];
                    for (uint32_t k = 0; k < channels; ++k)
                        sums[std::size_t(x) * channels + k] += weight * double(texel[k]);
                }
            }
        }
        for (double& sum : sums) sum /= total;
        encodeTexels(sums.data(), count, channels, image.type(), image.srgb(),
                     texels.data() + y * rowBytes);
    }
    return TextureImage(width, height, channels, image.type(), image.srgb(), std::move(texels));
}

TextureLevels::TextureLevels(std::vector<TextureImagePtr> images, uint32_t count)
    : count_(count), given_(std::move(images)) {
    if (given_.empty() || !given_[0])
        throw Error(ErrorCode::InvalidValue, "a texture needs an image");
    uint32_t width = first().width(), height = first().height();
    if (count_ < 1 || count_ > levelCount(width, height))
        throw Error(ErrorCode::InvalidValue,
                    "a texture can not have " + std::to_string(count_) + " levels");
    given_.resize(count_);
    for (const TextureImagePtr& image : given_) {
        if (image && (image->width() != width || image->height() != height ||
                      image->channels() != first().channels()))
            throw Error(ErrorCode::InvalidValue,
                        "a level's size or channels do not fit those of the first");
        width = nextLevelSide(width);
        height = nextLevelSide(height);
    }
    complete_ = std::find(given_.begin(), given_.end(), nullptr) == given_.end();
}

const TextureImage& TextureLevels::operator[](uint32_t number) const noexcept {
    if (number == 0 || complete_) return *given_[number];
    if (!tried_.load(std::memory_order_acquire)) {
        std::call_once(once_, [this] {
            try {
                make();
            } catch (const std::exception&) { // no memory
                all_.clear();
            }
            tried_.store(true, std::memory_order_release);
        });
    }
    return all_.empty() ? first() : *all_[number];
}

void TextureLevels::make() const {
    std::vector<TextureImagePtr> made{given_[0]}, all = given_;
    const auto missing = std::find(all.rbegin(), all.rend(), nullptr).base(); // behind the last
    const auto needed = std::size_t(missing - all.begin());
    while (made.size() < needed) {
        const std::size_t number = made.size();
        made.push_back(std::make_shared<const TextureImage>(reducedImage(*made.back())));
        if (!all[number]) all[number] = made.back();
    }
    all_ = std::move(all);
}

std::size_t TextureLevels::bytes() const {
    const bool made = tried_.load(std::memory_order_acquire) && !all_.empty();
    std::size_t sum = 0;
    for (const TextureImagePtr& image : made ? all_ : given_)
        if (image) sum += image->bytes();
    return sum;
}

} // namespace smart
