// SPDX-License-Identifier: MIT
#include "libsmart/remote/wire.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>
#include <utility>

namespace smart {
namespace {

constexpr uint32_t kMagic = 0x5754524F; // "ORTW"
constexpr std::size_t kChecksumAt = 16;

uint64_t readNumber(const std::byte* from, std::size_t bytes) {
    uint64_t value = 0;
    for (std::size_t i = bytes; i-- > 0;) value = value << 8 | uint64_t(from[i]);
    return value;
}

/// Against faults of machines and programs, not against malice: every step can be undone, so that
/// a change of one word always shows.
class Checksum {
public:
    void add(std::span<const std::byte> bytes) {
        std::size_t i = 0;
        for (; i + 8 <= bytes.size(); i += 8) add(readNumber(bytes.data() + i, 8));
        add(readNumber(bytes.data() + i, bytes.size() - i));
    }
    uint64_t value() const { return value_; }

private:
    void add(uint64_t word) {
        value_ = std::rotl((value_ ^ word) * 0x9E3779B97F4A7C15u, 29);
    }
    uint64_t value_ = 0x6F70656E72742121u;
};

uint64_t checksumOf(std::span<const std::byte> message) {
    Checksum sum;
    sum.add(message.first(kChecksumAt));
    sum.add(message.subspan(kHeaderSize));
    return sum.value();
}

/// Appends to a message.
class Writer {
public:
    explicit Writer(std::vector<std::byte>& bytes) : bytes_(bytes) {}

    template <class Number>
        requires std::is_unsigned_v<Number>
    void operator()(const Number& value) {
        for (std::size_t i = 0; i < sizeof value; ++i)
            bytes_.push_back(std::byte(uint64_t(value) >> (8 * i) & 0xFF));
    }
    void operator()(const std::string& text) {
        const std::size_t length = std::min(text.size(), kMaxText);
        (*this)(uint32_t(length));
        append(text.data(), length);
    }
    void operator()(const std::span<const std::byte>& rest) { append(rest.data(), rest.size()); }

private:
    void append(const void* from, std::size_t count) {
        const std::size_t old = bytes_.size();
        bytes_.resize(old + count);
        if (count != 0) std::memcpy(bytes_.data() + old, from, count);
    }
    std::vector<std::byte>& bytes_;
};

/// Takes from a message; what it lacks becomes a problem.
class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

    template <class Number>
        requires std::is_unsigned_v<Number>
    void operator()(Number& value) {
        const std::span<const std::byte> bytes = take(sizeof value);
        const uint64_t number = readNumber(bytes.data(), bytes.size());
        if (std::is_same_v<Number, bool> && number > 1) problem_ = "a truth value is neither";
        value = Number(number);
    }
    void operator()(std::string& text) {
        uint32_t length = 0;
        (*this)(length);
        if (length > kMaxText) problem_ = "a text is too long";
        if (problem_) return;
        const std::span<const std::byte> bytes = take(length);
        text.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }
    void operator()(std::span<const std::byte>& rest) {
        if (rest_.size() > kMaxPart) problem_ = "too many bytes";
        rest = std::exchange(rest_, {});
    }
    const char* problem() const {
        return problem_ ? problem_ : rest_.empty() ? nullptr : "longer than its type is";
    }

private:
    std::span<const std::byte> take(std::size_t count) {
        if (count > rest_.size()) problem_ = "shorter than its type is";
        if (problem_) return {};
        const std::span<const std::byte> taken = rest_.first(count);
        rest_ = rest_.subspan(count);
        return taken;
    }
    std::span<const std::byte> rest_;
    const char* problem_ = nullptr;
};

// The fields of each message, in their order on the wire, for both directions.
template <class Io, class M>
void fields(Io& io, M& m) {
    using Type = std::remove_const_t<M>;
    if constexpr (std::is_same_v<Type, FrameKey>) {
        io(m.renderer), io(m.number);
    } else if constexpr (std::is_same_v<Type, Tile>) {
        io(m.x), io(m.y), io(m.width), io(m.height);
    } else if constexpr (std::is_same_v<Type, Hello>) {
        io(m.threads), io(m.identity);
    } else if constexpr (std::is_same_v<Type, FrameReady>) {
        fields(io, m.frame), io(m.fingerprint);
    } else if constexpr (std::is_same_v<Type, TileAnswer>) {
        io(m.ticket), io(m.primaryRays), io(m.shadowRays), io(m.secondaryRays), io(m.badPixels),
            io(m.busyNanoseconds), io(m.packed), io(m.pixels);
    } else if constexpr (std::is_same_v<Type, Progress>) {
        io(m.bytes);
    } else if constexpr (std::is_same_v<Type, Trouble>) {
        io(m.text);
    } else if constexpr (std::is_same_v<Type, CallBytes>) {
        io(m.bytes);
    } else if constexpr (std::is_same_v<Type, TileRequest>) {
        io(m.ticket), fields(io, m.frame), fields(io, m.tile), io(m.width), io(m.height),
            io(m.bytes), io(m.mayPack), io(m.arrived);
    } else if constexpr (std::is_same_v<Type, FrameOver>) {
        fields(io, m.frame), io(m.done);
    } else if constexpr (std::is_same_v<Type, PictureBytes>) {
        fields(io, m.picture), io(m.last), io(m.bytes);
    }
}

const char* problemOf(const TileRequest& m) {
    const Tile& t = m.tile;
    const bool fits = t.width >= 1 && t.width <= kTileSize && t.height >= 1 &&
                      t.height <= kTileSize && t.x < m.width && t.width <= m.width - t.x &&
                      t.y < m.height && t.height <= m.height - t.y;
    return fits ? nullptr : "no such tile";
}
template <class M>
const char* problemOf(const M&) {
    return nullptr;
}

template <std::size_t type = 0>
Parsed parsePayload(std::size_t wanted, std::span<const std::byte> payload) {
    if constexpr (type == std::variant_size_v<Message>) {
        return {{}, "of an unknown type"};
    } else {
        if (type != wanted) return parsePayload<type + 1>(wanted, payload);
        std::variant_alternative_t<type, Message> message;
        Reader reader(payload);
        fields(reader, message);
        const char* problem = reader.problem();
        if (!problem) problem = problemOf(message);
        return {std::move(message), problem};
    }
}

} // namespace

Packet encode(const Message& message) {
    const auto bytes = std::make_shared<std::vector<std::byte>>();
    Writer write(*bytes);
    write(kMagic), write(kWireVersion), write(uint16_t(message.index())), write(uint64_t(0)),
        write(uint64_t(0));
    std::visit([&](const auto& m) { fields(write, m); }, message);
    const auto patch = [&](std::size_t at, uint64_t value) {
        for (std::size_t i = 0; i < 8; ++i) (*bytes)[at + i] = std::byte(value >> (8 * i) & 0xFF);
    };
    patch(8, bytes->size() - kHeaderSize);
    patch(kChecksumAt, checksumOf(*bytes));
    return bytes;
}

std::size_t messageLength(std::span<const std::byte, kHeaderSize> header) {
    if (readNumber(header.data(), 4) != kMagic) return 0;
    const uint64_t length = readNumber(header.data() + 8, 8);
    return length <= kMaxMessage - kHeaderSize ? kHeaderSize + std::size_t(length) : 0;
}

Parsed parseMessage(std::span<const std::byte> bytes) {
    if (bytes.size() < kHeaderSize) return {{}, "shorter than any message"};
    if (readNumber(bytes.data(), 4) != kMagic) return {{}, "no message of this library"};
    if (readNumber(bytes.data() + 4, 2) != kWireVersion)
        return {{}, "of another version of this library"};
    if (messageLength(bytes.first<kHeaderSize>()) != bytes.size())
        return {{}, "not as long as it says"};
    if (readNumber(bytes.data() + kChecksumAt, 8) != checksumOf(bytes))
        return {{}, "damaged: its checksum is wrong"};
    return parsePayload(readNumber(bytes.data() + 6, 2), bytes.subspan(kHeaderSize));
}

} // namespace smart
