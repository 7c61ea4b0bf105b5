// SPDX-License-Identifier: MIT
#include "libsmart/base/fp_environment.h"

#include <gtest/gtest.h>

#include <cfenv>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace smart {
namespace {

// Operands that the compiler does not know and a result it must keep, so that the machine computes.
float quotient(float a, float b) {
    volatile float x = a, y = b;
    volatile float result = x / y;
    return result;
}

constexpr float kSmallest = 0x1p-126f; // of the normal numbers

class FpEnvironmentTest : public testing::Test {
protected:
    void SetUp() override { std::fegetenv(&found_); }
    void TearDown() override { std::fesetenv(&found_); }

private:
    std::fenv_t found_;
};

TEST_F(FpEnvironmentTest, RoundsToNearestAndRestoresTheMode) {
    const float nearest = quotient(1, 3);
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        ASSERT_EQ(std::fesetround(mode), 0);
        const float before = quotient(1, 3), tenth = quotient(1, 10);
        {
            const FpEnvironment standard;
            EXPECT_EQ(quotient(1, 3), nearest);
            EXPECT_EQ(quotient(-1, 3), -nearest);
        }
        EXPECT_EQ(std::fegetround(), mode);
        EXPECT_EQ(quotient(1, 3), before);
        EXPECT_EQ(quotient(1, 10), tenth);
    }
    // The check above means something only where the modes differ.
    std::fesetround(FE_UPWARD);
    const float upward = quotient(1, 3);
    std::fesetround(FE_DOWNWARD);
    EXPECT_NE(upward, quotient(1, 3));
}

TEST_F(FpEnvironmentTest, LeavesRaisedAndClearFlagsAsTheyWere) {
    std::feclearexcept(FE_ALL_EXCEPT);
    {
        const FpEnvironment standard;
        quotient(1, 0);
        quotient(1, 3);
    }
    EXPECT_EQ(std::fetestexcept(FE_ALL_EXCEPT), 0);

    quotient(3e38f, 1e-30f); // overflow
    const int raised = std::fetestexcept(FE_ALL_EXCEPT);
    ASSERT_NE(raised, 0);
    {
        const FpEnvironment standard;
        quotient(0, 0);
    }
    EXPECT_EQ(std::fetestexcept(FE_ALL_EXCEPT), raised);
}

TEST_F(FpEnvironmentTest, Nests) {
    const float nearest = quotient(2, 3);
    std::fesetround(FE_DOWNWARD);
    const float downward = quotient(2, 3);
    ASSERT_NE(nearest, downward);
    {
        const FpEnvironment outer;
        { const FpEnvironment inner; }
        EXPECT_EQ(quotient(2, 3), nearest);
    }
    EXPECT_EQ(quotient(2, 3), downward);
}

#if defined(__SSE2__)
TEST_F(FpEnvironmentTest, KeepsSubnormalNumbersWhateverTheApplicationSet) {
    constexpr unsigned kFlushAndDaz = 0x8040;
    const unsigned state = _mm_getcsr() | kFlushAndDaz;
    _mm_setcsr(state);
    ASSERT_EQ(quotient(kSmallest, 2), 0) << "control: the application's setting has an effect";
    {
        const FpEnvironment standard;
        EXPECT_EQ(quotient(kSmallest, 2), 0x1p-127f);
        EXPECT_EQ(quotient(0x1p-149f, 0x1p-149f), 1);
    }
    EXPECT_EQ(_mm_getcsr() & kFlushAndDaz, kFlushAndDaz);
}

TEST_F(FpEnvironmentTest, MasksTrapsAndRestoresThem) {
    const unsigned trapping = 0x1F80u & ~(_MM_MASK_DIV_ZERO | _MM_MASK_INVALID);
    _mm_setcsr(trapping);
    {
        const FpEnvironment standard;
        quotient(1, 0); // would be a signal
        quotient(0, 0);
    }
    EXPECT_EQ(_mm_getcsr(), trapping);
}
#endif

} // namespace
} // namespace smart
