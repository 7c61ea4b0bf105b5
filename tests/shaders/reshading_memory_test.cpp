// SPDX-License-Identifier: MIT
// What a reshaded instance costs: RT_STAT_BYTES against what was taken from the allocator, in a
// program that counts every allocation of itself and of the library.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <vector>

#include "openrt/rt.h"

namespace {

std::atomic<int64_t> liveBytes{0};

/// Before each block: where it was taken from, and its size.
struct Header {
    void* taken;
    std::size_t bytes;
};

void* allocate(std::size_t bytes, std::size_t alignment) {
    alignment = std::max(alignment, alignof(std::max_align_t));
    const std::size_t before = (sizeof(Header) + alignment - 1) / alignment * alignment;
    const std::size_t size = (before + bytes + alignment - 1) / alignment * alignment;
    void* const taken = std::aligned_alloc(alignment, size);
    if (!taken) throw std::bad_alloc();
    char* const block = static_cast<char*>(taken) + before;
    *(reinterpret_cast<Header*>(block) - 1) = {taken, bytes};
    liveBytes += int64_t(bytes);
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
// Those of arrays call these, but not where a sanitizer has its own.
void* operator new[](std::size_t bytes) { return allocate(bytes, 1); }
void* operator new[](std::size_t bytes, std::align_val_t alignment) {
    return allocate(bytes, std::size_t(alignment));
}
void operator delete[](void* block) noexcept { release(block); }
void operator delete[](void* block, std::size_t) noexcept { release(block); }
void operator delete[](void* block, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept { release(block); }
void operator delete(void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }

namespace {

constexpr int kInstances = 1000;
constexpr int kRows = 158, kColumns = 160; ///< 50,560 triangles

/// A hilly field with two shaders.
RTuint makeField(RTuint low, RTuint high) {
    const RTuint object = rtNewObject(RT_DEFINE);
    for (int row = 0; row < kRows; ++row) {
        rtBindShader(row % 2 ? low : high);
        rtBegin(RT_TRIANGLE_STRIP);
        for (int i = 0; i <= kColumns; ++i)
            for (int side = 0; side < 2; ++side) {
                const double x = double(i) / kColumns, y = double(row + side) / kRows;
                rtNormal3d(0, 0, 1);
                rtVertex3d(x, y, 0.05 * std::sin(20 * x) * std::cos(17 * y));
            }
        rtEnd();
    }
    rtEndObject();
    return object;
}

struct Held {
    int64_t reported, allocated;
};

/// Bytes while a compiled scene with so many instances of the object, and nothing else, is held.
Held heldWith(int instances, RTuint object, const std::vector<RTuint>& shaders) {
    for (int i = 0; i < instances; ++i) {
        rtPushMatrix();
        rtTranslated(i % 32, i / 32, 0);
        rtInstantiateObjectShaders(object, RTsizei(shaders.size()), shaders.data());
        rtPopMatrix();
    }
    const RTuint scene = rtCompileScene();
    rtRender(); // the frame is gone after it, and the instances that it was given
    RTint64 reported = 0;
    rtGetInteger64v(RT_STAT_BYTES, &reported);
    const Held held{reported, liveBytes};
    rtReleaseScene(scene);
    return held;
}

TEST(ReshadingMemory, AReshadedInstanceCostsWhatIsReported) {
    static float pixels[16 * 16 * 4];
    rtInit(nullptr, nullptr);
    rtThreads(1);
    rtSetFrameBuffer(reinterpret_cast<RTubyte*>(pixels), 16, 16, RT_RGBA_32F);
    rtMatrixMode(RT_PROJECTION);
    rtOrtho(0, 32, 0, 32, -10, 10);
    rtMatrixMode(RT_MODELVIEW);
    rtGenNewShaderClass("ConstantShader", nullptr);
    std::vector<RTuint> shaders;
    for (int i = 0; i < 4; ++i) shaders.push_back(rtGenNewShader());

    RTint64 reportedBefore = 0;
    rtGetInteger64v(RT_STAT_BYTES, &reportedBefore);
    const int64_t allocatedBefore = liveBytes;
    const RTuint object = makeField(shaders[0], shaders[1]);
    RTint64 reportedModel = 0;
    rtGetInteger64v(RT_STAT_BYTES, &reportedModel);
    const double model = double(reportedModel - reportedBefore);
    const double modelAllocated = double(liveBytes - allocatedBefore);
    EXPECT_GT(model, 50'000 * 36.0) << "the control: it holds its triangles";
    EXPECT_NEAR(model / modelAllocated, 1, 0.02);

    // Buffers that stay reach their size with the larger frame; the smaller is measured after it.
    const std::vector<RTuint> set{shaders[2], shaders[3]};
    heldWith(kInstances + 1, object, set);
    const Held one = heldWith(1, object, set);
    const Held many = heldWith(kInstances + 1, object, set);
    const double reported = double(many.reported - one.reported) / kInstances;
    const double allocated = double(many.allocated - one.allocated) / kInstances;
    RecordProperty("bytes_reported", int(reported));
    RecordProperty("bytes_allocated", int(allocated));
    EXPECT_GT(allocated, 100) << "the control: the library's allocations are counted";
    EXPECT_NEAR(reported / allocated, 1, 0.02) << reported << " reported, " << allocated;
    EXPECT_LT(reported, model / 1000) << "no triangle was copied";

    // The whole of it: what all the instances take is less than what the model does.
    EXPECT_LT(reported * kInstances, model);
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
    rtExit();
}

} // namespace
