// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>

#include "libsmart/base/error.h"

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

/// The three stacks, and which of them matrix calls act on. A plain value: objects save a copy.
class Matrices {
public:
    MatrixMode mode() const { return mode_; }
    void setMode(MatrixMode mode) { mode_ = mode; }
    MatrixStack& current() { return stacks_[std::size_t(mode_)]; }
    const MatrixStack& stack(MatrixMode mode) const { return stacks_[std::size_t(mode)]; }
    const glm::dmat4& modelView() const { return stack(MatrixMode::ModelView).top(); }
    const glm::dmat4& projection() const { return stack(MatrixMode::Projection).top(); }

    /// As an object starts: its own coordinates, and nothing of before can be popped.
    void enterObject() {
        for (MatrixStack& stack : stacks_) stack.closeBelow();
        mode_ = MatrixMode::ModelView;
        current().load(glm::dmat4(1.0));
    }

private:
    std::array<MatrixStack, 3> stacks_;
    MatrixMode mode_ = MatrixMode::ModelView;
};

} // namespace smart::compat
