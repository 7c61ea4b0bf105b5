// SPDX-License-Identifier: MIT
// Tiles that are given back, and answered late or not at all.
#include <gtest/gtest.h>

#include <atomic>
#include <list>
#include <random>
#include <thread>
#include <vector>

#include "libsmart/render/stored_tile.h"
#include "tests/libsmart/render/fake_frames.h"

namespace smart::test {
namespace {

TileJob remoteJob() {
    TileJob job;
    job.remote = true;
    job.claim = std::make_shared<TileClaim>();
    return job;
}

/// A tile as FakeTracer colours it, stored.
class Answer {
public:
    Answer(const PixelTarget& target, const Tile& tile, uint64_t frameId, float error = 0) {
        const auto pixels = std::make_unique<TilePixels>();
        Frame frame;
        frame.id = frameId;
        FakeTracer().render(frame, tile, *pixels);
        for (glm::vec4& color : pixels->color) color += error;
        bytes_.resize(storedTileSize(target, tile));
        storeTile(target, tile, *pixels, bytes_.data());
        tile_.bytes = bytes_.data();
        tile_.primaryRays = pixels->primaryRays;
    }
    const StoredTile& tile() const { return tile_; }

private:
    std::vector<std::byte> bytes_;
    StoredTile tile_;
};

TEST(SharedTiles, RemoteWorkersGetOnlyFramesThatAreOffered) {
    TestFrame first(1, 32, 32), second(2, 32, 32);
    FrameQueue queue(2);
    submit(queue, first);
    const QueuedFramePtr offered = submit(queue, second);
    queue.offer(*offered, true);
    TileJob job = remoteJob();
    ASSERT_TRUE(queue.next(job));
    EXPECT_EQ(job.frame->id, 2u);
    queue.answered(job, Answer(job.frame->target, job.tile, 2).tile());
    EXPECT_TRUE(isComplete(second));
    EXPECT_EQ(offered->statistics().primaryRays, 1024u);
    queue.close();
    TileJob other = remoteJob();
    EXPECT_FALSE(queue.next(other));
    TileJob own;
    const auto pixels = std::make_unique<TilePixels>();
    ASSERT_TRUE(queue.next(own));
    EXPECT_EQ(own.frame->id, 1u);
    queue.done(own, *pixels);
}

TEST(SharedTiles, WhatIsGivenBackIsHandedOutAgain) {
    TestFrame frame(1, 70, 40);
    FrameQueue queue(1);
    const QueuedFramePtr queued = submit(queue, frame);
    queue.offer(*queued, true);
    for (int i = 0; i < 4; ++i) { // of six tiles
        TileJob job = remoteJob();
        ASSERT_TRUE(queue.next(job));
        queue.returned(job);
    }
    EXPECT_EQ(queued->progress(), 0.0f);
    FakeTracer tracer;
    {
        Team team(2, queue, tracer);
        queued->wait();
    }
    EXPECT_TRUE(isComplete(frame));
    EXPECT_EQ(queued->statistics().primaryRays, 70u * 40u);
    EXPECT_EQ(queued->progress(), 1.0f);
}

TEST(SharedTiles, WhatIsGivenBackComesLast) {
    TestFrame frame(1, 70, 40); // six tiles
    FrameQueue queue(1);
    const QueuedFramePtr queued = submit(queue, frame);
    queue.offer(*queued, true);
    TileJob slow = remoteJob();
    ASSERT_TRUE(queue.next(slow));
    queue.returned(slow);
    const Answer answer(frame.frame->target, slow.tile, 1);
    const auto isSlow = [&](const TileJob& job) {
        return job.tile.x == slow.tile.x && job.tile.y == slow.tile.y;
    };
    for (const bool remote : {true, false, true, false, true, true}) {
        TileJob job = remote ? remoteJob() : TileJob();
        ASSERT_TRUE(queue.next(job));
        EXPECT_EQ(isSlow(job), queued->progress() > 0.8f);
        queue.answered(job, Answer(frame.frame->target, job.tile, 1).tile());
    }
    EXPECT_TRUE(queued->ended());
    EXPECT_TRUE(isComplete(frame));
}

TEST(SharedTiles, TheFirstAnswerCounts) {
    for (const bool lateIsFirst : {false, true}) {
        TestFrame frame(1, 32, 32);
        FrameQueue queue(1);
        const QueuedFramePtr queued = submit(queue, frame);
        queue.offer(*queued, true);
        TileJob slow = remoteJob();
        ASSERT_TRUE(queue.next(slow));
        queue.returned(slow);
        TileJob own;
        ASSERT_TRUE(queue.next(own));
        const Answer late(frame.frame->target, own.tile, 1, 0.5f); // to be told apart
        const auto pixels = std::make_unique<TilePixels>();
        FakeTracer().render(*frame.frame, own.tile, *pixels);
        if (lateIsFirst) queue.answered(slow, late.tile());
        EXPECT_FALSE(queued->ended()); // somebody is still at work on it
        queue.done(own, *pixels);
        EXPECT_TRUE(queued->ended());
        EXPECT_EQ(isComplete(frame), !lateIsFirst);
        const std::vector<float> before = frame.memory;
        frame.frame.reset();
        if (!lateIsFirst) queue.answered(slow, late.tile()); // the frame exists no more
        EXPECT_EQ(frame.memory, before);
        EXPECT_EQ(queued->statistics().primaryRays, 1024u); // counted once
    }
}

TEST(SharedTiles, AnsweredLateBeforeAnybodyElseBegan) {
    TestFrame frame(1, 32, 32);
    FrameQueue queue(1);
    const QueuedFramePtr queued = submit(queue, frame);
    queue.offer(*queued, true);
    TileJob slow = remoteJob();
    ASSERT_TRUE(queue.next(slow));
    queue.returned(slow);
    queue.answered(slow, Answer(frame.frame->target, slow.tile, 1).tile());
    std::atomic<int> traced{0};
    FakeTracer tracer([&](const Frame&, const Tile&) { ++traced; });
    {
        Team team(1, queue, tracer);
        EXPECT_EQ(queued->wait(), FrameStatus::Done);
    }
    EXPECT_TRUE(isComplete(frame));
    EXPECT_EQ(traced, 0);
}

TEST(SharedTiles, CancelledFramesEndWithoutThem) {
    TestFrame frame(1, 64, 64);
    FrameQueue queue(1);
    const QueuedFramePtr queued = submit(queue, frame);
    queue.offer(*queued, true);
    TileJob slow = remoteJob();
    ASSERT_TRUE(queue.next(slow));
    queued->cancel();
    queue.returned(slow);
    std::atomic<int> traced{0};
    FakeTracer tracer([&](const Frame&, const Tile&) { ++traced; });
    {
        Team team(1, queue, tracer);
        EXPECT_EQ(queued->wait(), FrameStatus::Cancelled);
    }
    EXPECT_EQ(traced, 0);
    const std::vector<float> before = frame.memory;
    queue.answered(slow, Answer(frame.frame->target, slow.tile, 1).tile());
    EXPECT_EQ(frame.memory, before);
}

// Remote workers of all kinds at once, at random: every frame is complete and every tile counted
// once.
TEST(SharedTiles, AnyOrderOfAnswersAndReturns) {
    constexpr uint64_t kFrames = 40;
    FrameQueue queue(3);
    FakeTracer tracer([](const Frame&, const Tile&) {
        std::this_thread::sleep_for(std::chrono::microseconds(20));
    });
    std::list<TestFrame> frames;
    std::vector<QueuedFramePtr> queued;
    uint64_t pixels = 0;
    {
        Team team(2, queue, tracer);
        std::vector<std::jthread> remote;
        for (unsigned seed = 0; seed < 3; ++seed)
            remote.emplace_back([&queue, seed] {
                std::mt19937 random(seed);
                struct Late {
                    TileJob job;
                    std::unique_ptr<Answer> answer;
                };
                std::list<Late> late;
                for (;;) {
                    TileJob job = remoteJob();
                    if (!queue.next(job)) break;
                    auto answer =
                        std::make_unique<Answer>(job.frame->target, job.tile, job.frame->id);
                    if (random() % 3 == 0) {
                        queue.answered(job, answer->tile());
                        continue;
                    }
                    queue.returned(job);
                    if (random() % 2 == 0) late.push_back({job, std::move(answer)});
                    while (!late.empty() && (late.size() > 9 || random() % 3 == 0)) {
                        queue.answered(late.front().job, late.front().answer->tile());
                        late.pop_front();
                    }
                }
                for (Late& l : late) queue.answered(l.job, l.answer->tile());
            });
        std::mt19937 random(9);
        for (uint64_t id = 1; id <= kFrames; ++id) {
            TestFrame& frame = frames.emplace_back(id, 1 + random() % 200, 1 + random() % 150);
            pixels += frame.memory.size() / 4;
            queued.push_back(queue.prepare(frame.frame));
            queue.offer(*queued.back(), true);
            queue.submit(queued.back());
        }
        for (const QueuedFramePtr& q : queued) EXPECT_EQ(q->wait(), FrameStatus::Done);
        queue.waitAll();
        queue.close();
    }
    for (const TestFrame& frame : frames) EXPECT_TRUE(isComplete(frame)) << frame.frame->id;
    EXPECT_EQ(queue.statistics().primaryRays, pixels);
}

TEST(SharedTiles, FramesRenderedElsewhereEndWhenTheyAreTold) {
    TestFrame a(1, 40, 40), b(2, 40, 40);
    FrameQueue queue(2);
    queue.renderElsewhere();
    const QueuedFramePtr first = submit(queue, a), second = submit(queue, b);
    EXPECT_EQ(first->status(), FrameStatus::Rendering);
    queue.endElsewhere(*second, true); // in order
    EXPECT_FALSE(second->ended());
    queue.endElsewhere(*first, false);
    EXPECT_EQ(first->wait(), FrameStatus::Cancelled);
    EXPECT_EQ(second->wait(), FrameStatus::Done);
    queue.waitAll();
}

TEST(StoredTile, IsPlacedAsIfItWereWritten) {
    std::mt19937 random(4);
    for (int run = 0; run < 60; ++run) {
        PixelTarget target;
        target.width = 1 + random() % 90;
        target.height = 1 + random() % 90;
        target.format = PixelFormat(random() % 6);
        target.srgb = random() % 2 == 0;
        const std::size_t count = std::size_t(target.width) * target.height;
        const std::size_t row = target.width * bytesPerPixel(target.format);
        target.stride = random() % 2 ? 0 : row + 12;
        const std::size_t bytes = (target.stride ? target.stride : row) * target.height;
        std::vector<std::byte> color[2] = {std::vector<std::byte>(bytes),
                                           std::vector<std::byte>(bytes)};
        std::vector<float> depth[2] = {std::vector<float>(count), std::vector<float>(count)};
        std::vector<float> normal[2] = {std::vector<float>(3 * count),
                                        std::vector<float>(3 * count)};
        std::vector<uint32_t> id[2] = {std::vector<uint32_t>(count), std::vector<uint32_t>(count)};
        const bool wanted[3] = {random() % 2 == 0, random() % 2 == 0, random() % 2 == 0};
        PixelTarget to[2] = {target, target};
        for (int k = 0; k < 2; ++k) {
            to[k].memory = color[k].data();
            if (wanted[0]) to[k].aux.depth = depth[k].data();
            if (wanted[1]) to[k].aux.normal = normal[k].data();
            if (wanted[2]) to[k].aux.objectId = id[k].data();
        }
        const Tile tile{uint32_t(random()) % target.width, uint32_t(random()) % target.height, 1,
                        1};
        Tile large = tile;
        large.width = std::min(32u, target.width - tile.x);
        large.height = std::min(32u, target.height - tile.y);
        const auto pixels = std::make_unique<TilePixels>();
        for (uint32_t i = 0; i < TilePixels::kCount; ++i) {
            pixels->color[i] = glm::vec4(float(random() % 999) / 900.0f);
            pixels->depth[i] = float(random());
            pixels->normal[i] = glm::vec3(float(random()));
            pixels->objectId[i] = random();
        }
        writeTile(to[0], large, *pixels);
        std::vector<std::byte> stored(storedTileSize(to[1], large));
        storeTile(to[1], large, *pixels, stored.data());
        placeTile(to[1], large, stored.data());
        EXPECT_EQ(color[0], color[1]);
        EXPECT_EQ(depth[0], depth[1]);
        EXPECT_EQ(normal[0], normal[1]);
        EXPECT_EQ(id[0], id[1]);
        std::vector<std::byte> gathered(stored.size());
        gatherTile(to[1], large, gathered.data());
        EXPECT_EQ(gathered, stored);
    }
}

} // namespace
} // namespace smart::test
