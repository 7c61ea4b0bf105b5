// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "compat/recorder/attributes.h"
#include "compat/recorder/primitive_assembler.h"
#include "compat/recorder/shader_catalog.h"
#include "libsmart/geometry/model_builder.h"

namespace smart::compat {

/// A shader that geometry uses, in order of first use.
struct UsedShader {
    uint32_t index; ///< Shader::index()
    uint32_t id;
};

/// The geometry of an object under definition or of a run of loose primitives: latches
/// attributes, shaders and parameters, and compiles them into a model. A function that throws
/// has changed nothing.
class GeometryRecording {
public:
    bool empty() const { return vertexCount_ == 0 && builder_.children.empty(); }
    /// Whether there is something to see: triangles, or what is drawn in pixels.
    bool hasPrimitives() const { return triangleCount() > 0 || !builder_.pixels.empty(); }
    uint32_t triangleCount() const { return uint32_t(builder_.triangles.size()); }
    const std::vector<UsedShader>& usedShaders() const { return usedShaders_; }
    uint32_t levels() const { return levels_; }

    /// What the geometry sets on its own: from the next vertex on, it is stored.
    AttributesGiven given;

    void begin(Primitive primitive) noexcept {
        assembler_.begin(primitive);
        continuesRun_ = false;
    }
    /// `normal` is the attributes' in the geometry's space.
    void vertex(const glm::vec3& position, const Attributes& attributes, const glm::vec3& normal,
                const BoundShader& shader);
    /// Draws an image after what there is so far.
    void addImage(std::shared_ptr<const WindowImage> image);
    /// Places another model of so many levels.
    void addChild(Instance child, uint32_t childLevels, const std::vector<UsedShader>& shaders);

    /// Builds the model and empties the recording; one that throws left it as it was.
    ModelPtr compile(const ModelBuildOptions& options);
    /// Whether compiling would give this model once more. Recordings that place other models, or
    /// that draw in pixels, never do.
    bool givesAgain(const Model& model) const;

private:
    /// A parameter block written last, to be shared as long as its contents stay the same.
    struct LastBlock {
        uint64_t stamp = 0;
        uint32_t offset = 0;
    };
    void reserveVertex(const Attributes& attributes, const BoundShader& shader);
    void addTriangle(const AssembledTriangle& triangle, const BoundShader& shader) noexcept;
    /// A vertex, numbered vertexCount_, of a point or line.
    void addPixelVertex(const glm::vec3& position) noexcept;
    uint32_t slotOf(const BoundShader& shader) noexcept;
    bool slotsAreNeeded() const { return builder_.shading.shaders.size() > 1; }
    /// Number of the materials among those of the geometry; room was made.
    uint32_t materialsNumber(const std::shared_ptr<const FixedMaterials>& materials) noexcept;

    ModelBuilder builder_;
    PrimitiveAssembler assembler_;
    std::vector<glm::vec3> positions_;
    uint32_t vertexCount_ = 0;
    bool continuesRun_ = false; ///< the last of the pixels' runs is of the primitive under way
    LastBlock lastTriangleBlock_, lastVertexBlock_;
    uint32_t lastSlot_ = 0;
    std::vector<UsedShader> usedShaders_;
    uint32_t levels_ = 1;
};

} // namespace smart::compat
