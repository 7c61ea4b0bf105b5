// SPDX-License-Identifier: MIT
// Small frames with shaders written as lambdas.
#pragma once

#include <cstddef>
#include <cstring>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "libsmart/render/frame.h"
#include "libsmart/render/frame_queue.h"
#include "libsmart/render/packet_tracer.h"
#include "libsmart/render/worker.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/traced_scene.h"

namespace smart::test {

using Shade = std::function<int(RTSstate*)>;
using Transparency = std::function<int(RTSstate*, float*)>;
using Illuminate = std::function<int(const float*, RTSlightsample*)>;
using CameraRay = std::function<int(float, float, RTScameraray*)>;
using RenderPixel = std::function<int(RTSpixel*, float*)>;

/// A function as a shader: its class keeps it alive, its block points to it.
template <class Function>
std::shared_ptr<const ShaderObject> makeShader(RTshaderclass descriptor, Function function) {
    const auto kept = std::make_shared<const Function>(std::move(function));
    const RTSparameter parameter{"function", RTS_PER_SHADER, RTS_RAW, 0, sizeof(void*)};
    descriptor.structSize = sizeof(RTshaderclass);
    descriptor.interfaceVersion = RTS_INTERFACE_VERSION;
    descriptor.name = "Lambda";
    descriptor.shaderSize = sizeof(void*);
    descriptor.alignment = alignof(void*);
    descriptor.parameters = &parameter;
    descriptor.parameterCount = 1;
    descriptor.construct = [](void*, void*, void*) { return 0; };
    const Function* address = kept.get();
    std::vector<std::byte> value(sizeof address);
    std::memcpy(value.data(), &address, sizeof address);
    return std::make_shared<const ShaderObject>(
        std::make_shared<const ShaderClass>(descriptor, kept),
        std::map<uint32_t, std::vector<std::byte>>{{0, value}});
}

template <class Function>
const Function& functionOf(const void* block) {
    return **static_cast<const Function* const*>(block);
}

struct SurfaceFunctions {
    Shade shade;
    Transparency transparency;
};

inline std::shared_ptr<const ShaderObject> makeSurface(Shade shade) {
    RTshaderclass d{};
    d.kind = RT_SURFACE_SHADER;
    d.shade = [](const void* block, RTSstate* s) { return functionOf<Shade>(block)(s); };
    return makeShader(d, std::move(shade));
}

inline std::shared_ptr<const ShaderObject> makeTransparentSurface(Shade shade, Transparency left) {
    RTshaderclass d{};
    d.kind = RT_SURFACE_SHADER;
    d.shade = [](const void* block, RTSstate* s) {
        return functionOf<SurfaceFunctions>(block).shade(s);
    };
    d.transparency = [](const void* block, RTSstate* s, float rgb[3]) {
        return functionOf<SurfaceFunctions>(block).transparency(s, rgb);
    };
    return makeShader(d, SurfaceFunctions{std::move(shade), std::move(left)});
}

inline std::shared_ptr<const ShaderObject> makeEnvironment(Shade shade) {
    RTshaderclass d{};
    d.kind = RT_ENV_SHADER;
    d.shade = [](const void* block, RTSstate* s) { return functionOf<Shade>(block)(s); };
    return makeShader(d, std::move(shade));
}

inline std::shared_ptr<const ShaderObject> makeLight(Illuminate illuminate) {
    RTshaderclass d{};
    d.kind = RT_LIGHT_SHADER;
    d.illuminate = [](const void* block, const float p[3], RTSlightsample* sample) {
        return functionOf<Illuminate>(block)(p, sample);
    };
    return makeShader(d, std::move(illuminate));
}

inline std::shared_ptr<const ShaderObject> makeCamera(CameraRay cameraRay) {
    RTshaderclass d{};
    d.kind = RT_CAMERA_SHADER;
    d.cameraRay = [](const void* block, float x, float y, RTScameraray* ray) {
        return functionOf<CameraRay>(block)(x, y, ray);
    };
    return makeShader(d, std::move(cameraRay));
}

inline std::shared_ptr<const ShaderObject> makeRenderingObject(RenderPixel renderPixel) {
    RTshaderclass d{};
    d.kind = RT_RENDERING_OBJECT_SHADER;
    d.renderPixel = [](const void* block, RTSpixel* pixel, float rgba[4]) {
        return functionOf<RenderPixel>(block)(pixel, rgba);
    };
    return makeShader(d, std::move(renderPixel));
}

/// Two triangles, corners (x0, y0) and (x1, y1), facing +z.
inline std::vector<Triangle> rectangle(float x0, float y0, float x1, float y1, float z) {
    return {{{x0, y0, z}, {x1, y0, z}, {x1, y1, z}}, {{x0, y0, z}, {x1, y1, z}, {x0, y1, z}}};
}

inline ScenePtr makeScene(std::vector<Instance> instances,
                          Precision precision = Precision::Watertight) {
    return std::make_shared<const Scene>(std::move(instances), precision, 1u);
}

/// Shader 0 for a model, and one shader more for each further instance.
inline Instance placeWithShader(ModelPtr model, uint32_t shader,
                                const glm::dmat4x3& toParent = glm::dmat4x3(1.0)) {
    Instance instance = place(std::move(model), toParent);
    auto replacement = std::make_shared<ShaderReplacement>();
    replacement->all = true;
    replacement->allBy = shader;
    instance.replacement = std::move(replacement);
    return instance;
}

inline MatrixCamera cameraOf(const glm::dmat4& projection) {
    return {projection, glm::inverse(projection)};
}

/// A frame with memory of its own for an RGBA picture of floats.
struct Picture {
    std::vector<glm::vec4> pixels;
    std::vector<float> depth, distance;
    std::vector<glm::vec3> normals;
    std::vector<uint32_t> objects, instances, primitives;
    std::shared_ptr<Frame> frame = std::make_shared<Frame>();

    Picture(uint32_t width, uint32_t height, ScenePtr scene,
            std::vector<std::shared_ptr<const ShaderObject>> shaders)
        : pixels(std::size_t(width) * height, glm::vec4(-1.0f)),
          depth(pixels.size()),
          distance(pixels.size()),
          normals(pixels.size()),
          objects(pixels.size()),
          instances(pixels.size()),
          primitives(pixels.size()) {
        frame->id = 1;
        frame->scene = std::move(scene);
        frame->shaders = std::make_shared<const ShaderTable>(std::move(shaders));
        frame->viewport = {0, 0, width, height};
        frame->matrixCamera = cameraOf(glm::perspective(1.0, double(width) / height, 0.5, 100.0));
        frame->target.memory = pixels.data();
        frame->target.width = width;
        frame->target.height = height;
        frame->target.format = PixelFormat::Rgba32f;
        frame->target.aux = {
            depth.data(),   distance.data(),  reinterpret_cast<float*>(normals.data()),
            objects.data(), instances.data(), primitives.data()};
    }

    const glm::vec4& at(uint32_t x, uint32_t y) const {
        return pixels[std::size_t(y) * frame->target.width + x];
    }
};

/// Renders on this thread, tile after tile; returns what was counted.
inline RenderStatistics renderHere(const Picture& picture) {
    FrameQueue queue(1);
    const QueuedFramePtr queued = queue.prepare(picture.frame);
    queue.submit(queued);
    queue.close();
    work(queue, PacketTracer());
    if (queued->wait() == FrameStatus::Failed) std::rethrow_exception(queued->takeError());
    return queued->statistics();
}

} // namespace smart::test
