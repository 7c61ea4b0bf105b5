// SPDX-License-Identifier: MIT
// The memory that a recorded program had, as far as its calls need it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "compat/stream/call_memory.h"
#include "openrt/types.h"

namespace smart::compat {

/// Bytes that may still be asked for.
class MemoryBudget {
public:
    explicit MemoryBudget(uint64_t bytes) : left_(bytes) {}
    void take(uint64_t bytes);
    void give(uint64_t bytes) { left_ += bytes; }

private:
    uint64_t left_;
};

/// Memory for the pointers of one call. Zeros, and more of them than any value of state has: what
/// a damaged stream makes a call read beyond its own is defined.
class CallArena {
public:
    static constexpr std::size_t kLeast = 512;

    explicit CallArena(MemoryBudget& budget) : budget_(budget) {}
    ~CallArena();
    CallArena(const CallArena&) = delete;
    CallArena& operator=(const CallArena&) = delete;

    std::byte* allocate(uint64_t bytes);
    std::byte* copy(std::span<const std::byte> bytes);

private:
    MemoryBudget& budget_;
    uint64_t taken_ = 0;
    std::vector<std::unique_ptr<std::byte[]>> blocks_;
};

/// The memory that pictures go to, by the key that it has in the stream.
class FrameBuffers {
public:
    explicit FrameBuffers(MemoryBudget& budget) : budget_(budget) {}
    /// At least so many bytes; other ones than before where those were too few. They stay.
    std::byte* memory(uint64_t key, uint64_t bytes);
    /// nullptr: there are fewer.
    const std::byte* find(uint64_t key, uint64_t bytes) const;

private:
    struct Block {
        std::unique_ptr<std::byte[]> memory;
        uint64_t bytes = 0;
    };
    MemoryBudget& budget_;
    std::map<uint64_t, Block> blocks_;
    std::vector<Block> retired_; ///< frames in flight may go there
};

/// The places that a context's pictures go to, as its calls set them.
class PictureTargets {
public:
    /// Memory for rtSetFrameBuffer, whatever the format.
    std::byte* frameBuffer(FrameBuffers& buffers, uint64_t key, RTuint width,
                           RTuint height) const;
    std::byte* auxBuffer(FrameBuffers& buffers, uint64_t key, RTenum what) const;
    /// These calls have been made; what is too small since is set anew.
    void setFrameBuffer(FrameBuffers& buffers, uint64_t key, RTuint width, RTuint height,
                        RTenum format);
    /// Pictures have as many pixels: those without a frame buffer fill the viewport.
    void setLargest(FrameBuffers& buffers, uint64_t pixels);
    void setStride(FrameBuffers& buffers, RTsizei stride);
    void setAuxBuffer(RTenum what, uint64_t key, RTuint format);
    /// Of the memory that a frame would draw to now.
    std::vector<uint64_t> keys() const;
    /// Throws StreamError for more pixels than there may be.
    static void checkSize(uint64_t width, uint64_t height, uint64_t most);

private:
    uint64_t frameBytes(RTuint width, RTuint height) const;
    void growAux(FrameBuffers& buffers);

    struct Aux {
        uint64_t key;
        RTuint format;
        std::byte* memory;
    };
    uint64_t key_ = 0;
    RTuint width_ = 0, height_ = 0;
    uint64_t auxPixels_ = 0;
    RTenum format_ = 0;
    RTsizei stride_ = 0;
    std::map<RTenum, Aux> aux_;
};

} // namespace smart::compat
