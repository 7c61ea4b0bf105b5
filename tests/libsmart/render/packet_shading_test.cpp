// SPDX-License-Identifier: MIT
// Packets of points against the same points one by one: no bit may differ.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

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
