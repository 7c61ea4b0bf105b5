// SPDX-License-Identifier: MIT
// What shaders say that they read: nothing of the picture may depend on it where it is true, and
// what was not named is 0.
#include <gtest/gtest.h>

#include "libsmart/geometry/model_builder.h"
#include "libsmart/render/tracers.h"
#include "tests/libsmart/render/shaded_scenes.h"

namespace smart::test {
namespace {

const PacketTracer<> kPoints(ShadingForm::Points), kPackets(ShadingForm::Packets);

/// A ball whose vertices have everything; the triangles do not share them.
ModelPtr attributedBall() {
    ModelBuilder builder;
    builder.triangles = icosphere(2);
    ShadingData& shading = builder.shading;
    shading.firstNormal = shading.firstTexCoord = shading.firstColor = 0;
    uint32_t number = 0;
    for (const Triangle& t : builder.triangles) {
        shading.corners.push_back({number, number + 1, number + 2});
        number += 3;
        for (const float* v : {t.v0, t.v1, t.v2}) {
            shading.normals.push_back({v[0], v[1] + 0.1f, v[2]});
            shading.texCoords.push_back({v[0] * 2, v[1], v[2], 1});
            shading.colors.push_back({v[0] * 0.5f + 0.5f, v[1] * 0.5f + 0.5f, 0.5f, 0.75f});
        }
    }
    return std::move(builder).build();
}

/// Balls over a floor, which take shaders in turn.
Picture balls(Shaders shaders, bool keepsMore = true) {
    const ModelPtr ball = attributedBall(), bare = makeModel(icosphere(2));
    const auto count = uint32_t(shaders.size());
    std::vector<Instance> instances;
    for (int i = 0; i < 4; ++i) {
        glm::dmat4 m = glm::translate(glm::dmat4(1.0), glm::dvec3(1.3 * i - 2, 0.1 * i, -5));
        m = glm::rotate(m, 0.4 * i, glm::dvec3(1, 2, 3));
        m = glm::scale(m, glm::dvec3(0.8, 0.7, 0.9));
        instances.push_back(
            placeWithShader(i == 2 ? bare : ball, uint32_t(i) % count, glm::dmat4x3(m)));
    }
    const glm::dmat4 flat = glm::rotate(
        glm::translate(glm::dmat4(1.0), glm::dvec3(0, -1, -6)), -1.5, glm::dvec3(1, 0, 0));
    instances.push_back(placeWithShader(makeModel(rectangle(-6, -6, 6, 6, 0)), count - 1,
                                        glm::dmat4x3(flat)));
    Picture picture(41, 30, makeScene(std::move(instances)), std::move(shaders));
    Frame& frame = *picture.frame;
    frame.recursionLimit = 3;
    using openrt::Color;
    using openrt::Vec3;
    frame.lights = {
        MadeShader("PointLight").set("position", Vec3(2, 4, -2)).set("radiance", Color(9)).make(),
        MadeShader("DirectionalLight").set("direction", Vec3(1, -2, -1)).make()};
    std::vector<std::byte> texels;
    for (int i = 0; i < 32 * 32 * 3; ++i) texels.push_back(std::byte(i * 37 % 256));
    frame.textures = std::make_shared<const TextureTable>(TextureTable{
        nullptr, std::make_shared<const Texture>(32, 32, 3, TexelType::Byte, std::move(texels),
                                                 TextureOptions())});
    if (!keepsMore) frame.target.aux = {};
    return picture;
}

/// The shader with the same values, whose class does not say what it reads.
std::shared_ptr<const ShaderObject> readingAll(const std::string& name,
                                               const ParameterValues& values) {
    static std::map<std::string, ShaderClassPtr> made;
    ShaderClassPtr& silent = made[name];
    if (!silent) {
        RTshaderclass descriptor = findBuiltinClass(name)->descriptor();
        EXPECT_NE(descriptor.reads, nullptr) << name;
        descriptor.reads = nullptr;
        silent = std::make_shared<const ShaderClass>(descriptor, nullptr);
    }
    return std::make_shared<const ShaderObject>(silent, values);
}

ParameterValues withTexture(const std::string& name) {
    const ShaderClassPtr its = findBuiltinClass(name);
    ParameterValues values;
    for (const char* parameter : {"texture", "baseColorTexture", "metallicRoughnessTexture"})
        if (const int index = its->findParameter(parameter); index >= 0)
            values[uint32_t(index)] = bytesOf(1);
    return values;
}

const std::vector<std::string> kSurfaces = {
    "FixedFunction", "ConstantShader", "DiffuseShader",     "TexturedDiffuseShader",
    "TextureShader", "MirrorShader",   "Phong",             "MetallicRoughness",
    "Glass",         "AmbientOcclusion"};

TEST(ShaderReads, PicturesOfBuiltinSurfacesAreTheSameAsWithEverything) {
    for (const std::string& name : kSurfaces)
        for (const bool textured : {false, true})
            for (const bool keepsMore : {false, true})
                for (const bool indirect : {false, true}) {
                    if (indirect && (!textured || keepsMore)) continue;
                    SCOPED_TRACE(name + (textured ? ", textured" : "") +
                                 (keepsMore ? ", with buffers" : "") +
                                 (indirect ? ", paths" : ""));
                    const ParameterValues values =
                        textured ? withTexture(name) : ParameterValues();
                    const auto declaring = std::make_shared<const ShaderObject>(
                        findBuiltinClass(name), values);
                    EXPECT_NE(declaring->reads(), RTS_READS_EVERYTHING);
                    const auto make = [&](const std::shared_ptr<const ShaderObject>& shader) {
                        Picture picture = balls({shader}, keepsMore);
                        if (indirect)
                            picture.frame->renderingObject = MadeShader("PathTracer").make();
                        return picture;
                    };
                    const Picture all = make(readingAll(name, values));
                    renderWith(kPackets, all);
                    for (const Tracer* tracer :
                         {static_cast<const Tracer*>(&kPackets),
                          static_cast<const Tracer*>(&kPoints),
                          &tracerFor(all.frame->shading(), ShadingForm::Packets)}) {
                        const Picture exact = make(declaring);
                        renderWith(*tracer, exact);
                        EXPECT_EQ(differingPixels(all, exact), 0u);
                    }
                }
}

/// Shows one value, and says of others that it reads them.
struct Teller {
    static constexpr bool shadesPackets = true;
    int shown = 0, declared = 0;

    void registerParams(const openrt::ShaderRegistrator& r) const {
        r.registerParam<int>("shown", openrt::PER_SHADER, offsetof(Teller, shown));
        r.registerParam<int>("declared", openrt::PER_SHADER, offsetof(Teller, declared));
    }
    RTuint reads() const { return RTuint(declared); }

    template <class Context>
    void shade(Context& c) const {
        using Float = typename Context::Float;
        using Color = typename Context::Color;
        const auto show = [&](const auto& v) { c.setRadiance(Color(v.x, v.y, v.z)); };
        switch (RTuint(shown)) {
            case RTS_READS_RAY:
                c.setRadiance(Color(c.rayOrigin().x + c.rayDirection().x, c.rayDirection().y,
                                    c.rayDistance()));
                break;
            case RTS_READS_POSITION: show(c.position()); break;
            case RTS_READS_NORMAL:
                show(c.geometricNormal());
                c.setAlpha(openrt::select(c.frontFace(), Float(1.0f), Float(0.0f)));
                break;
            case RTS_READS_SHADING_NORMAL: show(c.shadingNormal()); break;
            case RTS_READS_RAW_NORMAL: show(c.rawNormal()); break;
            case RTS_READS_BARYCENTRIC: show(c.barycentrics()); break;
            case RTS_READS_TEXCOORD: show(c.texCoord4()); break;
            case RTS_READS_COLOR:
                c.setRadiance(c.color());
                c.setAlpha(c.alpha());
                break;
            case RTS_READS_IDS: showIds(c); break;
            case RTS_READS_PIXEL: showPixel(c); break;
            case RTS_READS_FOOTPRINT: showFootprint(c); break;
        }
    }

private:
    static void showIds(openrt::TraceContext& c) {
        c.setRadiance({float(c.object()), float(c.instance()), float(c.primitive())});
    }
    static void showPixel(openrt::TraceContext& c) {
        const RTSstate& s = *c.state();
        c.setRadiance({float(s.pixel[0]), float(s.pixel[1]), float(s.sample)});
    }
    static void showFootprint(openrt::TraceContext& c) {
        c.setRadiance({c.state()->footprint, c.state()->texCoordDensity, 0});
    }
    static openrt::Floats floats(const RTSids& ids) {
        openrt::Floats result;
        for (int i = 0; i < openrt::kLanes; ++i) result[i] = float(ids.lane[i]);
        return result;
    }
    static void showIds(openrt::PacketContext& c) {
        c.setRadiance({floats(c.object()), floats(c.instance()), floats(c.primitive())});
    }
    static void showPixel(openrt::PacketContext& c) {
        const RTSpacket& p = *c.packet();
        c.setRadiance({floats(p.pixel[0]), floats(p.pixel[1]), floats(p.sample)});
    }
    static void showFootprint(openrt::PacketContext& c) {
        c.setRadiance({c.packet()->footprint, c.packet()->texCoordDensity, 0.0f});
    }
};

std::shared_ptr<const ShaderObject> teller(uint32_t shown, uint32_t declared) {
    static const auto made =
        std::make_shared<const ShaderClass>(*openrt::shaderClass<Teller>("Teller"), nullptr);
    return MadeShader(made).set("shown", int(shown)).set("declared", int(declared)).make();
}

const uint32_t kValues[] = {
    RTS_READS_RAY,        RTS_READS_POSITION,    RTS_READS_NORMAL,   RTS_READS_SHADING_NORMAL,
    RTS_READS_RAW_NORMAL, RTS_READS_BARYCENTRIC, RTS_READS_TEXCOORD, RTS_READS_COLOR,
    RTS_READS_IDS,        RTS_READS_PIXEL,       RTS_READS_FOOTPRINT};

/// Pixels that show the shader of the floor and of every other ball, and are not black.
std::size_t shining(const Picture& picture) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        if (picture.instances[i] != 0xFFFFFFFFu && picture.instances[i] % 2 == 1)
            count += glm::vec3(picture.pixels[i]) != glm::vec3(0.0f);
    return count;
}

// The other shader reads everything, so that what lies in the packets' memory is its points'.
TEST(ShaderReads, WhatIsNotNamedIsZeroAndWhatIsNamedIsThere) {
    for (const uint32_t shown : kValues) {
        SCOPED_TRACE(shown);
        const auto other = teller(RTS_READS_COLOR, RTS_READS_EVERYTHING);
        const auto make = [&](uint32_t declared) {
            return balls({other, teller(shown, declared)});
        };
        const Picture all = make(RTS_READS_EVERYTHING);
        renderWith(kPoints, all);
        EXPECT_GT(shining(all), 100u);
        for (const Tracer* tracer : {&kPoints, &kPackets}) {
            const Picture exact = make(shown);
            renderWith(*tracer, exact);
            EXPECT_EQ(differingPixels(all, exact), 0u);
            for (const uint32_t declared : {0u, RTS_READS_EVERYTHING & ~shown}) {
                const Picture less = make(declared);
                EXPECT_EQ(renderWith(*tracer, less).badPixels, 0u);
                EXPECT_EQ(shining(less), 0u);
            }
        }
    }
}

TEST(ShaderReads, PicturesDoNotDependOnBuffersOfOtherValues) {
    for (const uint32_t shown : kValues)
        for (const uint32_t declared : {0u, shown}) {
            SCOPED_TRACE(shown);
            const Picture more = balls({teller(shown, declared)}, true),
                          plain = balls({teller(shown, declared)}, false);
            renderWith(kPackets, more);
            renderWith(kPackets, plain);
            EXPECT_EQ(std::memcmp(more.pixels.data(), plain.pixels.data(),
                                  plain.pixels.size() * sizeof plain.pixels[0]),
                      0);
        }
}

TEST(ShaderReads, WhereLightsSeeThePointsAllValuesAreThere) {
    Picture picture = balls({teller(RTS_READS_POSITION, 0)});
    EXPECT_FALSE(picture.frame->shading().lightsSeePoints);
    picture = balls({teller(RTS_READS_POSITION, 0)});
    picture.frame->lights.push_back(MadeShader("SphereLight").make());
    EXPECT_TRUE(picture.frame->shading().lightsSeePoints);
    const Picture all = balls({teller(RTS_READS_POSITION, RTS_READS_EVERYTHING)});
    renderWith(kPackets, picture);
    renderWith(kPackets, all);
    EXPECT_EQ(differingPixels(picture, all), 0u);
}

/// Starts rays at points of which it says that it reads nothing.
struct Blind {
    static constexpr bool shadesPackets = true;
    static constexpr RTuint reads() { return 0; }
    template <class Context>
    void shade(Context& c) const {
        const auto seen = c.trace(c.position(), typename Context::Vec3(openrt::Vec3(0, 0, -1)));
        const auto open = c.shadow(c.position(), typename Context::Vec3(openrt::Vec3(1, 1, -1)), 9);
        c.setRadiance(seen * 0.5f + open + colorOf(c.texture({1}, c.texCoord())) * 0.25f);
    }

private:
    static openrt::Color colorOf(const openrt::Vec4& v) { return {v.x, v.y, v.z}; }
    static openrt::PacketColor colorOf(const openrt::PacketVec4& v) { return {v.x, v.y, v.z}; }
};

TEST(ShaderReads, FunctionsTakeTheZerosThatTheShaderSees) {
    const auto blind = MadeShader(std::make_shared<const ShaderClass>(
                                      *openrt::shaderClass<Blind>("Blind"), nullptr))
                           .make();
    const auto other = teller(RTS_READS_COLOR, RTS_READS_EVERYTHING);
    const Picture points = balls({other, blind}), packets = balls({other, blind}),
                  fixed = balls({blind}), alone = balls({blind});
    renderWith(kPoints, points);
    renderWith(kPackets, packets);
    EXPECT_EQ(differingPixels(points, packets), 0u);
    renderWith(kPoints, alone);
    renderWith(PacketTracer<FixedShading<Blind>>(), fixed);
    EXPECT_EQ(differingPixels(alone, fixed), 0u);
}

} // namespace
} // namespace smart::test
