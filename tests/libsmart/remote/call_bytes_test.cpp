// SPDX-License-Identifier: MIT
#include "libsmart/remote/call_bytes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "libsmart/base/error.h"

namespace smart {
namespace {

TEST(CallBytes, CallsArriveWholeHoweverTheStreamIsCut) {
    std::mt19937 random(7);
    for (int run = 0; run < 50; ++run) {
        std::vector<std::vector<std::byte>> calls(30);
        std::vector<std::byte> stream;
        for (auto& call : calls) {
            call.resize(random() % (run % 5 == 0 ? 5000 : 20));
            for (std::byte& b : call) b = std::byte(random());
            appendCall(stream, call);
        }
        CallAssembler assembler;
        std::vector<std::byte> call;
        std::size_t taken = 0;
        for (std::size_t begin = 0; begin < stream.size();) {
            const std::size_t count = std::min<std::size_t>(random() % 700, stream.size() - begin);
            assembler.add(std::span(stream).subspan(begin, count));
            begin += count;
            while (assembler.take(call)) {
                ASSERT_LT(taken, calls.size());
                EXPECT_EQ(call, calls[taken++]);
            }
        }
        EXPECT_EQ(taken, calls.size());
    }
}

TEST(CallBytes, ALengthThatCanNotBeIsRefused) {
    CallAssembler assembler;
    assembler.add(std::vector<std::byte>(8, std::byte(0xFF)));
    std::vector<std::byte> call;
    EXPECT_THROW(assembler.take(call), Error);
}

} // namespace
} // namespace smart
