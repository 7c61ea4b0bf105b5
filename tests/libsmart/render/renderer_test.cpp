// SPDX-License-Identifier: MIT
#include "libsmart/render/renderer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <vector>

#include "tests/libsmart/render/picture_scene.h"

namespace smart::test {
namespace {

ScenePtr sphereScene() {
    const glm::dmat4 away = glm::translate(glm::dmat4(1.0), {0, 0, -3.0});
    return makeScene({placeWithShader(makeModel(icosphere(4)), 0, glm::dmat4x3(away))});
}

std::shared_ptr<const ShaderObject> busyShader() {
    return makeSurface([](RTSstate* s) {
        float left[3], radiance[3];
        const float light[3] = {1, 1, 1};
        rtsShadow(s, s->position, light, 10.0f, left);
        rtsTraceRay(s, s->position, s->rayDirection, 0.5f, radiance);
        rtsResultColor(s, left[0] * s->shadingNormal[0], s->functions->random(s),
                       radiance[0] + s->position[2]);
        return 0;
    });
}

TEST(Renderer, SubmitReturnsWhileTheFrameIsStillTraced) {
    std::latch go(1);
    std::atomic<bool> finished{false};
    Picture picture(64, 64, sphereScene(), {makeSurface([&](RTSstate* s) {
                        go.wait();
                        rtsResultColor(s, 1, 1, 1);
                        finished = true;
                        return 0;
                    })});
    Renderer renderer(2);
    const QueuedFramePtr queued = renderer.prepare(picture.frame);
    renderer.submit(queued);
    EXPECT_FALSE(finished); // every ray that hits waits for what comes next
    EXPECT_LT(queued->progress(), 1.0f);
    go.count_down();
    EXPECT_EQ(queued->wait(), FrameStatus::Done);
    EXPECT_TRUE(finished);
    EXPECT_EQ(queued->progress(), 1.0f);
    EXPECT_EQ(picture.at(32, 32), glm::vec4(1));
}

TEST(Renderer, TheSameBitsForAnyNumberOfThreads) {
    const ScenePtr scene = sphereScene();
    const auto shader = busyShader();
    Picture alone(333, 211, scene, {shader});
    const RenderStatistics expected = renderHere(alone);
    EXPECT_GT(expected.shadowRays, 0u);
    EXPECT_EQ(expected.shadowRays, expected.secondaryRays);
    Renderer renderer(1);
    EXPECT_EQ(renderer.threads(), 1u);
    RenderStatistics before;
    for (const unsigned threads : {1u, 2u, 3u, 8u}) {
        renderer.setThreads(threads);
        EXPECT_EQ(renderer.threads(), threads);
        Picture picture(333, 211, scene, {shader});
        renderer.submit(renderer.prepare(picture.frame));
        renderer.waitAll();
        EXPECT_EQ(picture.pixels, alone.pixels) << threads;
        EXPECT_EQ(picture.distance, alone.distance) << threads;
        const RenderStatistics now = renderer.statistics();
        EXPECT_EQ(now.primaryRays - before.primaryRays, expected.primaryRays);
        EXPECT_EQ(now.shadowRays - before.shadowRays, expected.shadowRays);
        EXPECT_EQ(now.secondaryRays - before.secondaryRays, expected.secondaryRays);
        before = now;
    }
}

TEST(Renderer, QueuedFramesAreFinishedBeforeItsEnd) {
    const ScenePtr scene = sphereScene();
    const auto shader = busyShader();
    std::vector<Picture> pictures;
    for (uint64_t id = 1; id <= 8; ++id) {
        pictures.emplace_back(100, 100, scene,
                              std::vector<std::shared_ptr<const ShaderObject>>{shader});
        pictures.back().frame->id = id;
    }
    {
        Renderer renderer(3);
        for (const Picture& picture : pictures) renderer.submit(renderer.prepare(picture.frame));
    }
    for (const Picture& picture : pictures) EXPECT_EQ(picture.pixels, pictures[0].pixels);
    EXPECT_NE(pictures[0].pixels[0], glm::vec4(-1.0f));
}

TEST(Renderer, ZeroThreadsMeansAllCores) {
    EXPECT_GE(Renderer(0).threads(), 1u);
    Renderer renderer(5);
    renderer.setThreads(0);
    EXPECT_EQ(renderer.threads(), Renderer().threads());
}

TEST(Renderer, ChangingTheThreadsWaitsForFramesInFlight) {
    const ScenePtr scene = sphereScene();
    Picture first(200, 200, scene, {busyShader()}), second(200, 200, scene, {busyShader()});
    Renderer renderer(2);
    renderer.setDepth(5);
    EXPECT_EQ(renderer.depth(), 5u);
    const QueuedFramePtr a = renderer.prepare(first.frame), b = renderer.prepare(second.frame);
    renderer.submit(a);
    renderer.submit(b);
    renderer.setThreads(1);
    EXPECT_TRUE(a->ended() && b->ended());
    EXPECT_EQ(first.pixels, second.pixels);
}

TEST(Renderer, PicturesWithoutPixels) {
    Renderer renderer(2);
    Picture empty(0, 7, sphereScene(), {busyShader()});
    renderer.submit(renderer.prepare(empty.frame));
    renderer.waitAll();
    EXPECT_EQ(renderer.statistics().primaryRays, 0u);
}

} // namespace
} // namespace smart::test
