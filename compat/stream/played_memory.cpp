// SPDX-License-Identifier: MIT
#include "compat/stream/played_memory.h"

#include <algorithm>
#include <cstring>

#include "compat/stream/call_player.h"
#include "openrt/rt_frame.h"

namespace smart::compat {

namespace {

/// Aligned for anything, as all memory of `new` is. Bytes, for of larger types padding would not be
/// zero.
std::unique_ptr<std::byte[]> zeros(uint64_t bytes) {
    static_assert(__STDCPP_DEFAULT_NEW_ALIGNMENT__ >= alignof(std::max_align_t));
    return std::make_unique<std::byte[]>(std::size_t(bytes));
}

} // namespace

void MemoryBudget::take(uint64_t bytes) {
    if (bytes > left_) throw StreamError("the calls need more memory than the player may have");
    left_ -= bytes;
}

CallArena::~CallArena() {
    budget_.give(taken_);
}

std::byte* CallArena::allocate(uint64_t bytes) {
    bytes = std::max<uint64_t>(bytes, kLeast);
    budget_.take(bytes);
    taken_ += bytes;
    return blocks_.emplace_back(zeros(bytes)).get();
}

std::byte* CallArena::copy(std::span<const std::byte> bytes) {
    std::byte* const to = allocate(bytes.size() + 1); // text ends where the copy does
    if (!bytes.empty()) std::memcpy(to, bytes.data(), bytes.size());
    return to;
}

std::byte* FrameBuffers::memory(uint64_t key, uint64_t bytes) {
    if (key == 0) throw StreamError("a picture has no place to go to");
    Block& block = blocks_[key];
    bytes = std::max<uint64_t>(bytes, CallArena::kLeast);
    if (block.bytes < bytes) {
        budget_.take(bytes);
        if (block.memory) retired_.push_back(std::move(block));
        block = {zeros(bytes), bytes};
    }
    return block.memory.get();
}

const std::byte* FrameBuffers::find(uint64_t key, uint64_t bytes) const {
    const auto found = blocks_.find(key);
    return found == blocks_.end() || found->second.bytes < bytes ? nullptr
                                                                 : found->second.memory.get();
}

void PictureTargets::checkSize(uint64_t width, uint64_t height, uint64_t most) {
    if (width > 0 && height > most / width)
        throw StreamError("a picture has more pixels than the player allows");
}

std::vector<uint64_t> PictureTargets::keys() const {
    std::vector<uint64_t> all{key_};
    for (const auto& [what, aux] : aux_) all.push_back(aux.key);
    return all;
}

uint64_t PictureTargets::frameBytes(RTuint width, RTuint height) const {
    const uint64_t row = uint64_t(width) * 4 * sizeof(float); // no format has larger pixels
    return std::max(row, uint64_t(std::max(stride_, 0))) * height;
}

std::byte* PictureTargets::frameBuffer(FrameBuffers& buffers, uint64_t key, RTuint width,
                                       RTuint height) const {
    return buffers.memory(key, frameBytes(width, height));
}

std::byte* PictureTargets::auxBuffer(FrameBuffers& buffers, uint64_t key, RTenum what) const {
    return buffers.memory(key, auxPixels_ * bytesOfAuxBufferPixel(what));
}

void PictureTargets::setFrameBuffer(FrameBuffers& buffers, uint64_t key, RTuint width,
                                    RTuint height, RTenum format) {
    key_ = key;
    width_ = width;
    height_ = height;
    format_ = format;
    setLargest(buffers, uint64_t(width) * height);
}

void PictureTargets::setLargest(FrameBuffers& buffers, uint64_t pixels) {
    auxPixels_ = std::max(auxPixels_, pixels);
    growAux(buffers);
}

void PictureTargets::setStride(FrameBuffers& buffers, RTsizei stride) {
    stride_ = stride;
    if (key_ != 0)
        rtSetFrameBuffer(reinterpret_cast<RTubyte*>(
                             frameBuffer(buffers, key_, width_, height_)),
                         width_, height_, format_);
}

void PictureTargets::setAuxBuffer(RTenum what, uint64_t key, RTuint format) {
    if (key == 0)
        aux_.erase(what);
    else
        aux_[what] = {key, format, nullptr};
}

void PictureTargets::growAux(FrameBuffers& buffers) {
    for (auto& [what, aux] : aux_) {
        std::byte* const memory = auxBuffer(buffers, aux.key, what);
        if (memory != aux.memory) rtSetAuxBuffer(what, memory, aux.format);
        aux.memory = memory;
    }
}

} // namespace smart::compat
