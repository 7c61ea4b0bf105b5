// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "libsmart/base/aabb.h"
#include "libsmart/render/fragments.h"
#include "libsmart/render/frame_shading.h"
#include "libsmart/render/framebuffer.h"
#include "libsmart/scene/scene.h"
#include "libsmart/shading/shader_registry.h"
#include "libsmart/shading/texture.h"

namespace smart {

/// Rectangle of the picture that the camera fills; elsewhere is the clear colour.
struct Viewport {
    int32_t x = 0, y = 0;
    uint32_t width = 0, height = 0;

    bool operator==(const Viewport&) const = default;
    bool contains(uint32_t column, uint32_t row) const {
        const int64_t i = int64_t(column) - x, j = int64_t(row) - y;
        return i >= 0 && i < int64_t(width) && j >= 0 && j < int64_t(height);
    }
};

/// What is written to the buffers before a layer's primitives.
struct BufferClear {
    std::optional<Viewport> scissor; ///< empty: the whole picture
    bool colorMask[4] = {false, false, false, false};
    glm::vec4 color{0.0f};
    std::optional<float> depth;
};

/// The camera of OpenGL: the eye at the origin of eye space, rays from the near to the far plane.
/// window depth and rays follow the inverse of the projection matrix.
struct MatrixCamera {
    glm::dmat4 projection{1.0};
    glm::dmat4 inverse{1.0}; ///< of projection; a singular projection is refused earlier
};

/// What the state blocks of a layer's instances ask of its camera rays.
struct LayerNeeds {
    bool collects = false; ///< all hits of a ray matter, not the nearest alone
    bool sifts = false;    ///< hits may not count: culled, clipped, not filled
    /// What lies behind an opaque hit is not to be seen, whenever it was drawn.
    bool opaqueHides = true;
    /// Among opaque hits that are equally far it is not the one that the search finds that shows.
    bool equalsDiffer = false;
    /// What is not opaque lies in these boxes; empty where they would be too many to look at.
    std::vector<Aabb> seeThrough;

    /// Whether an opaque hit there has nothing at its own place that may show as well.
    bool isAlone(const glm::vec3& place) const;
};
LayerNeeds findLayerNeeds(const Scene& scene);

/// Everything one picture needs; nothing in it changes while a worker holds it. It may be made of
/// layers, each a frame with its own scene and camera, which are drawn over each other; the frame
/// itself is the topmost.
struct Frame {
    uint64_t id = 0;
    ScenePtr scene;
    std::shared_ptr<const ShaderTable> shaders;   ///< by shader index
    std::shared_ptr<const TextureTable> textures; ///< by texture id
    std::vector<std::shared_ptr<const ShaderObject>> lights;
    std::shared_ptr<const ShaderObject> environment;     ///< nullptr: the clear colour
    std::shared_ptr<const ShaderObject> camera;          ///< nullptr: matrixCamera
    std::shared_ptr<const ShaderObject> renderingObject; ///< nullptr: the default one
    MatrixCamera matrixCamera;
    glm::vec4 clearColor{0.0f};
    Viewport viewport;
    uint32_t samples = 1;
    uint32_t seed = 0;
    uint32_t recursionLimit = 8; ///< generations of secondary rays; kMaxRecursion at most
    float weightCutoff = 1.0f / 512.0f;
    PixelTarget target;

    // Of layers; an ordinary frame has none of it.
    std::vector<std::shared_ptr<const Frame>> below; ///< bottom first; below those is nothing
    float clearDepth = 1.0f;        ///< of the whole picture at the start, as clearColor is
    std::vector<BufferClear> clears; ///< before this layer, in this order
    std::optional<Viewport> scissor; ///< pixels that the layer may change; empty: all
    float depthNear = 0.0f, depthFar = 1.0f; ///< window depth of the near and the far plane
    uint32_t firstInstance = 0;              ///< number of its first instance in the picture
    bool drawsColor = true;
    std::shared_ptr<const FragmentSource> primitives; ///< nullptr: none

    /// Keeps what the shaders of models and replacements need alive.
    std::vector<std::shared_ptr<const void>> keepAlive;

    /// What the shaders amount to; found at the first question. Thread-safe.
    const FrameShading& shading() const { return found().shading; }
    /// What its instances' state blocks ask for; likewise.
    const LayerNeeds& needs() const { return found().needs; }
    /// Whether more is to be done than to show the nearest hit of each ray.
    bool isLayered() const;

private:
    struct Found {
        FrameShading shading;
        LayerNeeds needs;
    };
    /// A copy of a frame finds anew: shaders and scene may be exchanged in it.
    struct FoundOnce {
        FoundOnce() = default;
        FoundOnce(const FoundOnce&) {}
        std::once_flag once;
        Found found;
    };
    const Found& found() const;

    mutable FoundOnce found_;
};

/// A larger recursionLimit counts as this: threads have stacks of limited size.
inline constexpr uint32_t kMaxRecursion = 256;

} // namespace smart
