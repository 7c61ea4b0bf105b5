// SPDX-License-Identifier: MIT
// What processes that render together say to each other. Everything that is received goes through
// parseMessage(), which takes any bytes whatever.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "libsmart/render/framebuffer.h"

namespace smart {

/// Of the messages below; theirs must be the same on both sides.
inline constexpr uint16_t kWireVersion = 2;

// A message: magic, version, type, length of the payload (4, 2, 2, 8 bytes), checksum of all that
// and of the payload (8 bytes), payload. Numbers have their lowest byte first. This much, and the
// payloads of Hello and Leave, stay in every version.
inline constexpr std::size_t kHeaderSize = 24;
inline constexpr std::size_t kMaxPart = 1u << 20; ///< bytes of calls or pictures in a message
inline constexpr std::size_t kMaxMessage = kHeaderSize + 64 + kMaxPart;
inline constexpr std::size_t kMaxText = 1024;

/// The number-th frame of the renderer-th renderer, both from 1, in the order of submission and of
/// creation: the same in all processes, as they make the same calls. Or its number-th picture that
/// is shared.
struct FrameKey {
    uint64_t renderer = 0, number = 0;
    auto operator<=>(const FrameKey&) const = default;
};

// From the worker.
struct Hello {
    std::string identity; ///< of its library; processes render together where all have the same
    uint32_t threads = 0;
};
struct FrameReady {
    FrameKey frame; ///< tiles of it may be asked for
    uint64_t fingerprint = 0; ///< frame_fingerprint.h
};
struct TileAnswer {
    uint64_t ticket = 0;
    uint64_t primaryRays = 0, shadowRays = 0, secondaryRays = 0, badPixels = 0;
    uint64_t busyNanoseconds = 0;
    bool packed = false;               ///< tile_planes.h, and then the job's codec
    std::span<const std::byte> pixels; ///< empty: not rendered, as the frame is over
};
struct Progress {
    uint64_t bytes = 0; ///< of calls and pictures taken in so far
};
struct Trouble {
    std::string text; ///< why it can no longer take part
};

// From the master.
struct CallBytes {
    std::span<const std::byte> bytes; ///< the next of the stream of calls (call_bytes.h)
};
struct TileRequest {
    uint64_t ticket = 0; ///< for the answer
    FrameKey frame;
    Tile tile;
    uint32_t width = 0, height = 0; ///< of the picture
    uint32_t bytes = 0;             ///< of the tile in its formats
    bool mayPack = false;           ///< the answer may be packed
    uint64_t arrived = 0;           ///< bytes of pixels that have come from this worker so far
};
struct FrameOver {
    FrameKey frame;
    bool done = false; ///< else cancelled or failed
};
struct PictureBytes {
    FrameKey picture;
    bool last = false;
    std::span<const std::byte> bytes;
};
struct Leave {};

using Message = std::variant<Hello, FrameReady, TileAnswer, Progress, Trouble, CallBytes,
                             TileRequest, FrameOver, PictureBytes, Leave>;

/// Bytes on their way to several receivers.
using Packet = std::shared_ptr<const std::vector<std::byte>>;

/// Longer texts are cut.
Packet encode(const Message& message);

struct Parsed {
    Message message;
    const char* problem = nullptr; ///< why it is no message; nullptr: it is
};
/// The spans of the result point into `bytes`, which is one whole message.
Parsed parseMessage(std::span<const std::byte> bytes);

/// Length of the whole message that begins so; 0: no message does.
std::size_t messageLength(std::span<const std::byte, kHeaderSize> header);

} // namespace smart
