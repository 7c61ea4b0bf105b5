// SPDX-License-Identifier: MIT
// Scenes with built-in shaders, and tracers compared pixel by pixel.
#pragma once

#include <cstring>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <vector>

#include "libsmart/render/packet_tracer.h"
#include "libsmart/render/tile_order.h"
#include "tests/libsmart/render/picture_scene.h"
#include "tests/libsmart/shading/fake_tracer.h"

namespace smart::test {

/// Renders with a tracer, tile after tile; returns what was counted.
inline RenderStatistics renderWith(const Tracer& tracer, const Picture& picture) {
    const auto pixels = std::make_unique<TilePixels>();
    RenderStatistics sum;
    const PixelTarget& target = picture.frame->target;
    for (const Tile& tile : mortonTiles(target.width, target.height)) {
        tracer.render(*picture.frame, tile, *pixels);
        writeTile(target, tile, *pixels);
        sum.primaryRays += pixels->primaryRays;
        sum.shadowRays += pixels->shadowRays;
        sum.secondaryRays += pixels->secondaryRays;
        sum.badPixels += pixels->badPixels;
    }
    return sum;
}

/// Pixels that differ in any bit of any value that is kept of them.
inline std::size_t differingPixels(const Picture& a, const Picture& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const auto same = [i](const auto& x, const auto& y) {
            return std::memcmp(&x[i], &y[i], sizeof x[i]) == 0;
        };
        count += !(same(a.pixels, b.pixels) && same(a.depth, b.depth) &&
                   same(a.distance, b.distance) && same(a.normals, b.normals) &&
                   same(a.objects, b.objects) && same(a.instances, b.instances) &&
                   same(a.primitives, b.primitives));
    }
    return count;
}

using Shaders = std::vector<std::shared_ptr<const ShaderObject>>;

/// Spheres in a row, one with a child of its own, over a floor; sphere i and the floor take
/// shaders in turn. Point, directional, quad and sphere light; the sky is a picture.
inline Picture litSpheres(Shaders shaders, Precision precision = Precision::Watertight,
                          uint32_t samples = 2) {
    const glm::dmat4 one(1.0);
    const ModelPtr ball = makeModel(icosphere(3));
    const uint32_t count = uint32_t(shaders.size());
    Instance moon = placeWithShader(
        ball, 1 % count,
        glm::dmat4x3(glm::scale(glm::translate(one, glm::dvec3(0.2, 1.1, 0.4)), glm::dvec3(0.4))));
    const ModelPtr pair = makeModel(icosphere(2), {moon});
    std::vector<Instance> instances;
    for (int i = -2; i <= 2; ++i) {
        glm::dmat4 m = glm::translate(one, glm::dvec3(1.1 * i, 0.2 * i * i - 0.3, -5.0 - 0.3 * i));
        m = glm::rotate(m, 0.3 + i, glm::dvec3(1, 2, i));
        m = glm::scale(m, glm::dvec3(0.7, 0.6 + 0.1 * i, 0.7));
        if (i == 0) {
            instances.push_back(place(pair, glm::dmat4x3(m)));
        } else {
            instances.push_back(placeWithShader(ball, uint32_t(i + 2) % count, glm::dmat4x3(m)));
        }
    }
    const glm::dmat4 flat =
        glm::rotate(glm::translate(one, glm::dvec3(0, -1.2, -6)), -1.5707, glm::dvec3(1, 0, 0));
    instances.push_back(placeWithShader(makeModel(rectangle(-6, -6, 6, 6, 0)), count - 1,
                                        glm::dmat4x3(flat)));
    instances.back().inherited.color = {0.7f, 0.8f, 0.9f, 0.75f};

    Picture picture(70, 45, makeScene(std::move(instances), precision), std::move(shaders));
    Frame& frame = *picture.frame;
    frame.samples = samples;
    frame.recursionLimit = 4;
    frame.clearColor = {0.1f, 0.2f, 0.3f, 0.5f};
    using openrt::Color;
    using openrt::Vec3;
    frame.lights = {
        MadeShader("PointLight").set("position", Vec3(2, 4, -2)).set("radiance", Color(9)).make(),
        MadeShader("DirectionalLight").set("direction", Vec3(1, -2, -1)).make(),
        MadeShader("QuadLight")
            .set("corner", Vec3(-3, 3, -6))
            .set("edge1", Vec3(1, 0, 0))
            .set("edge2", Vec3(0, 0, 1))
            .set("radiance", Color(5, 4, 3))
            .set("samples", 3)
            .make(),
        MadeShader("SphereLight")
            .set("center", Vec3(0, 3, -3))
            .set("radius", 0.5f)
            .set("radiance", Color(3))
            .set("samples", 2)
            .make()};
    std::vector<std::byte> texels;
    for (int i = 0; i < 16 * 8 * 3; ++i) texels.push_back(std::byte(i * 37 % 256));
    TextureOptions options;
    frame.textures = std::make_shared<const TextureTable>(TextureTable{
        nullptr,
        std::make_shared<const Texture>(16, 8, 3, TexelType::Byte, std::move(texels), options)});
    frame.environment = MadeShader("ImageEnvironment").set("texture", 1).make();
    return picture;
}

inline std::shared_ptr<const ShaderObject> shinyPhong() {
    using openrt::Color;
    return MadeShader("Phong")
        .set("diffuse", Color(0.5f, 0.6f, 0.4f))
        .set("specular", Color(0.5f))
        .set("reflection", Color(0.3f, 0.2f, 0.3f))
        .set("texture", 1)
        .make();
}

inline std::shared_ptr<const ShaderObject> clearPhong() {
    using openrt::Color;
    return MadeShader("Phong")
        .set("diffuse", Color(0.2f))
        .set("transmission", Color(0.6f, 0.7f, 0.5f))
        .make();
}

} // namespace smart::test
