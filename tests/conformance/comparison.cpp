// SPDX-License-Identifier: MIT
#include "tests/conformance/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "tests/conformance/flip.h"

namespace conformance {
namespace {

constexpr int kVisible = 2; // in 1/255
constexpr double kDepthLimit = 1e-5, kMeanLimit = 0.5, k999Limit = 2.0;
constexpr double kSilhouetteColorLimit = 0.5, kFlipLimit = 0.02;

// Where an object was drawn: something in the depth buffer, or not the clear colour.
std::vector<bool> objectMask(const Frame& frame, const std::array<std::uint8_t, 3>& clear) {
    std::vector<bool> mask(frame.color.pixels.size());
    for (std::size_t i = 0; i < mask.size(); ++i) {
        bool object = frame.depth.depth[i] < 1.0f;
        for (std::size_t k = 0; k < 3; ++k)
            object = object || std::abs(frame.color.pixels[i][k] - clear[k]) > kVisible;
        mask[i] = object;
    }
    return mask;
}

std::vector<bool> mixedNeighbourhood(const std::vector<bool>& mask, int width, int height) {
    std::vector<bool> mixed(mask.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool own = mask[std::size_t(y * width + x)];
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
                    if (mask[std::size_t(v * width + u)] != own)
                        mixed[std::size_t(y * width + x)] = true;
        }
    return mixed;
}

template <class T>
struct Range {
    T low, high;

    void include(T value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    // NaN, which no comparison finds, is as far away as can be.
    T distance(T value) const {
        if (value != value) return T(1);
        return std::max({T(0), low - value, value - high});
    }
};

void checkSize(const Frame& frame, int width, int height) {
    if (frame.color.width != width || frame.color.height != height || frame.depth.width != width ||
        frame.depth.height != height)
        throw std::runtime_error("pictures of different sizes");
}

struct PixelRanges {
    std::array<Range<int>, 3> color;
    Range<float> depth;
    bool anyObject, anyEmpty;
};

class Comparison {
public:
    Comparison(const Reference& reference, const Frame& test)
        : reference_(reference),
          test_(test),
          width_(reference.frame.color.width),
          height_(reference.frame.color.height) {
        checkSize(reference.frame, width_, height_);
        checkSize(test, width_, height_);
        masks_.push_back(objectMask(reference.frame, reference.clear));
        for (const Frame& other : reference.others) {
            checkSize(other, width_, height_);
            masks_.push_back(objectMask(other, reference.clear));
        }
        testMask_ = objectMask(test, reference.clear);
        silhouette_ = mixedNeighbourhood(masks_[0], width_, height_);
    }

    Measures measure() {
        for (std::size_t i = 0; i < testMask_.size(); ++i) addPixel(i);
        finish();
        return measures_;
    }

private:
    PixelRanges rangesAt(std::size_t i) const {
        PixelRanges ranges{};
        const auto include = [&](const Frame& frame, const std::vector<bool>& mask, bool first) {
            for (std::size_t k = 0; k < 3; ++k) {
                const int value = frame.color.pixels[i][k];
                if (first) ranges.color[k] = {value, value};
                ranges.color[k].include(value);
            }
            if (first) ranges.depth = {frame.depth.depth[i], frame.depth.depth[i]};
            ranges.depth.include(frame.depth.depth[i]);
            (mask[i] ? ranges.anyObject : ranges.anyEmpty) = true;
        };
        include(reference_.frame, masks_[0], true);
        for (std::size_t k = 0; k < reference_.others.size(); ++k)
            include(reference_.others[k], masks_[k + 1], false);
        return ranges;
    }

    void addPixel(std::size_t i) {
        const PixelRanges ranges = rangesAt(i);
        int error = 0, spread = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            error = std::max(error, ranges.color[k].distance(test_.color.pixels[i][k]));
            spread = std::max(spread, ranges.color[k].high - ranges.color[k].low);
        }
        open_ += spread > kVisible || (ranges.anyObject && ranges.anyEmpty);
        const bool wrong = testMask_[i] ? !ranges.anyObject : !ranges.anyEmpty;
        if (silhouette_[i]) {
            ++measures_.silhouettePixels;
            measures_.coverageSilhouette += wrong;
        } else {
            measures_.coverageInside += wrong;
        }
        if (silhouette_[i] || !masks_[0][i]) {
            outsideSum_ += error;
            ++outside_;
            return;
        }
        insideErrors_.push_back(error);
        const double depth = ranges.depth.distance(test_.depth.depth[i]) - beyondEdge(i, ranges);
        measures_.depthMax = std::max(measures_.depthMax, depth);
    }

    // Where an edge runs through the pixel, some of the moved pictures see what is behind it, and
    // do not tell how the depth of the surface changes. The pixels beside do.
    double beyondEdge(std::size_t i, const PixelRanges& ranges) const {
        constexpr double kMove = 1.0 / 128, kEdge = 1e-3;
        if (ranges.depth.high - ranges.depth.low < kEdge) return 0;
        const auto& depths = reference_.frame.depth.depth;
        double least = ranges.depth.high - ranges.depth.low;
        const auto width = std::ptrdiff_t(width_);
        for (const std::ptrdiff_t step : {std::ptrdiff_t(-1), std::ptrdiff_t(1), -width, width}) {
            const std::ptrdiff_t beside = std::ptrdiff_t(i) + step;
            if (beside < 0 || beside >= std::ptrdiff_t(depths.size())) continue;
            least = std::min(least,
                             double(std::fabs(depths[i] - depths[std::size_t(beside)])));
        }
        return kMove * least;
    }

    void finish() {
        const double pixels = double(testMask_.size());
        measures_.silhouettes = double(measures_.silhouettePixels) / pixels;
        measures_.open = double(open_) / pixels;
        measures_.silhouetteColorMean = outside_ ? outsideSum_ / double(outside_) : 0;
        if (insideErrors_.empty()) return;
        double sum = 0;
        for (const int error : insideErrors_) sum += error;
        measures_.colorMean = sum / double(insideErrors_.size());
        const std::size_t rank = insideErrors_.size() * 999 / 1000;
        std::nth_element(insideErrors_.begin(), insideErrors_.begin() + std::ptrdiff_t(rank),
                         insideErrors_.end());
        measures_.color999 = insideErrors_[rank];
    }

    const Reference& reference_;
    const Frame& test_;
    int width_, height_;
    std::vector<std::vector<bool>> masks_; // of the reference's frame, then of the others
    std::vector<bool> testMask_, silhouette_;
    std::vector<int> insideErrors_;
    long open_ = 0, outside_ = 0;
    double outsideSum_ = 0;
    Measures measures_;
};

} // namespace

Measures compare(const Reference& reference, const Frame& test, bool withFlip) {
    Measures measures = Comparison(reference, test).measure();
    if (!withFlip) return measures;
    measures.flip = meanOf(flipErrors(reference.frame.color, test.color));
    if (measures.flip <= kFlipLimit || reference.others.empty()) return measures;
    // The last of the others is as good a picture: blended without rounding to 8 bits.
    const float unrounded = meanOf(flipErrors(reference.others.back().color, test.color));
    measures.flip = std::min(measures.flip, double(unrounded));
    return measures;
}

std::vector<std::string> failuresOf(const Measures& m, Kind kind, int width, int height) {
    std::vector<std::string> failures;
    const auto limit = [&](const char* name, double value, double most) {
        if (value <= most) return;
        char text[160];
        std::snprintf(text, sizeof text, "%s %.6g, at most %.6g", name, value, most);
        failures.push_back(text);
    };
    // A silhouette's share of a picture grows as pictures shrink: 5 % are meant at 512 pixels.
    const double smaller = std::max(1.0, 512.0 / std::min(width, height));
    limit("open pixels", m.open, 0.05 * smaller);
    limit("coverage away from silhouettes", double(m.coverageInside), 0);
    limit("coverage at silhouettes", double(m.coverageSilhouette),
          0.002 * double(m.silhouettePixels) + 1);
    limit("depth error", m.depthMax, kDepthLimit);
    if (kind == Kind::kGeometry) return failures;
    limit("colour, mean", m.colorMean, kMeanLimit);
    limit("colour, 99.9 percentile", m.color999, k999Limit);
    limit("colour at silhouettes and outside, mean", m.silhouetteColorMean, kSilhouetteColorLimit);
    limit("FLIP", m.flip, kFlipLimit);
    return failures;
}

Picture differencePicture(const Picture& reference, const Picture& test) {
    Picture picture = reference;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            picture.pixels[i][k] = std::uint8_t(
                std::min(255, 8 * std::abs(reference.pixels[i][k] - test.pixels[i][k])));
    return picture;
}

} // namespace conformance
