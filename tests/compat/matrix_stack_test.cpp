// SPDX-License-Identifier: MIT
#include "compat/recorder/matrix_stack.h"

#include <gtest/gtest.h>

#include "compat/recorder/transforms.h"

namespace smart::compat {
namespace {

ErrorCode codeOf(auto&& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.code();
    }
    ADD_FAILURE() << "nothing was thrown";
    return ErrorCode::InvalidEnum;
}

TEST(MatrixStack, HoldsThirtyTwoAndChecksBothEnds) {
    MatrixStack stack;
    EXPECT_EQ(codeOf([&] { stack.pop(); }), ErrorCode::StackUnderflow);
    for (int i = 1; i < 32; ++i) {
        stack.push();
        stack.multiply(makeTranslation({1, 0, 0}));
    }
    EXPECT_EQ(stack.depth(), 32u);
    EXPECT_EQ(codeOf([&] { stack.push(); }), ErrorCode::StackOverflow);
    for (int i = 31; i > 0; --i) {
        EXPECT_EQ(stack.top()[3][0], i);
        stack.pop();
    }
    EXPECT_EQ(stack.top()[3][0], 0);
    EXPECT_EQ(codeOf([&] { stack.pop(); }), ErrorCode::StackUnderflow);
    EXPECT_EQ(stack.depth(), 1u);
}

TEST(MatrixStack, MultipliesFromTheRight) {
    MatrixStack stack;
    stack.multiply(makeTranslation({1, 2, 3}));
    stack.multiply(makeScaling({2, 2, 2}));
    const glm::dvec4 p = stack.top() * glm::dvec4(1, 1, 1, 1); // scaled first
    EXPECT_EQ(p, glm::dvec4(3, 4, 5, 1));
}

TEST(Matrices, ObjectsHaveTheirOwn) {
    Matrices matrices;
    matrices.current().load(makeTranslation({1, 0, 0}));
    matrices.current().push();
    matrices.setMode(MatrixMode::Projection);
    matrices.current().load(makeScaling({3, 3, 3}));
    const Matrices saved = matrices;
    matrices.enterObject();
    EXPECT_EQ(matrices.mode(), MatrixMode::ModelView);
    EXPECT_EQ(matrices.modelView(), glm::dmat4(1.0));
    EXPECT_EQ(matrices.projection()[0][0], 3);
    EXPECT_EQ(codeOf([&] { matrices.current().pop(); }), ErrorCode::StackUnderflow);
    matrices.current().push();
    matrices.current().pop();
    matrices = saved;
    EXPECT_EQ(matrices.mode(), MatrixMode::Projection);
    EXPECT_EQ(matrices.modelView()[3][0], 1);
    matrices.setMode(MatrixMode::ModelView);
    matrices.current().pop();
    EXPECT_EQ(matrices.current().depth(), 1u);
}

} // namespace
} // namespace smart::compat
