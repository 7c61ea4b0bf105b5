// SPDX-License-Identifier: MIT
#include "compat/openrt/fixed_tokens.h"

#include <cstddef>

#include "compat/openrt/guard.h"
#include "libsmart/geometry/texture_units.h"
#include "openrt/enums.h"

namespace smart::compat {

namespace {

template <class T>
struct Named {
    RTenum token;
    T value;
};

template <class T, std::size_t n>
T valueOf(const Named<T> (&names)[n], RTenum token, const char* what) {
    for (const Named<T>& name : names)
        if (name.token == token) return name.value;
    throwError(ErrorCode::InvalidEnum, what);
}

template <class T, std::size_t n>
RTenum tokenIn(const Named<T> (&names)[n], T value) {
    for (const Named<T>& name : names)
        if (name.value == value) return name.token;
    return RT_INVALID;
}

constexpr Named<FixedFace> kFaces[] = {{RT_FRONT, FixedFace::Front},
                                       {RT_BACK, FixedFace::Back},
                                       {RT_FRONT_AND_BACK, FixedFace::FrontAndBack}};
constexpr Named<ShadeModel> kShadeModels[] = {{RT_FLAT, ShadeModel::Flat},
                                              {RT_SMOOTH, ShadeModel::Smooth},
                                              {RT_PHONG, ShadeModel::Phong}};
constexpr Named<ColorMaterialMode> kColorMaterialModes[] = {
    {RT_EMISSION, ColorMaterialMode::Emission},
    {RT_AMBIENT, ColorMaterialMode::Ambient},
    {RT_DIFFUSE, ColorMaterialMode::Diffuse},
    {RT_SPECULAR, ColorMaterialMode::Specular},
    {RT_AMBIENT_AND_DIFFUSE, ColorMaterialMode::AmbientAndDiffuse}};
constexpr Named<FogMode> kFogModes[] = {
    {RT_LINEAR, FogMode::Linear}, {RT_EXP, FogMode::Exp}, {RT_EXP2, FogMode::Exp2}};
constexpr Named<CompareFunction> kComparisons[] = {
    {RT_NEVER, CompareFunction::Never},       {RT_LESS, CompareFunction::Less},
    {RT_EQUAL, CompareFunction::Equal},       {RT_LEQUAL, CompareFunction::LessEqual},
    {RT_GREATER, CompareFunction::Greater},   {RT_NOTEQUAL, CompareFunction::NotEqual},
    {RT_GEQUAL, CompareFunction::GreaterEqual}, {RT_ALWAYS, CompareFunction::Always}};
constexpr Named<BlendFactor> kFactors[] = {
    {RT_ZERO, BlendFactor::Zero},
    {RT_ONE, BlendFactor::One},
    {RT_SRC_COLOR, BlendFactor::SourceColor},
    {RT_ONE_MINUS_SRC_COLOR, BlendFactor::OneMinusSourceColor},
    {RT_DST_COLOR, BlendFactor::DestinationColor},
    {RT_ONE_MINUS_DST_COLOR, BlendFactor::OneMinusDestinationColor},
    {RT_SRC_ALPHA, BlendFactor::SourceAlpha},
    {RT_ONE_MINUS_SRC_ALPHA, BlendFactor::OneMinusSourceAlpha},
    {RT_DST_ALPHA, BlendFactor::DestinationAlpha},
    {RT_ONE_MINUS_DST_ALPHA, BlendFactor::OneMinusDestinationAlpha},
    {RT_CONSTANT_COLOR, BlendFactor::ConstantColor},
    {RT_ONE_MINUS_CONSTANT_COLOR, BlendFactor::OneMinusConstantColor},
    {RT_CONSTANT_ALPHA, BlendFactor::ConstantAlpha},
    {RT_ONE_MINUS_CONSTANT_ALPHA, BlendFactor::OneMinusConstantAlpha},
    {RT_SRC_ALPHA_SATURATE, BlendFactor::SourceAlphaSaturate}};
constexpr Named<BlendEquation> kEquations[] = {
    {RT_FUNC_ADD, BlendEquation::Add},
    {RT_FUNC_SUBTRACT, BlendEquation::Subtract},
    {RT_FUNC_REVERSE_SUBTRACT, BlendEquation::ReverseSubtract},
    {RT_MIN, BlendEquation::Min},
    {RT_MAX, BlendEquation::Max}};
constexpr Named<FixedPolygonMode> kPolygonModes[] = {{RT_POINT, FixedPolygonMode::Point},
                                                     {RT_LINE, FixedPolygonMode::Line},
                                                     {RT_FILL, FixedPolygonMode::Fill}};
constexpr Named<TexGenMode> kTexGenModes[] = {{RT_OBJECT_LINEAR, TexGenMode::ObjectLinear},
                                              {RT_EYE_LINEAR, TexGenMode::EyeLinear},
                                              {RT_SPHERE_MAP, TexGenMode::SphereMap},
                                              {RT_NORMAL_MAP, TexGenMode::NormalMap},
                                              {RT_REFLECTION_MAP, TexGenMode::ReflectionMap}};
constexpr Named<TexEnvMode> kTexEnvModes[] = {
    {RT_MODULATE, TexEnvMode::Modulate}, {RT_DECAL, TexEnvMode::Decal},
    {RT_BLEND, TexEnvMode::Blend},       {RT_REPLACE, TexEnvMode::Replace},
    {RT_ADD, TexEnvMode::Add},           {RT_COMBINE, TexEnvMode::Combine}};
constexpr Named<CombineFunction> kCombineFunctions[] = {
    {RT_REPLACE, CombineFunction::Replace},   {RT_MODULATE, CombineFunction::Modulate},
    {RT_ADD, CombineFunction::Add},           {RT_ADD_SIGNED, CombineFunction::AddSigned},
    {RT_INTERPOLATE, CombineFunction::Interpolate},
    {RT_SUBTRACT, CombineFunction::Subtract}, {RT_DOT3_RGB, CombineFunction::Dot3Rgb},
    {RT_DOT3_RGBA, CombineFunction::Dot3Rgba}};
constexpr Named<CombineSource> kCombineSources[] = {{RT_TEXTURE, CombineSource::Texture},
                                                    {RT_CONSTANT, CombineSource::Constant},
                                                    {RT_PRIMARY_COLOR, CombineSource::PrimaryColor},
                                                    {RT_PREVIOUS, CombineSource::Previous}};
constexpr Named<CombineOperand> kCombineOperands[] = {
    {RT_SRC_COLOR, CombineOperand::Color},
    {RT_ONE_MINUS_SRC_COLOR, CombineOperand::OneMinusColor},
    {RT_SRC_ALPHA, CombineOperand::Alpha},
    {RT_ONE_MINUS_SRC_ALPHA, CombineOperand::OneMinusAlpha}};

} // namespace

FixedFace fixedFaceOf(RTenum face) {
    return valueOf(kFaces, face, "a face is RT_FRONT, RT_BACK or RT_FRONT_AND_BACK");
}
ShadeModel shadeModelOf(RTenum mode) {
    return valueOf(kShadeModels, mode, "a shade model is RT_FLAT, RT_SMOOTH or RT_PHONG");
}
ColorMaterialMode colorMaterialModeOf(RTenum mode) {
    return valueOf(kColorMaterialModes, mode, "no part of the material that may follow the colour");
}
FogMode fogModeOf(RTenum mode) {
    return valueOf(kFogModes, mode, "a fog mode is RT_LINEAR, RT_EXP or RT_EXP2");
}
CompareFunction compareFunctionOf(RTenum function) {
    return valueOf(kComparisons, function, "unknown comparison");
}
BlendFactor sourceFactorOf(RTenum factor) {
    return valueOf(kFactors, factor, "unknown blend factor");
}
BlendFactor destinationFactorOf(RTenum factor) {
    if (factor == RT_SRC_ALPHA_SATURATE)
        throwError(ErrorCode::InvalidEnum, "RT_SRC_ALPHA_SATURATE is a factor of the source only");
    return valueOf(kFactors, factor, "unknown blend factor");
}
BlendEquation blendEquationOf(RTenum mode) {
    return valueOf(kEquations, mode, "unknown blend equation");
}
FixedPolygonMode polygonModeOf(RTenum mode) {
    return valueOf(kPolygonModes, mode, "a polygon mode is RT_POINT, RT_LINE or RT_FILL");
}
TexGenMode texGenModeOf(RTenum mode) {
    return valueOf(kTexGenModes, mode, "unknown way of generating texture coordinates");
}
TexEnvMode texEnvModeOf(RTenum mode) {
    return valueOf(kTexEnvModes, mode, "unknown texture environment mode");
}
CombineFunction combineFunctionOf(RTenum function, bool alpha) {
    if (alpha && (function == RT_DOT3_RGB || function == RT_DOT3_RGBA))
        throwError(ErrorCode::InvalidEnum, "alpha components have no dot product");
    return valueOf(kCombineFunctions, function, "unknown combine function");
}
CombineSource combineSourceOf(RTenum source) {
    const std::size_t unit = source - RT_TEXTURE0;
    if (source >= RT_TEXTURE0 && unit < kTextureUnits)
        return CombineSource(std::size_t(CombineSource::Texture0) + unit);
    return valueOf(kCombineSources, source, "unknown source of a combine function");
}
std::size_t textureUnitOf(RTenum unit) {
    if (unit < RT_TEXTURE0 || unit - RT_TEXTURE0 >= kTextureUnits)
        throwError(ErrorCode::InvalidEnum, "the texture units are RT_TEXTURE0 to RT_TEXTURE3");
    return unit - RT_TEXTURE0;
}
CombineOperand combineOperandOf(RTenum operand, bool alpha) {
    if (alpha && (operand == RT_SRC_COLOR || operand == RT_ONE_MINUS_SRC_COLOR))
        throwError(ErrorCode::InvalidEnum, "operands for alpha are alpha components");
    return valueOf(kCombineOperands, operand, "unknown operand of a combine function");
}

RTenum tokenOf(FixedFace face) {
    return tokenIn(kFaces, face);
}
RTenum tokenOf(ShadeModel model) {
    return tokenIn(kShadeModels, model);
}
RTenum tokenOf(ColorMaterialMode mode) {
    return tokenIn(kColorMaterialModes, mode);
}
RTenum tokenOf(FogMode mode) {
    return tokenIn(kFogModes, mode);
}
RTenum tokenOf(CompareFunction function) {
    return tokenIn(kComparisons, function);
}
RTenum tokenOf(BlendFactor factor) {
    return tokenIn(kFactors, factor);
}
RTenum tokenOf(BlendEquation equation) {
    return tokenIn(kEquations, equation);
}
RTenum tokenOf(FixedPolygonMode mode) {
    return tokenIn(kPolygonModes, mode);
}
RTenum tokenOf(TexGenMode mode) {
    return tokenIn(kTexGenModes, mode);
}
RTenum tokenOf(TexEnvMode mode) {
    return tokenIn(kTexEnvModes, mode);
}
RTenum tokenOf(CombineFunction function) {
    return tokenIn(kCombineFunctions, function);
}
RTenum tokenOf(CombineSource source) {
    if (source >= CombineSource::Texture0)
        return RT_TEXTURE0 + (RTenum(source) - RTenum(CombineSource::Texture0));
    return tokenIn(kCombineSources, source);
}
RTenum tokenOf(CombineOperand operand) {
    return tokenIn(kCombineOperands, operand);
}

} // namespace smart::compat
