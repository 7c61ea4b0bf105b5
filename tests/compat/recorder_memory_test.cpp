// SPDX-License-Identifier: MIT
// A program on the recorder in which each allocation of each step fails once: the step has to
// throw std::bad_alloc and change nothing, so that after trying again the outcome is that of a
// program in which nothing failed.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <new>
#include <optional>
#include <thread>

#include "compat/recorder/context.h"
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
[[gnu::noinline]] void release(void* memory) noexcept { // inlined, g++ takes it for a wrong pair
    std::free(memory);
}

} // namespace

void* operator new(std::size_t bytes) { return allocate(bytes, alignof(std::max_align_t)); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return allocate(bytes, std::max(std::size_t(alignment), alignof(std::max_align_t)));
}
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

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

/// Tries until it works, with failures at the 1st, 2nd, ... allocation; returns how many.
template <class Action, class AfterFailure>
int tryUntilItWorks(const Action& action, const AfterFailure& afterFailure) {
    for (int failures = 0;; ++failures) {
        allocationsLeft = failures;
        try {
            action();
            allocationsLeft = -1;
            return failures;
        } catch (const std::bad_alloc&) {
            allocationsLeft = -1;
        } catch (...) {
            allocationsLeft = -1;
            throw;
        }
        afterFailure();
    }
}

TEST(RecorderMemory, AttributesComeBackAllOrNot) {
    for (const uint32_t groups : {uint32_t(kLightingGroup), uint32_t(kCurrentGroup), 0xFFFFFFFFu}) {
        Context context(1);
        Recorder& r = context.recorder();
        r.selectTextureUnit(1);
        r.fixedState().changeTexture().enabled2D = true;
        r.selectTextureUnit(0);
        r.fixedState().change().lighting.colorMaterial = true;
        r.color({1, 0, 0, 1});
        const FixedMaterials saved = r.materials();
        pushAttributes(context, groups);
        r.color({0, 1, 0, 1});
        r.setMaterials({});
        r.fixedState().change().raster.pointSize = 7;
        r.fixedState().change().lighting.enabled = true;
        r.idleState().dither = false;
        const FixedMaterials materials = r.materials();
        const int failures = tryUntilItWorks([&] { popAttributes(context); }, [&] {
            EXPECT_EQ(context.attribStack().depth(), 1u);
            EXPECT_EQ(r.attributes().color, glm::vec4(0, 1, 0, 1));
            EXPECT_TRUE(r.materials() == materials);
            EXPECT_EQ(r.fixedStateNow().raster.pointSize, 7.0f);
            EXPECT_TRUE(r.fixedStateNow().lighting.enabled);
            EXPECT_FALSE(r.idleStateNow().dither);
        });
        EXPECT_EQ(failures, 2) << "the control: a texture unit and the materials";
        EXPECT_EQ(context.attribStack().depth(), 0u);
        const bool color = (groups & kCurrentGroup) != 0;
        EXPECT_EQ(r.attributes().color, glm::vec4(color, !color, 0, 1));
        EXPECT_TRUE(r.materials() == (color ? saved : materials)); // they follow the colour
        EXPECT_EQ(r.fixedStateNow().raster.pointSize, (groups & kPointGroup) != 0 ? 1.0f : 7.0f);
        EXPECT_EQ(r.fixedStateNow().lighting.enabled, (groups & kLightingGroup) == 0);
        EXPECT_THROW(popAttributes(context), Error);
    }
}

TEST(RecorderMemory, AViewThatFailsKeepsItsCamera) {
    Context context(1);
    Recorder& r = context.recorder();
    PixelTarget& target = r.frameSettings().target;
    target.memory = pixels;
    target.width = target.height = 8;
    target.format = PixelFormat::Rgba32f;
    r.shaders().addClass(findBuiltinClass("PinholeCameraShader"));
    const uint32_t camera = r.shaders().newShader();
    r.useUnique(UniqueShader::Camera, camera);
    context.frames().render();
    r.useUnique(UniqueShader::Camera, camera);
    // A camera used up would be an Error.
    const int failures = tryUntilItWorks([&] { context.frames().queueView(); }, [] {});
    EXPECT_GT(failures, 2);
    EXPECT_THROW(context.frames().queueView(), Error) << "the camera is used up";
}

/// Takes its time for each frame.
class SlowListener final : public FrameListener {
public:
    void tileDone(QueuedFrame&, const Tile&) noexcept override {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    void ended(QueuedFrame&, FrameStatus) noexcept override { ++frames; }
    std::atomic<int> frames = 0;
};

TEST(RecorderMemory, AFinishThatFailsHasWaitedForTheFramesBefore) {
    Context context(1);
    Recorder& r = context.recorder();
    PixelTarget& target = r.frameSettings().target;
    target.memory = pixels;
    target.width = target.height = 8;
    target.format = PixelFormat::Rgba32f;
    const auto listener = std::make_shared<SlowListener>();
    context.frames().setListener(listener);
    const auto queueOneAndBeginAnother = [&] {
        context.frames().queue();
        r.begin(Primitive::Triangles);
        for (int i = 0; i < 3; ++i) r.vertex({i % 2, i / 2, 0, 1});
        r.end();
    };
    queueOneAndBeginAnother();
    int queued = 1;
    const int failures = tryUntilItWorks([&] { context.frames().finish(); }, [&] {
        EXPECT_EQ(listener->frames, queued++);
        queueOneAndBeginAnother();
    });
    EXPECT_GT(failures, 5);
    EXPECT_EQ(listener->frames, queued + 1);
}

TEST(RecorderMemory, NamesOfBuffersThatFailStayFree) {
    for (const uint32_t taken : {0u, 1u, 2u, 3u, 5u}) {
        BufferStore buffers;
        if (taken) buffers.bind(taken);
        const uint32_t first = taken == 1 ? 2 : 1;
        // Names after the first need no memory: a call for several makes all or none.
        uint32_t names[6] = {};
        const int failures = tryUntilItWorks([&] { names[0] = buffers.generate(); }, [] {});
        EXPECT_EQ(failures, taken == 1 || taken == 2 ? 0 : 1);
        EXPECT_EQ(names[0], first);
        int made = 1;
        const int more = tryUntilItWorks([&] {
            for (; made < 6; ++made) names[made] = buffers.generate();
        }, [] {});
        EXPECT_EQ(more, 0) << "before name " << made;
        uint32_t name = first;
        for (const uint32_t generated : names) {
            EXPECT_EQ(generated, name);
            name += name + 1 == taken ? 2 : 1;
        }

        const int bound = tryUntilItWorks([&] { buffers.bind(9); }, [&] {
            EXPECT_FALSE(buffers.exists(9));
            uint32_t last = 0;
            while (last < 9) last = buffers.generate();
            EXPECT_EQ(last, 9u) << "it was free";
            for (; last >= name; --last) buffers.remove(last);
        });
        EXPECT_GT(bound, 1);
    }
}

TEST(RecorderMemory, AStateBlockIsOfItsSources) {
    const auto image = std::make_shared<const Texture>(
        1, 1, 4, TexelType::Byte, std::vector<std::byte>(4), TextureOptions{});
    FixedStateRecorder fixed;
    FixedStateSources one, three;
    one.texture.image = three.texture.image = image;
    three.moreTextures.resize(2);
    three.moreTextures[1].image = image;
    fixed.block({});
    FixedStatePtr block;
    const int failures = tryUntilItWorks([&] { block = fixed.block(three); }, [&] {
        EXPECT_TRUE(fixed.block(one)->moreTextures.empty());
    });
    EXPECT_GT(failures, 2);
    EXPECT_EQ(block->moreTextures.size(), 2u);
}

} // namespace
} // namespace smart::compat
