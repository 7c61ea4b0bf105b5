// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "compat/recorder/pixel_unpack.h"
#include "openrt/types.h"

namespace smart::compat {

/// Components of a pixel; 0: no format of images.
int componentsOf(RTenum format) noexcept;
/// Bytes of a component; 0: no type that images can have here.
std::size_t bytesOf(RTenum type) noexcept;

/// An image in the numbers of its type, whole ones but for RT_FLOAT; x runs fastest.
struct Image {
    RTenum type;
    int components;
    int width, height, depth;
    std::vector<double> values;

    /// Throws what vectors throw where it is larger than memory can be.
    Image(RTenum imageType, int imageComponents, int w, int h, int d);
    std::size_t rows() const { return std::size_t(height) * std::size_t(depth); }
    std::size_t valuesOfRow() const { return std::size_t(width) * std::size_t(components); }
    double* pixel(int x, int y, int z) {
        return values.data() + offset(x, y, z);
    }
    const double* pixel(int x, int y, int z) const { return values.data() + offset(x, y, z); }

private:
    std::size_t offset(int x, int y, int z) const {
        const auto row = std::size_t(z) * std::size_t(height) + std::size_t(y);
        return (row * std::size_t(width) + std::size_t(x)) * std::size_t(components);
    }
};

/// Reads an image as the unpack state says it lies.
Image readImage(const void* data, RTenum type, int components, int width, int height, int depth,
                const PixelStore& store);

/// Writes an image as the pack state says it is to lie; what lies between its rows stays.
void writeImage(const Image& image, const PixelStore& store, void* data);
/// Bytes of an image whose rows follow each other.
std::size_t tightBytes(const Image& image);

/// The same picture in another type, by way of 16 bits as GLU has it; `scaled`: the range of the
/// type stands for 0 to 1, as opposed to indices.
Image toShorts(const Image& image, bool scaled);
Image fromShorts(const Image& shorts, RTenum type, bool scaled);

/// What an enlarged pixel is the mean of: the part of the image that it covers, or as much as a
/// pixel of the image about its middle.
enum class Enlarging { Exact, WholePixels };

/// GLU's box filter; an image with half the width and height takes the means of four.
Image scaleImage(const Image& image, int width, int height, int depth, Enlarging enlarging);

} // namespace smart::compat
