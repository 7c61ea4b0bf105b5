// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

namespace samples {

/// Checks that no Huffman table of a JPEG file has more codes than there are symbols, and that no
/// scan asks for a table that the file has not defined: stb_image, up to version 2.27, writes beyond
/// its own table then, or decodes by what happens to lie in memory. Throws LoadError.
void checkJpegTables(std::span<const uint8_t> bytes);

} // namespace samples
