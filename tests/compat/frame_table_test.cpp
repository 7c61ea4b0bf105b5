// SPDX-License-Identifier: MIT
#include "compat/recorder/frame_table.h"

#include <gtest/gtest.h>

#include <new>

#include "libsmart/render/frame_queue.h"
#include "libsmart/render/worker.h"

namespace smart::compat {
namespace {

/// Writes nothing; fails for frames of seed 1.
class Tracer final : public smart::Tracer {
public:
    void render(const Frame& frame, const Tile&, TilePixels&) const override {
        if (frame.seed == 1) throw std::bad_alloc();
    }
};

class FrameTableTest : public testing::Test {
protected:
    /// A frame of one tile, known to the table, and ended as wished.
    uint32_t add(FrameStatus end) {
        const auto frame = std::make_shared<Frame>();
        frame->target.width = frame->target.height = 4;
        frame->seed = end == FrameStatus::Failed;
        const QueuedFramePtr queued = queue_.prepare(frame);
        const uint32_t id = table_.add(*frame, queued);
        EXPECT_EQ(frame->id, id);
        if (end == FrameStatus::Queued) return id;
        if (end == FrameStatus::Cancelled) queued->cancel();
        queue_.submit(queued);
        queue_.close();
        work(queue_, Tracer());
        queue_.open();
        EXPECT_EQ(queued->status(), end);
        return id;
    }

    FrameTable table_;
    FrameQueue queue_;
};

TEST_F(FrameTableTest, IdsCountFromOneAndUnknownOnesAreNotFound) {
    EXPECT_FALSE(table_.find(0));
    EXPECT_FALSE(table_.find(1));
    EXPECT_EQ(add(FrameStatus::Done), 1u);
    EXPECT_EQ(add(FrameStatus::Queued), 2u);
    ASSERT_TRUE(table_.find(1) && table_.find(2));
    EXPECT_EQ(table_.find(1)->status, FrameStatus::Done);
    EXPECT_EQ(table_.find(2)->status, FrameStatus::Queued);
    EXPECT_FALSE(table_.find(3));
    EXPECT_FALSE(table_.find(FrameTable::kNoId));
}

// Far more frames than are remembered: of all of them it stays known how they ended.
TEST_F(FrameTableTest, OutcomesStayKnown) {
    const auto outcome = [](uint32_t id) {
        return id % 7 == 3      ? FrameStatus::Cancelled
               : id % 11 == 5   ? FrameStatus::Failed
               : id % 1000 == 0 ? FrameStatus::Queued
                                : FrameStatus::Done;
    };
    constexpr uint32_t kFrames = 5000;
    for (uint32_t id = 1; id <= kFrames; ++id) ASSERT_EQ(add(outcome(id)), id);
    for (uint32_t id = 1; id <= kFrames; ++id) {
        const auto known = table_.find(id);
        ASSERT_TRUE(known);
        ASSERT_EQ(known->status, outcome(id)) << id;
        if (id + FrameTable::kRemembered > kFrames || outcome(id) == FrameStatus::Queued) {
            ASSERT_TRUE(known->frame) << id;
        } else if (id + 3 * FrameTable::kRemembered < kFrames) {
            ASSERT_FALSE(known->frame) << id; // no record for each
        }
    }
}

TEST_F(FrameTableTest, ForgottenIdsMeanNothingAndAreNotUsedAgain) {
    add(FrameStatus::Done);
    add(FrameStatus::Cancelled);
    table_.forgetAll();
    EXPECT_FALSE(table_.find(1) || table_.find(2));
    EXPECT_EQ(add(FrameStatus::Done), 3u);
    EXPECT_TRUE(table_.find(3));
    EXPECT_FALSE(table_.find(2));
}

} // namespace
} // namespace smart::compat
