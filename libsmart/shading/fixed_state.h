// SPDX-License-Identifier: MIT
// OpenGL's fixed-function state, as much of it as a picture depends on. Positions and planes are in
// eye space, as OpenGL keeps them.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

namespace smart {

class Texture;

inline constexpr int kFixedLights = 8;
inline constexpr int kFixedClipPlanes = 6;
/// The largest size of points and width of lines, in pixels.
inline constexpr float kMaxPixelSize = 255.0f;

/// One side's material (OpenGL 1.5, table 6.8); reflection is ours.
struct FixedMaterial {
    glm::vec4 ambient{0.2f, 0.2f, 0.2f, 1.0f};
    glm::vec4 diffuse{0.8f, 0.8f, 0.8f, 1.0f};
    glm::vec4 specular{0.0f, 0.0f, 0.0f, 1.0f};
    glm::vec4 emission{0.0f, 0.0f, 0.0f, 1.0f};
    float shininess = 0.0f;
    float reflection = 0.0f; ///< 0..1: share of what is seen in the mirror direction

    bool operator==(const FixedMaterial&) const = default;
};

/// What a vertex latches.
struct FixedMaterials {
    FixedMaterial front, back;
    bool operator==(const FixedMaterials&) const = default;
};

struct FixedLight {
    bool enabled = false;
    glm::vec4 ambient{0.0f, 0.0f, 0.0f, 1.0f};
    glm::vec4 diffuse{0.0f, 0.0f, 0.0f, 1.0f};  ///< light 0 starts white
    glm::vec4 specular{0.0f, 0.0f, 0.0f, 1.0f}; ///< light 0 starts white
    glm::vec4 position{0.0f, 0.0f, 1.0f, 0.0f};
    glm::vec3 spotDirection{0.0f, 0.0f, -1.0f};
    float spotExponent = 0.0f;
    float spotCutoff = 180.0f; ///< degrees, 0..90 or 180
    float constantAttenuation = 1.0f, linearAttenuation = 0.0f, quadraticAttenuation = 0.0f;

    bool operator==(const FixedLight&) const = default;
};

enum class ShadeModel : uint8_t { Flat, Smooth, Phong };
/// Which components of the material follow the colour of vertices.
enum class ColorMaterialMode : uint8_t { Emission, Ambient, Diffuse, Specular, AmbientAndDiffuse };
enum class FixedFace : uint8_t { Front, Back, FrontAndBack };

struct FixedLighting {
    bool enabled = false;
    bool normalize = false, rescaleNormal = false;
    bool twoSided = false, localViewer = false, separateSpecular = false;
    bool colorMaterial = false;
    bool colorSum = false; ///< the vertices' secondary colour is added, without lighting
    ColorMaterialMode colorMaterialMode = ColorMaterialMode::AmbientAndDiffuse;
    FixedFace colorMaterialFace = FixedFace::FrontAndBack;
    ShadeModel shadeModel = ShadeModel::Smooth;
    glm::vec4 modelAmbient{0.2f, 0.2f, 0.2f, 1.0f};
    FixedLight lights[kFixedLights];
    bool shadows = false, reflections = false;

    /// Whether fragments have a secondary colour.
    bool hasSecondary() const { return enabled ? separateSpecular : colorSum; }
    bool operator==(const FixedLighting&) const = default;
};

enum class FogMode : uint8_t { Linear, Exp, Exp2 };

struct FixedFog {
    bool enabled = false;
    bool fromCoordinate = false; ///< RT_FOG_COORD_SRC: the vertices' fog coordinate, not the depth
    FogMode mode = FogMode::Exp;
    float density = 1.0f, start = 0.0f, end = 1.0f;
    glm::vec4 color{0.0f};

    bool operator==(const FixedFog&) const = default;
};

enum class TexGenMode : uint8_t { ObjectLinear, EyeLinear, SphereMap, NormalMap, ReflectionMap };

struct TexGen {
    bool enabled = false;
    TexGenMode mode = TexGenMode::EyeLinear;
    glm::vec4 objectPlane{0.0f}, eyePlane{0.0f}; ///< of s and t: their unit vectors at the start

    bool operator==(const TexGen&) const = default;
};

enum class TexEnvMode : uint8_t { Modulate, Decal, Blend, Replace, Add, Combine };
/// OpenGL 1.5, tables 3.23 to 3.25.
enum class CombineFunction : uint8_t {
    Replace, Modulate, Add, AddSigned, Interpolate, Subtract, Dot3Rgb, Dot3Rgba
};
/// From Texture0 on, the texture of the unit with that number.
enum class CombineSource : uint8_t { Texture, Constant, PrimaryColor, Previous, Texture0 };
enum class CombineOperand : uint8_t { Color, OneMinusColor, Alpha, OneMinusAlpha };

struct TexEnvCombine {
    CombineFunction rgb = CombineFunction::Modulate, alpha = CombineFunction::Modulate;
    CombineSource rgbSource[3] = {CombineSource::Texture, CombineSource::Previous,
                                  CombineSource::Constant};
    CombineSource alphaSource[3] = {CombineSource::Texture, CombineSource::Previous,
                                    CombineSource::Constant};
    CombineOperand rgbOperand[3] = {CombineOperand::Color, CombineOperand::Color,
                                    CombineOperand::Alpha};
    CombineOperand alphaOperand[3] = {CombineOperand::Alpha, CombineOperand::Alpha,
                                      CombineOperand::Alpha};
    float rgbScale = 1.0f, alphaScale = 1.0f;

    bool operator==(const TexEnvCombine&) const = default;
};

/// A texture unit.
struct FixedTexture {
    bool enabled1D = false, enabled2D = false; ///< 2D goes before 1D
    uint32_t texture1D = 0, texture2D = 0;     ///< what is bound
    /// The enabled one as it was when the block was made; nullptr: none, or an incomplete one.
    std::shared_ptr<const Texture> image;
    TexEnvMode mode = TexEnvMode::Modulate;
    glm::vec4 color{0.0f};
    float lodBias = 0.0f;
    TexEnvCombine combine;
    TexGen generate[4]{{false, TexGenMode::EyeLinear, {1, 0, 0, 0}, {1, 0, 0, 0}},
                       {false, TexGenMode::EyeLinear, {0, 1, 0, 0}, {0, 1, 0, 0}},
                       {},
                       {}}; ///< s, t, r, q
    glm::dmat4 matrix{1.0};

    bool operator==(const FixedTexture&) const = default;
};

enum class CompareFunction : uint8_t {
    Never, Less, Equal, LessEqual, Greater, NotEqual, GreaterEqual, Always
};
enum class BlendFactor : uint8_t {
    Zero, One, SourceColor, OneMinusSourceColor, DestinationColor, OneMinusDestinationColor,
    SourceAlpha, OneMinusSourceAlpha, DestinationAlpha, OneMinusDestinationAlpha, ConstantColor,
    OneMinusConstantColor, ConstantAlpha, OneMinusConstantAlpha, SourceAlphaSaturate
};
enum class BlendEquation : uint8_t { Add, Subtract, ReverseSubtract, Min, Max };

/// What becomes of a fragment (OpenGL 1.5, chapter 4).
struct FixedFragmentOps {
    bool alphaTest = false;
    CompareFunction alphaFunction = CompareFunction::Always;
    float alphaReference = 0.0f;
    bool depthTest = false;
    CompareFunction depthFunction = CompareFunction::Less;
    bool depthMask = true;
    bool blend = false;
    BlendEquation blendEquation = BlendEquation::Add;
    BlendFactor sourceRgb = BlendFactor::One, destinationRgb = BlendFactor::Zero;
    BlendFactor sourceAlpha = BlendFactor::One, destinationAlpha = BlendFactor::Zero;
    glm::vec4 blendColor{0.0f};
    bool colorLogicOp = false;
    uint8_t logicOp = 3; ///< the token's last four bits; copy
    bool colorMask[4] = {true, true, true, true};

    bool operator==(const FixedFragmentOps&) const = default;
};

enum class FixedPolygonMode : uint8_t { Point, Line, Fill };

struct FixedRaster {
    bool cull = false;
    FixedFace cullFace = FixedFace::Back;
    bool frontFaceClockwise = false;
    FixedPolygonMode polygonMode[2] = {FixedPolygonMode::Fill, FixedPolygonMode::Fill};
    bool offsetFill = false, offsetLine = false, offsetPoint = false;
    float offsetFactor = 0.0f, offsetUnits = 0.0f;
    bool polygonStippled = false;
    uint32_t polygonStipple[32]; ///< rows from the bottom, most significant bit leftmost
    float pointSize = 1.0f, lineWidth = 1.0f;
    float pointSizeMin = 0.0f, pointSizeMax = kMaxPixelSize;
    float pointFadeThreshold = 1.0f;
    glm::vec3 pointAttenuation{1.0f, 0.0f, 0.0f}; ///< constant, linear, quadratic
    bool pointSmooth = false, lineSmooth = false, polygonSmooth = false;
    bool lineStippled = false;
    uint16_t linePattern = 0xFFFF;
    int lineFactor = 1;
    bool clip[kFixedClipPlanes] = {};
    glm::dvec4 clipPlane[kFixedClipPlanes] = {};

    FixedRaster() {
        for (uint32_t& row : polygonStipple) row = 0xFFFFFFFFu;
    }
    bool operator==(const FixedRaster&) const = default;
};

/// One state block: immutable once it is shared.
struct FixedState {
    FixedLighting lighting;
    FixedFog fog;
    FixedTexture texture;
    /// The units after the first, up to the last one with a texture.
    std::vector<FixedTexture> moreTextures;
    FixedFragmentOps ops;
    FixedRaster raster;

    FixedState();
    bool operator==(const FixedState&) const = default;

    bool isTextured() const { return texture.image || !moreTextures.empty(); }
    /// Whether the nearest hit decides a pixel: depth test on with RT_LESS or RT_LEQUAL, nothing
    /// blended, masked, offset, tested by alpha or combined by a logical operation.
    bool isOpaque() const;
};

using FixedStatePtr = std::shared_ptr<const FixedState>;

} // namespace smart
