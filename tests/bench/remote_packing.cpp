// SPDX-License-Identifier: MIT
#include "tests/bench/remote_packing.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>
#include <vector>

#include "compat/mpi/lz4_codec.h"
#include "libsmart/remote/answer_packing.h"
#include "libsmart/render/stored_tile.h"
#include "libsmart/render/tile_order.h"
#include "libsmart/render/tracer.h"
#include "tests/bench/remote_job.h"

namespace smart::bench {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto kTileTime = 1ms;

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<std::byte> storedTile(const PixelTarget& target, const Tile& tile) {
    std::vector<std::byte> stored(storedTileSize(target, tile));
    gatherTile(target, tile, stored.data());
    return stored;
}

/// Gives a picture of four bytes a pixel as it is, slowly.
class ReplayTracer final : public Tracer {
public:
    explicit ReplayTracer(const PixelTarget& picture)
        : bytes_(storedTile(picture, {0, 0, picture.width, picture.height})),
          width_(picture.width) {}
    void render(const Frame&, const Tile& tile, TilePixels& pixels) const override {
        const auto end = Clock::now() + kTileTime;
        for (uint32_t j = 0; j < tile.height; ++j)
            for (uint32_t i = 0; i < tile.width; ++i) {
                const std::byte* const from =
                    &bytes_[4 * (std::size_t(tile.y + j) * width_ + tile.x + i)];
                glm::vec4& to = pixels.color[j * kTileSize + i];
                for (int k = 0; k < 4; ++k) to[k] = float(from[k]) / 255.0f;
            }
        std::this_thread::sleep_until(end);
    }

private:
    const std::vector<std::byte> bytes_;
    const uint32_t width_;
};

} // namespace

PackingCosts packingCosts(const Frame& frame, unsigned repeat) {
    const PixelTarget& target = frame.target;
    const std::vector<Tile> tiles = mortonTiles(target.width, target.height);
    const StoredLayout layout = storedLayout(target);
    const compat::Lz4Codec codec;
    AnswerPacker packer(&codec, Packing::Always, 1);
    AnswerUnpacker unpacker(&codec);
    PackMemory memory;
    PackingCosts costs;
    costs.packSeconds = costs.unpackSeconds = 1e300;
    for (unsigned r = 0; r < std::max(repeat, 3u); ++r) {
        double pack = 0, unpack = 0;
        std::size_t plain = 0, packed = 0;
        for (const Tile& tile : tiles) {
            const std::vector<std::byte> stored = storedTile(target, tile);
            Clock::time_point start = Clock::now();
            const std::span<const std::byte> travels =
                packer.pack(layout, tile, stored, 1e-3, true, memory);
            pack += since(start);
            plain += stored.size();
            packed += travels.size();
            if (travels.size() == stored.size()) continue;
            start = Clock::now();
            unpacker.unpack(layout, tile, stored.size(), travels);
            unpack += since(start);
        }
        const double count = double(tiles.size());
        costs.packSeconds = std::min(costs.packSeconds, pack / count);
        costs.unpackSeconds = std::min(costs.unpackSeconds, unpack / count);
        costs.plainBytes = double(plain) / count;
        costs.packedBytes = double(packed) / count;
    }
    return costs;
}

void printSimulatedPacking(const std::shared_ptr<Frame>& frame, unsigned frames) {
    const ReplayTracer tracer(frame->target);
    std::printf(
        "\nPacking over simulated lines: 8 ranks, tiles that sleep 1 ms\n"
        "line MB/s  packing       frame ms  bytes a frame\n");
    struct Way {
        const char* name;
        Packing packing;
    };
    constexpr Way kWays[] = {{"never", Packing::Never},
                             {"always", Packing::Always},
                             {"when it pays", Packing::WhenItPays}};
    for (const double line : {0.0, 10e6, 3e6})
        for (const Way& way : kWays) {
            RemoteJob job(7, tracer, frame, {100us, line}, way.packing);
            const double seconds = job.secondsOfQueue(frames);
            std::printf("%9.0f  %-12s  %8.1f  %13.0f\n", line * 1e-6, way.name, seconds * 1e3,
                        double(job.traffic().answerBytes) / (frames + 1));
        }
}

} // namespace smart::bench
