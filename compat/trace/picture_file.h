// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "compat/stream/call_player.h"

namespace smart::compat {

/// A pattern such as frame%03d.png with the frame's number. Throws StreamError unless it has one
/// %d, at most with a width, and ends with .png.
std::string nameOfPicture(const std::string& pattern, uint64_t number);
/// Writes the colours, limited to 0 to 1. Throws StreamError where that fails.
void writePicture(const std::string& path, const PlayedFrame& frame);

} // namespace smart::compat
