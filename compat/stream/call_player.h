// SPDX-License-Identifier: MIT
// Makes recorded calls again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

#include "compat/stream/call_table.h"
#include "openrt/types.h"

struct RTshaderclass;

namespace smart::compat {

/// A stream that is damaged, of another version, or needs what there is not.
class StreamError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A call that does not do what it did when it was recorded.
struct Divergence {
    uint64_t call = 0; ///< its number, from 1
    const char* function = "";
    std::string text;
};

/// A picture that was finished when the stream was recorded, and is now.
struct PlayedFrame {
    uint64_t number = 0; ///< from 1
    uint32_t width = 0, height = 0;
    RTenum format = 0;
    std::size_t stride = 0; ///< bytes between rows; the first is the lowest
    const std::byte* pixels = nullptr;
    bool isEqual = false; ///< to the picture when it was recorded, in every bit
};

/// What a program that plays a stream may have a say in, and hears of. On the threads that play.
class PlayPolicy {
public:
    virtual ~PlayPolicy() = default;
    /// False: the call is left out, such as one whose results the application alone sees.
    virtual bool plays(const CallSignature&) { return true; }
    /// A class that the recorded program registered by itself, by name; nullptr: not known.
    virtual const RTshaderclass* shaderClass(const std::string& name) {
        (void)name;
        return nullptr;
    }
    virtual void frame(const PlayedFrame&) {}
    virtual void diverged(const Divergence&) {}
};

struct PlayLimits {
    uint64_t memory = uint64_t(4) << 30; ///< bytes of frame buffers and results
    uint64_t pixels = uint64_t(1) << 28; ///< of a picture
    uint32_t samples = 4096;             ///< of a pixel
    unsigned threads = 64;
};

/// Makes the calls of a stream, those of the recorded program's first thread on the thread that
/// calls play(), those of each other thread on one of its own. The contexts that the stream made
/// end with the player; it is the only user of the default one. No damage of a stream does more
/// than throw StreamError.
class CallPlayer {
public:
    /// Without a policy all calls are made. The policy has to outlive the player.
    explicit CallPlayer(PlayPolicy* policy = nullptr, const PlayLimits& limits = {});
    ~CallPlayer();
    CallPlayer(const CallPlayer&) = delete;
    CallPlayer& operator=(const CallPlayer&) = delete;

    /// Plays whole records; the first ever is the stream's header. After an error nothing more can
    /// be played.
    void play(std::span<const std::byte> wholeRecords);
    /// After the last record: what remains to be compared.
    void finish();

    uint64_t calls() const;
    uint64_t frames() const; ///< that were compared
    /// Whether calls rendered frames, be they compared or not.
    bool hasRendered() const;
    uint64_t unequalFrames() const;
    uint64_t divergences() const;

private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace smart::compat
