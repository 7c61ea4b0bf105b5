// SPDX-License-Identifier: MIT
// Tracers compiled for one shader class against the general one.
#include <gtest/gtest.h>

#include "libsmart/render/tracers.h"
#include "tests/libsmart/render/shaded_scenes.h"

namespace smart::test {
namespace {

const char* const kFixed[] = {"FixedFunction", "ConstantShader", "DiffuseShader",
                              "TexturedDiffuseShader", "TextureShader", "MirrorShader", "Phong",
                              "MetallicRoughness", "Glass", "AmbientOcclusion"};

const Tracer& general(ShadingForm form) {
    return tracerFor(FrameShading(), form);
}

/// Pixels in which the tracer that suits the frame differs from the general one.
std::size_t differences(const std::function<Picture()>& make, ShadingForm form) {
    const Picture expected = make(), fixed = make();
    const RenderStatistics a = renderWith(general(form), expected);
    const RenderStatistics b = renderWith(tracerFor(fixed.frame->shading(), form), fixed);
    EXPECT_EQ(a.shadowRays, b.shadowRays);
    EXPECT_EQ(a.secondaryRays, b.secondaryRays);
    EXPECT_EQ(a.badPixels, b.badPixels);
    return differingPixels(expected, fixed);
}

TEST(FixedTracer, EveryBuiltinSurfaceHasOneWithTheSamePixels) {
    for (const char* name : kFixed) {
        SCOPED_TRACE(name);
        const auto make = [&] { return litSpheres({MadeShader(name).make()}); };
        for (const ShadingForm form : {ShadingForm::Packets, ShadingForm::Points}) {
            EXPECT_NE(&tracerFor(make().frame->shading(), form), &general(form));
            EXPECT_EQ(differences(make, form), 0u);
        }
    }
}

TEST(FixedTracer, ServesShadersOfOneClassWithDifferentParameters) {
    const auto make = [] { return litSpheres({shinyPhong(), clearPhong()}); };
    EXPECT_NE(&tracerFor(make().frame->shading()), &general(ShadingForm::Packets));
    EXPECT_EQ(differences(make, ShadingForm::Packets), 0u);
    const auto paths = [] {
        Picture picture = litSpheres({shinyPhong(), clearPhong()});
        picture.frame->renderingObject = MadeShader("PathTracer").make();
        return picture;
    };
    EXPECT_EQ(differences(paths, ShadingForm::Packets), 0u);
}

TEST(FixedTracer, OnlySurfacesInUseCount) {
    Picture picture = litSpheres({shinyPhong()});
    auto shaders = std::make_shared<ShaderTable>(*picture.frame->shaders);
    shaders->push_back(MadeShader("MirrorShader").make()); // no triangle has it
    picture.frame->shaders = shaders;
    EXPECT_NE(&tracerFor(picture.frame->shading()), &general(ShadingForm::Packets));

    const Picture mixed = litSpheres({shinyPhong(), MadeShader("MirrorShader").make()});
    EXPECT_EQ(&tracerFor(mixed.frame->shading()), &general(ShadingForm::Packets));
}

/// A shader of the program's own.
struct Stripes {
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        const auto seen = c.trace(c.position(), c.reflectedDirection(), 0.5f);
        c.setRadiance(seen * 0.5f + typename Context::Color(c.position().x * c.random()));
    }
    template <class Context>
    bool transparency(Context& c) const {
        return c.depth() > 1;
    }
};

TEST(FixedTracer, TakesAnyClassAndLeavesOtherFramesAlone) {
    const auto stripes = MadeShader(std::make_shared<const ShaderClass>(
                                        *openrt::shaderClass<Stripes>("Stripes"), nullptr))
                             .make();
    const PacketTracer<FixedShading<Stripes>> tracer;
    for (const bool alone : {true, false}) {
        const Shaders shaders = alone ? Shaders{stripes} : Shaders{stripes, shinyPhong()};
        const Picture expected = litSpheres(shaders), fixed = litSpheres(shaders);
        EXPECT_EQ(FixedShading<Stripes>::serves(fixed.frame->shading()), alone);
        renderWith(general(ShadingForm::Points), expected);
        renderWith(tracer, fixed);
        EXPECT_EQ(differingPixels(expected, fixed), 0u);
    }
}

} // namespace
} // namespace smart::test
