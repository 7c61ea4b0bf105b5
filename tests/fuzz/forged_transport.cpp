// SPDX-License-Identifier: MIT
#include "tests/fuzz/forged_transport.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <utility>
#include <variant>

#include "libsmart/remote/call_bytes.h"
#include "tests/libsmart/remote/shared_renderer.h"

namespace openrt::test {

using namespace smart;

namespace {

constexpr std::size_t kPixel = 4 * sizeof(float);

uint64_t checksumOf(std::span<const std::byte> message) {
    uint64_t sum = 0x6F70656E72742121u;
    const auto add = [&](std::span<const std::byte> bytes) {
        for (std::size_t at = 0; at <= bytes.size(); at += 8) {
            uint64_t word = 0;
            for (std::size_t i = std::min<std::size_t>(8, bytes.size() - at); i-- > 0;)
                word = word << 8 | uint64_t(bytes[at + i]);
            sum = std::rotl((sum ^ word) * 0x9E3779B97F4A7C15u, 29);
        }
    };
    add(message.first(16));
    add(message.subspan(kHeaderSize));
    return sum;
}

void put(std::vector<std::byte>& bytes, std::size_t at, uint64_t number, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) bytes[at + i] = std::byte(number >> (8 * i) & 0xFF);
}

} // namespace

Packet framed(uint16_t type, std::span<const std::byte> payload) {
    const auto bytes = std::make_shared<std::vector<std::byte>>(kHeaderSize + payload.size());
    put(*bytes, 0, 0x5754524F, 4);
    put(*bytes, 4, kWireVersion, 2);
    put(*bytes, 6, type, 2);
    put(*bytes, 8, payload.size(), 8);
    std::copy(payload.begin(), payload.end(), bytes->begin() + std::ptrdiff_t(kHeaderSize));
    put(*bytes, 16, checksumOf(*bytes), 8);
    return bytes;
}

ForgedTransport::ForgedTransport(Input& input, unsigned peers, std::vector<uint64_t> fingerprints)
    : input_(input), fingerprints_(std::move(fingerprints)), requests_(peers),
      requestBytes_(peers) {}

void ForgedTransport::send(unsigned peer, Packet packet) {
    const Parsed parsed = parseMessage(*packet);
    if (parsed.problem) std::abort();
    const std::lock_guard lock(mutex_);
    if (const auto* const request = std::get_if<TileRequest>(&parsed.message)) {
        requests_.at(peer).push_back(request->ticket);
        requestBytes_[peer] = request->bytes;
    }
    if (const auto* const ready = std::get_if<FrameReady>(&parsed.message))
        ready_.insert(ready->frame);
    news_.notify_all();
}

Transport::Event ForgedTransport::receive(std::chrono::microseconds timeout, unsigned& peer,
                                          std::vector<std::byte>& message) {
    if (!input_.atEnd()) {
        peer = input_.byte() % peers();
        message = *next(peer);
        return Event::Arrived;
    }
    if (closed_ < peers()) {
        peer = closed_++;
        return Event::Closed;
    }
    std::unique_lock lock(mutex_);
    news_.wait_for(lock, timeout);
    return Event::Nothing;
}

template <class Condition>
void ForgedTransport::waitFor(std::unique_lock<std::mutex>& lock, Condition condition) {
    if (patience_ > 0 && !news_.wait_for(lock, std::chrono::milliseconds(10), condition))
        --patience_;
}

FrameKey ForgedTransport::key() {
    const uint8_t choice = input_.byte();
    return {choice < 224 ? 1u : choice & 3u, 1 + (choice & 3u)};
}

std::vector<std::byte> ForgedTransport::someBytes() {
    std::vector<std::byte> bytes(input_.byte());
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = i < 16 ? std::byte(input_.byte()) : bytes[i % 16];
    return bytes;
}

Packet ForgedTransport::next(unsigned peer) {
    const uint8_t type = input_.byte();
    Packet packet = type < 200 ? fitting(peer, type % 10) : nullptr;
    if (!packet) packet = framed(type % 12, someBytes());
    const uint8_t damage = input_.byte();
    if (damage < 232) return packet;
    std::vector<std::byte> bytes = *packet;
    if (damage & 1) bytes.resize(bytes.size() * input_.byte() / 256);
    else bytes[input_.word() % bytes.size()] = std::byte(input_.byte());
    return std::make_shared<std::vector<std::byte>>(std::move(bytes));
}

Packet ForgedTransport::fitting(unsigned peer, uint8_t type) {
    const uint8_t choice = input_.byte();
    std::unique_lock lock(mutex_);
    switch (type) {
        case 0: return encode(Hello{choice < 240 ? kIdentity : "another", choice % 8u});
        case 1: {
            const FrameKey frame = key();
            const bool isKnown = frame.number <= fingerprints_.size() && choice < 240;
            return encode(FrameReady{frame, isKnown ? fingerprints_[frame.number - 1] : choice});
        }
        case 2: {
            std::vector<uint64_t>& tickets = requests_[peer];
            waitFor(lock, [&] { return !tickets.empty(); });
            uint64_t ticket = choice;
            if (!tickets.empty() && choice < 240) {
                ticket = tickets.back();
                if (choice & 1) tickets.pop_back(); // else it is answered again
            }
            const std::vector<std::byte> pixels(choice % 16 < 12 ? requestBytes_[peer] : choice);
            return encode(TileAnswer{ticket, 1, 2, 3, 4, 5, choice % 16 == 13, pixels});
        }
        case 3: return encode(Progress{uint64_t(choice) << choice % 64});
        case 4: return encode(Trouble{std::string(choice, '%')});
        case 5: {
            const smart::test::FrameCall call{choice % 8u, kWidth, kHeight, choice > 128, 0};
            std::vector<std::byte> bytes;
            appendCall(bytes, std::as_bytes(std::span(&call, 1)));
            if (choice >= 240) bytes.resize(bytes.size() - choice % 16); // the rest may follow
            return encode(CallBytes{bytes});
        }
        case 6: {
            const FrameKey frame = key();
            waitFor(lock, [&] { return ready_.contains(frame); });
            const Tile tile{choice & 1u ? 32u : 0u, choice & 2u ? 32u : 0u, 8, 4};
            return encode(TileRequest{choice, frame, tile, kWidth, kHeight,
                                      uint32_t(choice < 240 ? 8 * 4 * kPixel : choice)});
        }
        case 7: return encode(FrameOver{key(), choice < 128});
        case 8: {
            const std::vector<std::byte> part(kWidth * kHeight * kPixel / 2 + (choice > 250));
            return encode(PictureBytes{key(), choice % 2 == 1, part});
        }
        default: return choice < 128 ? nullptr : encode(Leave{});
    }
}

} // namespace openrt::test
