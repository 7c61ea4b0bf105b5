// SPDX-License-Identifier: MIT
// RT_STAT_BYTES against what was taken from the allocator, in a program that counts every
// allocation of itself and of the library; what lazy objects cost before a ray reaches them; and
// what happens when memory runs out while a tree is built.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "openrt/rt.h"

namespace {

std::atomic<int64_t> liveBytes{0}, peakBytes{0};
/// Allocations of at least this size fail, on every thread.
std::atomic<std::size_t> failingSize{SIZE_MAX};

/// Before each block: where it was taken from, and its size.
struct Header {
    void* taken;
    std::size_t bytes;
};

void* allocate(std::size_t bytes, std::size_t alignment) {
    if (bytes >= failingSize.load(std::memory_order_relaxed)) throw std::bad_alloc();
    alignment = std::max(alignment, alignof(std::max_align_t));
    const std::size_t before = (sizeof(Header) + alignment - 1) / alignment * alignment;
    const std::size_t size = (before + bytes + alignment - 1) / alignment * alignment;
    void* const taken = std::aligned_alloc(alignment, size);
    if (!taken) throw std::bad_alloc();
    char* const block = static_cast<char*>(taken) + before;
    *(reinterpret_cast<Header*>(block) - 1) = {taken, bytes};
    const int64_t live = liveBytes += int64_t(bytes);
    int64_t peak = peakBytes.load();
    while (live > peak && !peakBytes.compare_exchange_weak(peak, live)) {
    }
    return block;
}
void release(void* block) noexcept {
    if (!block) return;
    const Header header = *(static_cast<Header*>(block) - 1);
    liveBytes -= int64_t(header.bytes);
    std::free(header.taken);
}

} // namespace

void* operator new(std::size_t bytes) { return allocate(bytes, 1); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return allocate(bytes, std::size_t(alignment));
}
void* operator new[](std::size_t bytes) { return allocate(bytes, 1); }
void* operator new[](std::size_t bytes, std::align_val_t alignment) {
    return allocate(bytes, std::size_t(alignment));
}
void operator delete(void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block) noexcept { release(block); }
void operator delete[](void* block, std::size_t) noexcept { release(block); }
void operator delete[](void* block, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept { release(block); }

namespace {

constexpr int kRows = 100, kColumns = 100, kTriangles = 2 * kRows * kColumns;

struct Attributes {
    bool normals = false, texCoords = false, colors = false;
};

/// A hilly field of strips.
void giveField(const Attributes& attributes, float height) {
    for (int row = 0; row < kRows; ++row) {
        rtBegin(RT_TRIANGLE_STRIP);
        for (int i = 0; i <= kColumns; ++i)
            for (int side = 0; side < 2; ++side) {
                const float x = float(i) / kColumns, y = float(row + side) / kRows;
                if (attributes.normals) rtNormal3f(0, x, 1);
                if (attributes.texCoords) rtTexCoord2f(x, y);
                if (attributes.colors) rtColor3f(x, y, 1);
                rtVertex3f(x, y, height * std::sin(20 * x) * std::cos(17 * y));
            }
        rtEnd();
    }
}
RTuint makeField(const Attributes& attributes = {}, float height = 0.05f) {
    const RTuint object = rtNewObject(RT_DEFINE);
    giveField(attributes, height);
    rtEndObject();
    return object;
}
std::vector<RTfloat> fieldPositions(float height) {
    std::vector<RTfloat> xyz;
    for (int row = 0; row < kRows; ++row)
        for (int i = 0; i <= kColumns; ++i)
            for (int side = 0; side < 2; ++side) {
                const float x = float(i) / kColumns, y = float(row + side) / kRows;
                xyz.insert(xyz.end(), {x, y, height * std::sin(20 * x) * std::cos(17 * y)});
            }
    return xyz;
}

double statistic(RTenum name) {
    RTdouble value = 0;
    rtGetDoublev(name, &value);
    return value;
}

bool hasRenderingThreads() {
    std::error_code ended; // a thread may, at any moment
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", ended)) {
        std::string name;
        std::getline(std::ifstream(task.path() / "comm"), name);
        if (name.starts_with("openrt-")) return true;
    }
    return false;
}

class ObjectMemory : public ::testing::Test {
protected:
    void SetUp() override {
        context_ = rtCreateContext();
        rtMakeCurrent(context_);
        rtThreads(2);
        rtSetFrameBuffer(pixels_, kSize, kSize, RT_RGBA_8);
        picture(rtNewObject(RT_DEFINE), true); // starts the threads
    }
    void TearDown() override {
        EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
        rtDestroyContext(context_);
    }
    /// Idle threads leave after a while, with their memory: what takes long is measured without them.
    static void awaitThreadsLeaving() {
        for (int i = 0; i < 6000 && hasRenderingThreads(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        ASSERT_FALSE(hasRenderingThreads());
    }
    /// Of the field from above; returns how many pixels differ from the background.
    int picture(RTuint object, bool open = false) {
        if (open) rtEndObject();
        rtMatrixMode(RT_PROJECTION);
        rtLoadIdentity();
        rtOrtho(0, 1, 0, 1, -1, 1);
        rtMatrixMode(RT_MODELVIEW);
        rtClear(RT_COLOR_BUFFER_BIT | RT_DEPTH_BUFFER_BIT);
        rtInstantiateObject(object);
        rtRender();
        int covered = 0;
        for (int i = 0; i < kSize * kSize; ++i) covered += pixels_[4 * i] != 0;
        return covered;
    }
    static RTuint sceneOf(RTuint object) {
        const RTuint open = rtGenScene();
        rtBindScene(open);
        rtInstantiateObject(object);
        const RTuint compiled = rtCompileScene();
        rtDeleteScene(open);
        return compiled;
    }
    static void expectAgreement(double reported, double allocated, const char* what) {
        EXPECT_NEAR(reported / allocated, 1, 0.02)
            << what << ": " << reported << " reported, " << allocated << " allocated";
    }

    static constexpr int kSize = 32;
    RTubyte pixels_[4 * kSize * kSize] = {};
    RTcontext context_ = nullptr;
};

TEST_F(ObjectMemory, ReportedBytesAreThoseAllocated) {
    awaitThreadsLeaving();
    const struct {
        const char* name;
        Attributes attributes;
    } kinds[] = {{"positions", {}},
                 {"+ normals", {true, false, false}},
                 {"+ texture coordinates", {true, true, false}},
                 {"+ colours", {true, true, true}}};
    const struct {
        const char* name;
        RTenum value;
    } qualities[] = {{"nicest", RT_NICEST},
                     {"left to it", RT_DONT_CARE},
                     {"fastest", RT_FASTEST},
                     {"kd-tree", RT_KD_TREE}};
    for (const auto& quality : qualities) {
        rtObjectHint(RT_BUILD_QUALITY, quality.value);
        for (const auto& kind : kinds) {
            const double reportedBefore = statistic(RT_STAT_BYTES);
            const int64_t before = liveBytes;
            peakBytes = before;
            const RTuint object = makeField(kind.attributes);
            const double allocated = double(liveBytes - before);
            const double reported = statistic(RT_STAT_BYTES) - reportedBefore;
            const double peak = double(peakBytes - before);
            expectAgreement(reported, allocated, kind.name);
            // A thousand instances of it.
            const RTuint open = rtGenScene();
            rtBindScene(open);
            for (int i = 0; i < 1000; ++i) {
                rtPushMatrix();
                rtTranslatef(float(i), 0, 0);
                rtInstantiateObject(object);
                rtPopMatrix();
            }
            const double withoutScene = statistic(RT_STAT_BYTES);
            const int64_t beforeScene = liveBytes;
            const RTuint scene = rtCompileScene();
            const double ofScene = statistic(RT_STAT_BYTES) - withoutScene;
            expectAgreement(ofScene, double(liveBytes - beforeScene), "instances");
            std::printf("%-11s %-22s %6.1f bytes a triangle, %6.1f at most while it was built, "
                        "%5.0f bytes an instance\n",
                        quality.name, kind.name, reported / kTriangles, peak / kTriangles,
                        ofScene / 1000);
            EXPECT_LT(ofScene / 1000, 200);
            rtReleaseScene(scene);
            rtDeleteScene(open);
            rtRemoveObject(object);
        }
    }
}

TEST_F(ObjectMemory, WhatFramesAddIsCountedAndGivenBack) {
    awaitThreadsLeaving();
    rtObjectHint(RT_BUILD_QUALITY, RT_NICEST);
    const double reportedBefore = statistic(RT_STAT_BYTES);
    const int64_t before = liveBytes;
    const RTuint object = makeField();
    const double plain = statistic(RT_STAT_BYTES) - reportedBefore;
    rtHint(RT_PRECISION_HINT, RT_FASTEST); // its records
    RTuint scene = sceneOf(object);
    rtReleaseScene(scene);
    const double records = statistic(RT_STAT_BYTES) - reportedBefore;
    EXPECT_GE(records, plain + 40.0 * kTriangles);
    rtHint(RT_PRECISION_HINT, RT_DONT_CARE);
    scene = sceneOf(object); // rays add nothing
    const std::vector<RTray> rays(2 * kTriangles, RTray{{0.5f, 0.5f, 1}, 0, {0, 0, -1}, 10});
    std::vector<RThit> hits(rays.size());
    rtIntersect(scene, rays.data(), hits.data(), RTsizei(rays.size()), RT_COHERENT);
    std::vector<RThit>().swap(hits);
    rtReleaseScene(scene);
    awaitThreadsLeaving();
    const double all = statistic(RT_STAT_BYTES) - reportedBefore;
    EXPECT_EQ(all, records) << "an object has one tree";
    const double allocated = double(liveBytes - before) - double(rays.capacity() * sizeof(RTray));
    expectAgreement(all, allocated, "with records");
    rtRemoveObject(object);
    EXPECT_LT(statistic(RT_STAT_BYTES) - reportedBefore, 0.01 * all);
}

TEST_F(ObjectMemory, AnUpdateSharesWhatStays) {
    awaitThreadsLeaving();
    rtObjectHint(RT_BUILD_QUALITY, RT_FASTEST);
    const double reportedBefore = statistic(RT_STAT_BYTES);
    const RTuint object = makeField({true, true, true});
    const double one = statistic(RT_STAT_BYTES) - reportedBefore;
    const RTuint scene = sceneOf(object); // keeps the old model
    const std::vector<RTfloat> xyz = fieldPositions(0.06f);
    const double withScene = statistic(RT_STAT_BYTES);
    const int64_t before = liveBytes;
    rtUpdateObject(object, 0, RTsizei(xyz.size() / 3), xyz.data());
    const double more = statistic(RT_STAT_BYTES) - withScene;
    expectAgreement(more, double(liveBytes - before), "what an update adds");
    const double attributes = (kRows * 2.0 * (kColumns + 1)) * (12 + 16 + 16);
    EXPECT_NEAR(more, one - attributes, 0.1 * more) << "attributes are shared";
    rtReleaseScene(scene);
}

TEST_F(ObjectMemory, LazyObjectsHaveNoTreeUntilARayComes) {
    rtThreads(1); // a thread that gets its first tile now would allocate what it works with
    rtObjectHint(RT_LAZY_BUILD, RT_TRUE);
    const double before = statistic(RT_STAT_BYTES);
    const RTuint seen = makeField(), unseen = makeField();
    const double two = statistic(RT_STAT_BYTES) - before;
    EXPECT_LT(two, 2 * 40.0 * kTriangles) << "triangles, 36 bytes each, and little more";
    rtPushMatrix();
    rtTranslatef(5, 0, 0);
    rtInstantiateObject(unseen);
    rtPopMatrix();
    EXPECT_GT(picture(seen), kSize * kSize / 2);
    const double after = statistic(RT_STAT_BYTES) - before;
    EXPECT_GT(after, two + 30.0 * kTriangles) << "one tree";
    const int64_t live = liveBytes;
    EXPECT_GT(picture(unseen), kSize * kSize / 2);
    EXPECT_NEAR(double(liveBytes - live), after - two, 0.05 * after) << "the other one";
}

TEST_F(ObjectMemory, WithoutMemoryTheOldObjectStays) {
    const RTuint object = makeField({}, 0.05f);
    const std::vector<RTfloat> xyz = fieldPositions(0.5f);
    const RTray ray = {{0.08f, 0.0005f, 5}, 0, {0, 0, -1}, 10};
    const auto heightOf = [&] {
        const RTuint scene = sceneOf(object);
        RThit hit;
        rtIntersect(scene, &ray, &hit, 1, RT_INCOHERENT);
        rtReleaseScene(scene);
        return 5 - hit.t;
    };
    const float height = heightOf();
    const double bytes = statistic(RT_STAT_BYTES);
    int failures = 0;
    // The sizes that building takes, the largest last.
    for (std::size_t size = 1 << 12;; size *= 2) {
        failingSize = size;
        rtUpdateObject(object, 0, RTsizei(xyz.size() / 3), xyz.data());
        failingSize = SIZE_MAX;
        if (rtGetError() == RTenum(RT_NO_ERROR)) break;
        ++failures;
        EXPECT_EQ(heightOf(), height);
        EXPECT_EQ(statistic(RT_STAT_BYTES), bytes);
    }
    EXPECT_GE(failures, 5) << "control: allocations do fail";
    EXPECT_GT(heightOf(), 5 * height);

    // The same for an object defined anew.
    failures = 0;
    rtReplaceObject(object);
    giveField({}, 0.1f);
    for (std::size_t size = 1 << 12;; size *= 2) {
        failingSize = size;
        rtEndObject();
        failingSize = SIZE_MAX;
        if (rtGetError() == RTenum(RT_NO_ERROR)) break;
        ++failures;
    }
    EXPECT_GE(failures, 5);
    EXPECT_NEAR(heightOf(), 2 * height, 1e-3f);
}

TEST_F(ObjectMemory, WithoutMemoryALazyBuildFailsTheFrameAndCanBeTriedAgain) {
    rtObjectHint(RT_LAZY_BUILD, RT_TRUE);
    const RTuint object = makeField();
    failingSize = 16 * 1024; // below what any builder takes, above what a frame does
    picture(object);
    failingSize = SIZE_MAX;
    EXPECT_EQ(rtGetError(), RTenum(RT_OUT_OF_MEMORY));
    const RTuint scene = sceneOf(object);
    const RTray ray = {{0.5f, 0.5f, 5}, 0, {0, 0, -1}, 10};
    RThit hit;
    failingSize = 16 * 1024;
    rtIntersect(scene, &ray, &hit, 1, RT_INCOHERENT);
    failingSize = SIZE_MAX;
    EXPECT_EQ(rtGetError(), RTenum(RT_OUT_OF_MEMORY));
    rtIntersect(scene, &ray, &hit, 1, RT_INCOHERENT);
    EXPECT_NEAR(hit.t, 5, 0.1);
    EXPECT_GT(picture(object), kSize * kSize / 2);
    rtReleaseScene(scene);
}

TEST_F(ObjectMemory, ADrawingWithoutMemoryLeavesTheCurrentValues) {
    const std::vector<RTfloat> corners(3 * 9000, 0.25f);
    rtVertexPointer(3, RT_FLOAT, 0, corners.data());
    rtColorPointer(3, RT_FLOAT, 0, corners.data());
    rtEnableClientState(RT_VERTEX_ARRAY);
    rtEnableClientState(RT_COLOR_ARRAY);
    rtColor3f(0, 1, 0);
    for (const bool listed : {false, true}) {
        if (listed) rtNewList(1, RT_COMPILE_AND_EXECUTE);
        failingSize = 64 * 1024; // some vertices fit
        rtDrawArrays(RT_TRIANGLES, 0, 9000);
        failingSize = SIZE_MAX;
        EXPECT_EQ(rtGetError(), RTenum(RT_OUT_OF_MEMORY));
        RTfloat color[4];
        rtGetFloatv(RT_CURRENT_COLOR, color);
        EXPECT_EQ(color[0], 0);
        EXPECT_EQ(color[1], 1);
        rtBegin(RT_TRIANGLES); // the one before has ended
        rtEnd();
        EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
    }
    rtEndList(); // has half a drawing
    EXPECT_EQ(rtGetError(), RTenum(RT_OUT_OF_MEMORY));
    EXPECT_FALSE(rtIsList(1));
}

TEST_F(ObjectMemory, TenThousandRedefinitionsTakeNoMemory) {
    awaitThreadsLeaving();
    const RTuint object = rtNewObject(RT_DEFINE);
    rtEndObject();
    const RTuint updated = rtNewObject(RT_DEFINE);
    rtBegin(RT_TRIANGLES);
    for (int i = 0; i < 12; ++i) rtVertex3f(float(i % 3), float(i % 2), float(i));
    rtEnd();
    rtEndObject();
    int64_t live = 0;
    double reported = 0;
    for (int round = 0; round < 10100; ++round) {
        rtReplaceObject(object);
        rtBegin(RT_TRIANGLE_STRIP);
        for (int i = 0; i < 6; ++i) rtVertex3f(float(i % 2), float(i / 2), float(round % 7));
        rtEnd();
        rtEndObject();
        const RTfloat to[6] = {float(round % 5), 0, 0, 1, float(round % 3), 0};
        rtUpdateObject(updated, 3, 2, to);
        if (round == 100) {
            live = liveBytes;
            reported = statistic(RT_STAT_BYTES);
        }
    }
    EXPECT_EQ(liveBytes, live);
    EXPECT_EQ(statistic(RT_STAT_BYTES), reported);
}

} // namespace
