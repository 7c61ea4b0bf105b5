// SPDX-License-Identifier: MIT
// Packets of points against the same points one by one: no bit may differ.
#include <gtest/gtest.h>

#include <atomic>
#include <bit>
#include <cmath>
#include <string>

#include "libsmart/geometry/model_builder.h"
#include "tests/libsmart/render/shaded_scenes.h"
#include "tests/support/kernel_runs.h"

namespace smart::test {
namespace {

const PacketTracer<> kPoints(ShadingForm::Points), kPackets(ShadingForm::Packets);

/// The pictures of both forms, which have to be the same; the counters as well.
void expectTheSame(const std::function<Picture()>& make, uint64_t badPixels = 0) {
    const Picture points = make(), packets = make();
    const RenderStatistics a = renderWith(kPoints, points), b = renderWith(kPackets, packets);
    EXPECT_EQ(differingPixels(points, packets), 0u);
    EXPECT_EQ(a.primaryRays, b.primaryRays);
    EXPECT_EQ(a.shadowRays, b.shadowRays);
    EXPECT_EQ(a.secondaryRays, b.secondaryRays);
    EXPECT_EQ(a.badPixels, badPixels);
    EXPECT_EQ(b.badPixels, badPixels);
}

Shaders allSurfaces() {
    using openrt::Color;
    return {MadeShader("FixedFunction").make(),
            shinyPhong(),
            MadeShader("Glass").make(),
            MadeShader("MirrorShader").set("attenuation", Color(0.9f, 0.8f, 0.7f)).make(),
            clearPhong(),
            MadeShader("AmbientOcclusion").set("samples", 3).make(),
            MadeShader("MetallicRoughness").set("roughness", 0.3f).make()};
}

TEST(PacketShading, PacketsAndPointsGiveTheSameBitsOnEveryInstructionSet) {
    const std::string before = kernels().name;
    for (const KernelTable* table : availableKernels()) {
        SCOPED_TRACE(table->name);
        ASSERT_TRUE(selectKernels(table->name));
        for (const Precision precision : {Precision::Fast, Precision::Watertight})
            expectTheSame([&] {
                return litSpheres({shinyPhong(), clearPhong(), MadeShader("MirrorShader").make()},
                                  precision, 1);
            });
    }
    selectKernels(before.c_str());
}

TEST(PacketShading, EveryBuiltinSurface) {
    for (const char* name : {"FixedFunction", "ConstantShader", "DiffuseShader",
                             "TexturedDiffuseShader", "TextureShader", "MirrorShader", "Phong",
                             "MetallicRoughness", "Glass", "AmbientOcclusion"}) {
        SCOPED_TRACE(name);
        expectTheSame([&] { return litSpheres({MadeShader(name).make()}); });
    }
}

TEST(PacketShading, ManyShadersInOneTile) {
    for (const uint32_t samples : {1u, 3u})
        expectTheSame([&] { return litSpheres(allSurfaces(), Precision::Watertight, samples); });
}

/// A class whose shader does the same for packets and points, except where it fails.
struct Stubborn {
    static constexpr bool shadesPackets = true;
    int mode = 0;

    void registerParams(const openrt::ShaderRegistrator& r) const {
        r.registerParam<int>("mode", openrt::PER_SHADER, offsetof(Stubborn, mode));
    }
    template <class Context>
    void shade(Context& c) const {
        const auto number = c.random();
        if (mode == 1) c.setRadiance(typename Context::Color(number / (number - number)));
        if (mode == 2) throw number;
        if (mode == 3) c.stopRayRecursion();
        if (mode >= 3) {
            const auto seen = c.trace(c.position(), c.reflectedDirection());
            c.setRadiance(seen + typename Context::Color(c.random()));
        }
    }
};

std::shared_ptr<const ShaderObject> stubborn(int mode) {
    const auto made =
        std::make_shared<const ShaderClass>(*openrt::shaderClass<Stubborn>("Stubborn"), nullptr);
    return MadeShader(made).set("mode", mode).make();
}

TEST(PacketShading, FaultsCostTheirOwnPixelsOnly) {
    // Modes: writes nothing; infinite; throws; stops rays; traces on.
    for (const int mode : {0, 1, 2, 3, 4}) {
        SCOPED_TRACE(mode);
        const auto make = [&] {
            return litSpheres({stubborn(mode), MadeShader("MirrorShader").make(), shinyPhong()},
                              Precision::Watertight, 1);
        };
        const Picture points = make();
        const uint64_t bad = renderWith(kPoints, points).badPixels;
        if (mode == 1 || mode == 2) {
            EXPECT_GT(bad, 100u);
            EXPECT_LT(bad, 2000u);
        } else {
            EXPECT_EQ(bad, 0u);
        }
        const Picture packets = make();
        EXPECT_EQ(renderWith(kPackets, packets).badPixels, bad);
        EXPECT_EQ(differingPixels(points, packets), 0u);
    }
}

/// Says how many packets of how many points it was asked for.
struct Counting {
    static inline std::atomic<int> packets{0}, points{0}, alone{0};

    void shade(openrt::TraceContext& c) const {
        ++alone;
        c.setRadiance(openrt::Color(c.position().x));
    }
    void shadePacket(openrt::PacketContext& c) const {
        ++packets;
        points += std::popcount(c.active().bits);
        c.setRadiance(openrt::PacketColor(c.position().x));
    }
};

TEST(PacketShading, HitsOfATileFillPackets) {
    const auto counting = MadeShader(std::make_shared<const ShaderClass>(
                                         *openrt::shaderClass<Counting>("Counting"), nullptr))
                              .make();
    const auto other = makeSurface([](RTSstate* s) {
        rtsResultColor(s, 1, 2, 3);
        return 0;
    });
    // Two shaders in turn, in columns narrower than a packet.
    std::vector<Instance> columns;
    for (int i = 0; i < 32; ++i) {
        const float x = -4.0f + 0.25f * float(i);
        columns.push_back(placeWithShader(makeModel(rectangle(x, -4, x + 0.25f, 4, -1)),
                                          uint32_t(i % 2)));
    }
    Picture picture(64, 64, makeScene(columns), {counting, other});
    picture.frame->matrixCamera = cameraOf(glm::ortho(-4.0, 4.0, -4.0, 4.0, 0.5, 2.0));
    renderWith(kPackets, picture);
    EXPECT_EQ(Counting::points + Counting::alone, 64 * 32);
    EXPECT_EQ(Counting::packets, 64 * 32 / 16); // all are full
    Counting::packets = Counting::alone = 0;
    renderWith(kPoints, picture);
    EXPECT_EQ(Counting::packets, 0);
    EXPECT_EQ(Counting::alone, 64 * 32);
}

/// Shows its parameters of all scopes.
struct Heat {
    struct TriangleParam {
        float offset = 100;
    };
    struct VertexParam {
        float heat = 0, wet = 1;
    };
    void shade(openrt::TraceContext& c) const {
        c.setRadiance({c.triangleParam<TriangleParam>().offset, c.vertexParam<VertexParam>().heat,
                       c.vertexParam<VertexParam>().wet});
    }
    void shadePacket(openrt::PacketContext& c) const {
        c.setRadiance({c.triangleParam(&TriangleParam::offset), c.vertexParam(&VertexParam::heat),
                       c.vertexParam(&VertexParam::wet)});
    }
};

TEST(PacketShading, ParametersOfTrianglesAndVerticesReachEachLane) {
    const auto heat = MadeShader(std::make_shared<const ShaderClass>(
                                     *openrt::shaderClass<Heat>("Heat"), nullptr))
                          .make();
    const auto make = [&] {
        ModelBuilder builder;
        builder.triangles = rectangle(-3, -3, 3, 3, -2);
        ShadingData& shading = builder.shading;
        shading.shaders = {0};
        shading.corners = {{0, 1, 2}, {0, 2, 3}};
        shading.triangleBlocks = {0, ShadingData::kNone}; // the second keeps the default
        shading.triangleData = bytesOf(Heat::TriangleParam{5});
        shading.vertexBlocks = {0, 16, 32, ShadingData::kNone};
        shading.vertexData.resize(48);
        for (int i = 0; i < 3; ++i) {
            const Heat::VertexParam corner{float(i), float(10 * i)};
            std::memcpy(&shading.vertexData[std::size_t(16 * i)], &corner, sizeof corner);
        }
        return Picture(40, 40, makeScene({place(std::move(builder).build())}), {heat});
    };
    const Picture points = make(), packets = make();
    renderWith(kPoints, points);
    renderWith(kPackets, packets);
    EXPECT_EQ(differingPixels(points, packets), 0u);
    // At the rectangle's position (x, y) of the first triangle the heat is that of a plane.
    int first = 0;
    for (std::size_t i = 0; i < packets.pixels.size(); ++i) {
        if (packets.primitives[i] != 0) {
            if (packets.primitives[i] == 1) {
                EXPECT_EQ(packets.pixels[i].r, 100.0f);
            }
            continue;
        }
        ++first;
        const glm::dmat4 inverse = packets.frame->matrixCamera.inverse;
        const glm::dvec4 far = inverse * glm::dvec4((double(i % 40) + 0.5) / 20 - 1,
                                                    (double(i / 40) + 0.5) / 20 - 1, 1, 1);
        const double x = -2 * far.x / far.z, y = -2 * far.y / far.z;
        const double v = (y + 3) / 6, u = (x + 3) / 6 - v; // weights of corners 2 and 1
        EXPECT_EQ(packets.pixels[i].r, 5.0f);
        EXPECT_NEAR(packets.pixels[i].g, u + 2 * v, 1e-5);
        EXPECT_NEAR(packets.pixels[i].b, 10 * u + 20 * v, 1e-4);
    }
    EXPECT_GT(first, 200);
}

TEST(PacketShading, ADifferenceIsSeen) {
    // The comparison is one: another seed is another picture.
    const Picture a = litSpheres({stubborn(4)}), b = litSpheres({stubborn(4)});
    b.frame->seed = 1;
    renderWith(kPackets, a);
    renderWith(kPackets, b);
    EXPECT_GT(differingPixels(a, b), 100u);
}

} // namespace
} // namespace smart::test
