// SPDX-License-Identifier: MIT
#include "compat/recorder/error_state.h"

#include <gtest/gtest.h>

#include <string>

namespace smart::compat {
namespace {

TEST(ErrorState, TheFirstSticksUntilItIsTaken) {
    ErrorState errors;
    EXPECT_FALSE(errors.take());
    EXPECT_STREQ(errors.text(), "");
    errors.raise(ErrorCode::InvalidValue, "f", "first");
    errors.raise(ErrorCode::OutOfMemory, "g", "second");
    EXPECT_STREQ(errors.text(), "first");
    EXPECT_EQ(errors.take(), ErrorCode::InvalidValue);
    EXPECT_FALSE(errors.take());
    EXPECT_STREQ(errors.text(), "first");
    errors.raise(ErrorCode::OutOfMemory, "g", "third");
    EXPECT_STREQ(errors.text(), "third");
}

TEST(ErrorState, CutsLongTexts) {
    ErrorState errors;
    errors.raise(ErrorCode::InvalidValue, "f", std::string(5000, 'x').c_str());
    EXPECT_LT(std::string(errors.text()).size(), 300u);
    EXPECT_EQ(errors.text()[0], 'x');
}

/// Raises again, replaces itself, and throws: nothing of it may harm.
class Rude final : public ErrorListener {
public:
    Rude(ErrorState& errors, int& calls) : errors_(errors), calls_(calls) {}
    void error(ErrorCode, const char*, const char* text) override {
        ++calls_;
        errors_.raise(ErrorCode::StackOverflow, "f", "again");
        errors_.setListener(nullptr);
        EXPECT_STREQ(text, "now");
        throw 1;
    }

private:
    ErrorState& errors_;
    int& calls_;
};

TEST(ErrorState, SurvivesAnyListener) {
    ErrorState errors;
    int calls = 0;
    errors.setListener(std::make_shared<Rude>(errors, calls));
    errors.raise(ErrorCode::InvalidEnum, "f", "now");
    errors.raise(ErrorCode::InvalidEnum, "f", "later");
    EXPECT_EQ(calls, 1);
    EXPECT_EQ(errors.take(), ErrorCode::InvalidEnum);
}

} // namespace
} // namespace smart::compat
