// SPDX-License-Identifier: MIT
// Tokens of OpenGL's fixed-function state and what they name inside. Functions that take a token
// throw Error (InvalidEnum) for others.
#pragma once

#include <cstddef>

#include "libsmart/shading/fixed_state.h"
#include "openrt/types.h"

namespace smart::compat {

FixedFace fixedFaceOf(RTenum face);
ShadeModel shadeModelOf(RTenum mode);
ColorMaterialMode colorMaterialModeOf(RTenum mode);
FogMode fogModeOf(RTenum mode);
CompareFunction compareFunctionOf(RTenum function);
BlendFactor sourceFactorOf(RTenum factor);
BlendFactor destinationFactorOf(RTenum factor);
BlendEquation blendEquationOf(RTenum mode);
FixedPolygonMode polygonModeOf(RTenum mode);
TexGenMode texGenModeOf(RTenum mode);
TexEnvMode texEnvModeOf(RTenum mode);
/// `alpha`: of the alpha component, which has no dot products.
CombineFunction combineFunctionOf(RTenum function, bool alpha);
CombineSource combineSourceOf(RTenum source);
/// Its number.
std::size_t textureUnitOf(RTenum unit);
/// `alpha`: of the alpha component, which has no colours.
CombineOperand combineOperandOf(RTenum operand, bool alpha);

RTenum tokenOf(FixedFace face);
RTenum tokenOf(ShadeModel model);
RTenum tokenOf(ColorMaterialMode mode);
RTenum tokenOf(FogMode mode);
RTenum tokenOf(CompareFunction function);
RTenum tokenOf(BlendFactor factor);
RTenum tokenOf(BlendEquation equation);
RTenum tokenOf(FixedPolygonMode mode);
RTenum tokenOf(TexGenMode mode);
RTenum tokenOf(TexEnvMode mode);
RTenum tokenOf(CombineFunction function);
RTenum tokenOf(CombineSource source);
RTenum tokenOf(CombineOperand operand);

} // namespace smart::compat
