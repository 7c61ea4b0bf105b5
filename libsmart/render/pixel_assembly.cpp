// SPDX-License-Identifier: MIT
#include "libsmart/render/pixel_assembly.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "libsmart/geometry/model.h"
#include "libsmart/render/line_raster.h"
#include "libsmart/render/point_raster.h"
#include "libsmart/shading/corner_attributes.h"
#include "libsmart/shading/fixed_triangle.h"

namespace smart {
namespace {

glm::dmat4 squareMatrix(const glm::dmat4x3& m) {
    return {glm::dvec4(m[0], 0.0), glm::dvec4(m[1], 0.0), glm::dvec4(m[2], 0.0),
            glm::dvec4(m[3], 1.0)};
}

/// Inverse transpose; of a singular matrix the cofactors.
glm::dmat3 normalMatrix(const glm::dmat4x3& matrix) {
    const glm::dvec3 x = matrix[0], y = matrix[1], z = matrix[2];
    const glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
    const double determinant = glm::dot(x, cofactors[0]);
    return determinant != 0.0 ? cofactors / determinant : cofactors;
}

bool drawsEdges(const FixedState* state) {
    if (!state) return false;
    const FixedRaster& raster = state->raster;
    return raster.polygonMode[0] != FixedPolygonMode::Fill ||
           raster.polygonMode[1] != FixedPolygonMode::Fill;
}

/// Vertices of points and lines as fixed function has them.
class RunReader {
public:
    explicit RunReader(const HitChain& chain)
        : chain_(chain),
          attributes_(chain),
          normals_(normalMatrix(chain.toWorld)),
          normalScale_(rescaleFactor(chain.toWorld)) {}

    FixedVertex read(const PixelRun& run, uint32_t i) const {
        const ShadingData& shading = chain_.model->shading;
        const uint32_t number = run.firstVertex + i;
        using Inherited = InheritedAttributes;
        FixedVertex vertex;
        vertex.objectPosition = glm::dvec4(chain_.model->pixels.positions[run.first + i], 1.0f);
        vertex.position = chain_.toWorld * vertex.objectPosition;
        vertex.normal =
            normals_ * glm::dvec3(value(number, shading.normals, shading.firstNormal,
                                        &Inherited::ownNormal, &Inherited::normal));
        vertex.normalScale = normalScale_;
        vertex.color = value(number, shading.colors, shading.firstColor, &Inherited::ownColor,
                             &Inherited::color);
        vertex.texCoord = value(number, shading.texCoords, shading.firstTexCoord,
                                &Inherited::ownTexCoord, &Inherited::texCoord);
        vertex.secondaryColor =
            value(number, shading.secondaryColors, shading.firstSecondaryColor,
                  &Inherited::ownSecondaryColor, &Inherited::secondaryColor);
        vertex.fogCoordinate =
            value(number, shading.fogCoordinates, shading.firstFogCoordinate,
                  &Inherited::ownFogCoordinate, &Inherited::fogCoordinate);
        vertex.materials =
            number >= shading.firstMaterial
                ? shading.materials[shading.vertexMaterials[number - shading.firstMaterial]].get()
                : attributes_.inheritedValue(&Inherited::ownMaterials, &Inherited::materials)
                      .get();
        const std::vector<UnitTexCoords>& units = shading.moreTexCoords;
        const FixedState* const state = chain_.instances[0]->traits->state.get();
        for (std::size_t unit = 0; state && unit < state->moreTextures.size(); ++unit)
            vertex.moreTexCoords[unit] =
                !units.empty() && number >= units[unit].first
                    ? units[unit].values[number - units[unit].first]
                    : attributes_.inheritedTexCoord(unit);
        return vertex;
    }

private:
    template <class T>
    const T& value(uint32_t number, const std::vector<T>& values, uint32_t first,
                   bool InheritedAttributes::*own, T InheritedAttributes::*inherited) const {
        return number >= first ? values[number - first]
                               : attributes_.inheritedValue(own, inherited);
    }

    const HitChain& chain_;
    const CornerAttributes attributes_;
    const glm::dmat3 normals_;
    const double normalScale_;
};

/// Sum over a polygon's corners that is along its normal in (x, y, depth), after Newell; z is
/// twice its area, positive where it is seen counter-clockwise.
glm::dvec3 windowNormal(const std::vector<WindowVertex>& polygon) {
    glm::dvec3 sum(0.0);
    const WindowVertex& origin = polygon[0];
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const glm::dvec3 a(polygon[i].at - origin.at, polygon[i].depth - origin.depth);
        const glm::dvec3 b(polygon[i + 1].at - origin.at, polygon[i + 1].depth - origin.depth);
        sum += glm::cross(a, b);
    }
    return sum;
}

class PixelAssembler {
public:
    explicit PixelAssembler(const Frame& layer)
        : projection_(layer.matrixCamera.projection),
          hasProjection_(!layer.camera),
          toWindow_(layer.viewport, layer.depthNear, layer.depthFar) {}

    void addScene(const Scene& scene) {
        const std::span<const InstanceView> instances = scene.group().instances();
        for (std::size_t i = 0; i < instances.size(); ++i) {
            const InstanceTraits& traits = *instances[i].traits;
            instance_ = uint32_t(i);
            state_ = traits.state.get();
            volume_ = ClipVolume(state_);
            drawsEdges_ = drawsEdges(state_);
            HitChain chain{};
            if (traits.model && (drawsEdges_ || traits.model->drawsPixels))
                addInstance(instances[i], chain, squareMatrix(toParent(instances[i])));
        }
    }
    PixelItems take() { return std::move(result_); }

private:
    void addInstance(const InstanceView& instance, HitChain chain, const glm::dmat4& toWorld) {
        chain.instances[chain.levels++] = &instance;
        chain.model = instance.traits->model.get();
        chain.toWorld = glm::dmat4x3(toWorld);
        addModel(chain);
        for (const InstanceView& child : chain.model->children.instances()) {
            const Model* const model = child.traits->model.get();
            if (model && (drawsEdges_ || model->drawsPixels))
                addInstance(child, chain, toWorld * squareMatrix(toParent(child)));
        }
    }

    void addModel(HitChain& chain) {
        const Model& model = *chain.model;
        std::size_t run = 0;
        const std::vector<PixelRun>& runs = model.pixels.runs;
        if (drawsEdges_ && hasProjection_)
            for (uint32_t triangle = 0; triangle < model.triangles.size(); ++triangle) {
                for (; run < runs.size() && runs[run].beforeTriangle <= triangle; ++run)
                    addRun(chain, runs[run]);
                order_ = orderOfInstance(instance_,
                                         chain.levels == 1 ? triangle : kLastNested);
                chain.triangle = triangle;
                addTriangle(chain);
            }
        for (; run < runs.size(); ++run) addRun(chain, runs[run]);
    }

    void addRun(const HitChain& chain, const PixelRun& run) {
        // That of the triangle before, which it follows.
        if (chain.levels > 1)
            order_ = orderOfInstance(instance_, kLastNested);
        else if (run.beforeTriangle > 0)
            order_ = orderOfInstance(instance_, run.beforeTriangle - 1);
        else
            order_ = orderBeforeInstance(instance_, 0);
        if (run.kind == PixelRun::Kind::Image) {
            PixelItems::Image& image = add(result_.images, PixelItems::Kind::Image);
            image.image = chain.model->pixels.images[run.first].get();
            return;
        }
        if (!hasProjection_) return;
        const RunReader reader(chain);
        vertices_.clear();
        for (uint32_t i = 0; i < run.count; ++i)
            vertices_.push_back(clipVertex(reader.read(run, i)));
        if (run.kind == PixelRun::Kind::Points) {
            for (const ClipVertex& vertex : vertices_)
                if (vertex.isFinite() && volume_.contains(vertex))
                    addPoint(toWindow_(vertex), vertex.eye);
            return;
        }
        const bool apart = run.kind == PixelRun::Kind::Lines;
        stipple_ = 0;
        for (uint32_t i = 0; i + 1 < run.count; i += apart ? 2 : 1) {
            if (apart) stipple_ = 0;
            addSegment(vertices_[i], vertices_[i + 1]);
        }
        if (run.kind == PixelRun::Kind::LineLoop && run.count > 1)
            addSegment(vertices_[run.count - 1], vertices_[0]);
    }

    ClipVertex clipVertex(const FixedVertex& vertex) const {
        ClipVertex result;
        result.eye = vertex.position;
        result.clip = projection_ * glm::dvec4(vertex.position, 1.0);
        if (state_)
            result.lit = litVertex(*state_, vertex, false);
        else
            result.lit.primary = vertex.color;
        return result;
    }

    void addSegment(ClipVertex a, ClipVertex b) {
        if (!a.isFinite() || !b.isFinite()) return;
        if (state_ && state_->lighting.shadeModel == ShadeModel::Flat) {
            a.lit.primary = b.lit.primary;
            a.lit.secondary = b.lit.secondary;
        }
        const ClipVolume::Line left = volume_.clipLine(a, b);
        if (left == ClipVolume::Line::Gone) return;
        const WindowVertex from = toWindow_(a);
        WindowVertex to = toWindow_(b);
        // A line that goes on leaves the last pixel, if only just.
        const double length = glm::length(to.at - from.at);
        if (left == ClipVolume::Line::EndCut && length > 0.0)
            to = between(from, to, 1.0 + 1.5 / (kSubpixels * length));
        addLine(from, to);
    }

    // Edges or corners of a triangle, as the state asks for on the side that is seen.
    void addTriangle(const HitChain& chain) {
        const Triangle& given = chain.model->triangles[chain.triangle];
        const float* const corners[] = {given.v0, given.v1, given.v2};
        polygon_.clear();
        for (const float* corner : corners) {
            ClipVertex& vertex = polygon_.emplace_back();
            vertex.eye = chain.toWorld * glm::dvec4(corner[0], corner[1], corner[2], 1.0);
            vertex.clip = projection_ * glm::dvec4(vertex.eye, 1.0);
            if (!vertex.isFinite()) return;
        }
        const std::vector<uint8_t>& boundary = chain.model->shading.boundary;
        const unsigned edges = boundary.empty() ? 7u : boundary[chain.triangle];
        drawn_ = {(edges & 1u) != 0, (edges & 2u) != 0, (edges & 4u) != 0};

        const std::vector<ClipVertex> unclipped = polygon_;
        std::vector<bool> drawn = drawn_;
        volume_.clipPolygon(polygon_, drawn);
        if (polygon_.size() < 3) return;
        window_.clear();
        for (const ClipVertex& vertex : polygon_) window_.push_back(toWindow_(vertex));
        const glm::dvec3 normal = windowNormal(window_);

        const FixedRaster& raster = state_->raster;
        const bool back = (normal.z > 0.0) == raster.frontFaceClockwise;
        const bool culled = raster.cull && (raster.cullFace == FixedFace::FrontAndBack ||
                                            (raster.cullFace == FixedFace::Back) == back);
        const FixedPolygonMode mode = raster.polygonMode[back];
        if (culled || mode == FixedPolygonMode::Fill) return;

        polygon_ = unclipped;
        FixedTriangle triangle(chain, {});
        for (int i = 0; i < 3; ++i) {
            glm::dvec3 weights(0.0);
            weights[i] = 1.0;
            polygon_[std::size_t(i)].lit = triangle.at(weights, back);
        }
        volume_.clipPolygon(polygon_, drawn_);
        const bool offset = mode == FixedPolygonMode::Line ? raster.offsetLine : raster.offsetPoint;
        const double moved = offset ? depthOffset(raster, normal) : 0.0;
        for (std::size_t i = 0; i < window_.size(); ++i) {
            window_[i].depth += moved;
            window_[i].lit = polygon_[i].lit;
        }
        stipple_ = 0;
        for (std::size_t i = 0; i < window_.size(); ++i) {
            if (!drawn_[i]) continue;
            if (mode == FixedPolygonMode::Line)
                addLine(window_[i], window_[(i + 1) % window_.size()]);
            else
                addPoint(window_[i], polygon_[i].eye);
        }
    }

    // OpenGL 1.5, section 3.5.5.
    static double depthOffset(const FixedRaster& raster, const glm::dvec3& normal) {
        const double slope =
            std::max(std::abs(normal.x), std::abs(normal.y)) / std::abs(normal.z);
        const double offset = raster.offsetFactor * (std::isfinite(slope) ? slope : 0.0) +
                              double(raster.offsetUnits) * kDepthUnit;
        return std::isfinite(offset) ? offset : 0.0;
    }

    void addPoint(const WindowVertex& at, const glm::dvec3& eye) {
        for (int k = 0; k < 2; ++k)
            if (!(at.at[k] >= kWindowMin && at.at[k] <= kWindowMax)) return;
        PixelItems::Point& point = add(result_.points, PixelItems::Kind::Point);
        point.at = at;
        if (state_) point.size = pointSizeAt(state_->raster, eye);
    }

    void addLine(WindowVertex a, WindowVertex b) {
        if (!cutToWindow(a, b)) return;
        PixelItems::Line& line = add(result_.lines, PixelItems::Kind::Line);
        line.from = a;
        line.to = b;
        line.stippleStart = stipple_;
        if (state_ && state_->raster.lineStippled)
            stipple_ += LineCoverage(a.at, b.at, wholePixels(state_->raster.lineWidth)).length();
    }

    template <class T>
    T& add(std::vector<T>& list, PixelItems::Kind kind) {
        result_.items.push_back({kind, uint32_t(list.size())});
        T& item = list.emplace_back();
        item.state = state_;
        item.order = order_;
        return item;
    }

    const glm::dmat4 projection_;
    const bool hasProjection_;
    const WindowTransform toWindow_;
    PixelItems result_;

    // Of the scene's instance under way, and of the primitive.
    uint32_t instance_ = 0;
    const FixedState* state_ = nullptr;
    ClipVolume volume_{nullptr};
    bool drawsEdges_ = false;
    uint64_t order_ = 0;
    uint32_t stipple_ = 0;
    std::vector<ClipVertex> vertices_, polygon_;
    std::vector<bool> drawn_;
    std::vector<WindowVertex> window_;
};

} // namespace

bool drawsPixels(const Scene& scene) {
    return std::ranges::any_of(scene.group().traits(), [](const auto& traits) {
        return traits->model && (traits->model->drawsPixels || drawsEdges(traits->state.get()));
    });
}

PixelItems assemblePixels(const Frame& layer) {
    PixelAssembler assembler(layer);
    assembler.addScene(*layer.scene);
    return assembler.take();
}

} // namespace smart
