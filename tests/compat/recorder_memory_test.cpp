// SPDX-License-Identifier: MIT
// A program on the recorder in which each allocation of each step fails once: the step has to
// throw std::bad_alloc and change nothing, so that after trying again the outcome is that of a
// program in which nothing failed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <functional>
#include <new>
#include <optional>

#include "compat/recorder/display_lists.h"
#include "compat/recorder/recorder.h"

namespace {

/// Allocations of this thread until one fails; negative: none does.
thread_local long allocationsLeft = -1;

void* allocate(std::size_t bytes, std::size_t alignment) {
    if (allocationsLeft == 0) throw std::bad_alloc();
    if (allocationsLeft > 0) --allocationsLeft;
    void* const memory =
        std::aligned_alloc(alignment, (std::max(bytes, std::size_t(1)) + alignment - 1) &
                                          ~(alignment - 1));
    if (!memory) throw std::bad_alloc();
    return memory;
}

} // namespace

void* operator new(std::size_t bytes) { return allocate(bytes, alignof(std::max_align_t)); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return allocate(bytes, std::max(std::size_t(alignment), alignof(std::max_align_t)));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace smart::compat {
namespace {

float pixels[4 * 8 * 8];

struct Program {
    Recorder recorder;
    std::shared_ptr<const Frame> frame;
    ScenePtr query;
    uint32_t color = 0;

    std::vector<std::function<void()>> steps() {
        Recorder& r = recorder;
        std::vector<std::function<void()>> all;
        const auto step = [&](std::function<void()> action) { all.push_back(std::move(action)); };
        const auto square = [&](float x) {
            step([&r] { r.begin(Primitive::Quads); });
            for (const glm::dvec4& v : {glm::dvec4(x, 0, 0, 1), glm::dvec4(x + 1, 0, 0, 1),
                                        glm::dvec4(x + 1, 1, 0, 1), glm::dvec4(x, 1, 0, 1)})
                step([&r, v] { r.vertex(v); });
            step([&r] { r.end(); });
        };
        step([&r] {
            r.frameSettings().target.memory = pixels;
            r.frameSettings().target.width = r.frameSettings().target.height = 8;
            r.frameSettings().target.format = PixelFormat::Rgba32f;
        });
        step([&r] { r.shaders().addClass(findBuiltinClass("ConstantShader")); });
        step([this, &r] { color = r.shaders().parameterHandle("value"); });
        step([&r] { r.shaders().newShader(); });
        step([this, &r] {
            const float value[3] = {1, 2, 3};
            r.setParameter(color, {RTS_FLOAT3, std::as_bytes(std::span(value))});
        });
        step([&r] { r.newObject(ObjectMode::Define); });
        square(0);
        step([&r] { r.color({0.5f, 0.5f, 0.5f, 1}); });
        square(3);
        step([&r] { r.shaders().bindShader(0); });
        square(5);
        step([&r] { r.endObject(); });
        square(7); // loose
        step([&r] { r.newObject(ObjectMode::DefineAndInstantiate); });
        step([&r] { r.instantiate(1); });
        square(9);
        step([&r] { r.instantiateWithShader(1, 1); });
        step([&r] { r.endObject(); });
        step([&r] { r.normal({0, 1, 0}); });
        square(11);
        const auto replacement = std::make_shared<std::vector<uint32_t>>(2, 1u);
        step([&r, replacement] { r.instantiateWithShaders(1, *replacement); });
        square(13);
        step([&r] { r.textures().bind(5); });
        step([&r] {
            r.textures().setImage(
                0,
                std::make_shared<const TextureImage>(1, 1, 1, TexelType::Byte, false,
                                                     std::vector<std::byte>(1)),
                1);
        });
        step([&r] {
            const float moved[6] = {0, 0, 1, 1, 0, 1};
            r.updateObject(1, 4, 2, moved);
        });
        step([&r] { r.instantiate(1); });
        step([&r] { r.replaceObject(2); });
        step([&r] { r.endObject(); });
        step([&r] { r.instantiate(2); });
        square(15);
        step([this, &r] { query = r.compileScene(); });
        step([this, &r] { frame = r.makeFrame(); });
        return all;
    }
};

/// Runs every step; each first with failures at its 1st, 2nd, ... allocation. Returns how many.
int runWithFailures(Program& program) {
    int failures = 0;
    for (const auto& step : program.steps()) {
        for (long allocation = 0;; ++allocation) {
            allocationsLeft = allocation;
            try {
                step();
                allocationsLeft = -1;
                break;
            } catch (const std::bad_alloc&) {
                allocationsLeft = -1;
                ++failures;
            }
        }
    }
    return failures;
}

void expectEqualModels(const Model& a, const Model& b);

void expectEqualGroups(const InstanceGroup& a, const InstanceGroup& b) {
    ASSERT_EQ(a.instances().size(), b.instances().size());
    for (std::size_t i = 0; i < a.instances().size(); ++i) {
        const Instance x = asGiven(a.instances()[i]), y = asGiven(b.instances()[i]);
        EXPECT_EQ(x.objectId, y.objectId);
        EXPECT_EQ(x.toParent, y.toParent);
        EXPECT_EQ(x.inherited.color, y.inherited.color);
        EXPECT_EQ(x.replacement == nullptr, y.replacement == nullptr);
        if (x.replacement && y.replacement) {
            EXPECT_EQ(x.replacement->all, y.replacement->all);
            EXPECT_EQ(x.replacement->pairs.size(), y.replacement->pairs.size());
        }
        expectEqualModels(*x.model, *y.model);
    }
}

void expectEqualModels(const Model& a, const Model& b) {
    ASSERT_EQ(a.triangles.size(), b.triangles.size());
    if (!a.triangles.empty()) {
        EXPECT_EQ(std::memcmp(a.triangles.data(), b.triangles.data(),
                              a.triangles.size() * sizeof(Triangle)),
                  0);
    }
    const ShadingData &x = a.shading, &y = b.shading;
    EXPECT_EQ(x.corners, y.corners);
    EXPECT_EQ(x.colors, y.colors);
    EXPECT_EQ(x.firstColor, y.firstColor);
    EXPECT_EQ(x.normals, y.normals);
    EXPECT_EQ(x.firstNormal, y.firstNormal);
    EXPECT_EQ(x.slots, y.slots);
    EXPECT_EQ(x.shaders.size(), y.shaders.size());
    EXPECT_EQ(a.treeSizes().nodes, b.treeSizes().nodes);
    EXPECT_GT(a.triangles.empty() + a.treeSizes().references, 0u);
    expectEqualGroups(a.children, b.children);
}

TEST(RecorderMemory, AFailedStepChangesNothing) {
    Program plain, failing;
    for (const auto& step : plain.steps()) step();
    const int failures = runWithFailures(failing);
    EXPECT_GT(failures, 150) << "the control: allocations do fail";

    ASSERT_TRUE(plain.frame && failing.frame);
    const InstanceGroup& expected = plain.frame->scene->group();
    ASSERT_EQ(expected.instances().size(), 8u);
    expectEqualGroups(failing.frame->scene->group(), expected);
    expectEqualGroups(failing.query->group(), plain.query->group());
    EXPECT_EQ(failing.frame->textures->size(), plain.frame->textures->size());
    EXPECT_EQ(failing.frame->shaders->size() > 1, plain.frame->shaders->size() > 1);
    for (const uint32_t id : {1u, 2u}) {
        const auto &a = failing.recorder.objectShaders(id), &b = plain.recorder.objectShaders(id);
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].id, b[i].id);
    }
}

/// Keeps a list of a few hundred calls while the n-th allocation fails; whether it came about.
bool keepsList(DisplayLists& lists, long failing) {
    allocationsLeft = failing;
    bool kept = true;
    try {
        lists.start(1, true);
        for (int i = 0; i < 100; ++i) {
            ListRecording& list = *lists.recording();
            EXPECT_TRUE(list.call(ListOp::BeginFilled, {"rtBegin", nullptr, 0}));
            EXPECT_TRUE(list.vertex({i, 0, 0, 1}));
            EXPECT_TRUE(list.color({1, 1, 1, 1}));
            EXPECT_TRUE(list.call(ListOp::End, {"rtEnd", nullptr, 0}));
            EXPECT_TRUE(list.call(ListOp::Call, {"rtPopMatrix", nullptr, 0}));
        }
        lists.finish();
    } catch (const std::bad_alloc&) {
        kept = false;
    }
    allocationsLeft = -1;
    EXPECT_EQ(lists.recording(), nullptr);
    return kept;
}

TEST(RecorderMemory, ListsWithoutMemoryLoseNothingElse) {
    DisplayLists lists;
    lists.start(1, false);
    lists.recording()->vertex({0, 0, 0, 1});
    lists.finish();
    const auto old = lists.find(1);
    long failures = 0;
    while (!keepsList(lists, failures)) {
        ASSERT_EQ(lists.find(1), old) << "failure " << failures;
        ++failures;
    }
    EXPECT_GT(failures, 10);
    EXPECT_NE(lists.find(1), old);
    EXPECT_EQ(lists.find(1)->segments().size(), 200u);
}

TEST(RecorderMemory, RunsWithoutMemoryChangeNothing) {
    Recorder recorder;
    recorder.color({0.5f, 0.5f, 0.5f, 1});
    const auto run = [&recorder] {
        recorder.begin(Primitive::Triangles);
        recorder.color({1, 0, 0, 1});
        for (int i = 0; i < 3; ++i) recorder.vertex({i % 2, i / 2, 0, 1});
        recorder.end();
    };
    int failures = 0;
    std::optional<CompiledRun> compiled;
    while (!compiled) {
        allocationsLeft = failures++;
        try {
            compiled.emplace(recorder.compileRun(run));
        } catch (const std::bad_alloc&) {
        }
        allocationsLeft = -1;
        EXPECT_FALSE(recorder.insideObject() || recorder.insidePrimitive());
        EXPECT_EQ(recorder.attributes().color, glm::vec4(0.5f, 0.5f, 0.5f, 1));
    }
    EXPECT_GT(failures, 5);
    EXPECT_EQ(compiled->model->triangles.size(), 1u);
}

} // namespace
} // namespace smart::compat
