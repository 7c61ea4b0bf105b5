// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

#include "libsmart/base/error.h"
#include "libsmart/geometry/texture_units.h"

namespace smart::compat {

/// OpenGL's stack of matrices; never empty.
class MatrixStack {
public:
    static constexpr std::size_t kDepth = 32;

    const glm::dmat4& top() const { return matrices_[size_ - 1]; }
    void load(const glm::dmat4& matrix) { matrices_[size_ - 1] = matrix; }
    void multiply(const glm::dmat4& matrix) { load(top() * matrix); }
    void push() {
        if (size_ == kDepth) throw Error(ErrorCode::StackOverflow, "the matrix stack is full");
        matrices_[size_] = matrices_[size_ - 1];
        ++size_;
    }
    void pop() {
        if (size_ == floor_)
            throw Error(ErrorCode::StackUnderflow, "no matrix was pushed onto this stack");
        --size_;
    }
    std::size_t depth() const { return size_; }
    /// What is on the stack now can not be popped any more.
    void closeBelow() { floor_ = size_; }

private:
    std::array<glm::dmat4, kDepth> matrices_{glm::dmat4(1.0)};
    std::size_t size_ = 1, floor_ = 1;
};

enum class MatrixMode : uint8_t { ModelView, Projection, Texture };

/// The three stacks, those of the textures once for each unit, and which of them matrix calls act
/// on. A plain value: objects save a copy.
class Matrices {
public:
    MatrixMode mode() const { return mode_; }
    void setMode(MatrixMode mode) { mode_ = mode; }
    /// The texture unit that matrix calls are about.
    void selectUnit(std::size_t unit) noexcept { unit_ = unit; }
    /// Throws std::bad_alloc for a unit's first call.
    MatrixStack& current() {
        if (mode_ != MatrixMode::Texture || unit_ == 0) return stacks_[std::size_t(mode_)];
        if (more_.size() < unit_) more_.resize(unit_);
        return more_[unit_ - 1];
    }
    const MatrixStack& stack(MatrixMode mode) const {
        return mode == MatrixMode::Texture ? textureStack(unit_) : stacks_[std::size_t(mode)];
    }
    const MatrixStack& textureStack(std::size_t unit) const {
        static const MatrixStack initial;
        if (unit == 0) return stacks_[std::size_t(MatrixMode::Texture)];
        return unit <= more_.size() ? more_[unit - 1] : initial;
    }
    const glm::dmat4& modelView() const { return stack(MatrixMode::ModelView).top(); }
    const glm::dmat4& projection() const { return stack(MatrixMode::Projection).top(); }

    /// As an object starts: its own coordinates, and nothing of before can be popped.
    void enterObject() {
        for (MatrixStack& stack : stacks_) stack.closeBelow();
        for (MatrixStack& stack : more_) stack.closeBelow();
        mode_ = MatrixMode::ModelView;
        current().load(glm::dmat4(1.0));
    }

private:
    std::array<MatrixStack, 3> stacks_;
    std::vector<MatrixStack> more_; ///< of the units after the first, as far as they were used
    std::size_t unit_ = 0;
    MatrixMode mode_ = MatrixMode::ModelView;
};

} // namespace smart::compat
