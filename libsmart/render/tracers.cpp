// SPDX-License-Identifier: MIT
#include "libsmart/render/tracers.h"

#include "libsmart/shading/builtin/ambient_occlusion.h"
#include "libsmart/shading/builtin/glass.h"
#include "libsmart/shading/builtin/metallic_roughness.h"
#include "libsmart/shading/builtin/surfaces.h"

namespace smart {
namespace {

/// A tracer that is never destroyed: at the end of a process that did not end the library first,
/// workers may still be rendering.
template <class Shading>
const Tracer& lasting(ShadingForm form) {
    static const Tracer* const packets = new PacketTracer<Shading>(ShadingForm::Packets);
    static const Tracer* const points = new PacketTracer<Shading>(ShadingForm::Points);
    return form == ShadingForm::Packets ? *packets : *points;
}

template <class S>
const Tracer* fixedTracer(const FrameShading& shading, ShadingForm form) {
    return FixedShading<S>::serves(shading) ? &lasting<FixedShading<S>>(form) : nullptr;
}

template <class... Surfaces>
const Tracer* firstOf(const FrameShading& shading, ShadingForm form) {
    const Tracer* found = nullptr;
    ((found = found ? found : fixedTracer<Surfaces>(shading, form)), ...);
    return found;
}

} // namespace

const Tracer& tracerFor(const FrameShading& shading, ShadingForm form) {
    using namespace builtin;
    const Tracer* const fixed =
        firstOf<FixedFunction, ConstantShader, DiffuseShader, TexturedDiffuseShader, TextureShader,
                MirrorShader, Phong, MetallicRoughness, Glass, AmbientOcclusion>(
            shading, form);
    return fixed ? *fixed : lasting<DynamicShading>(form);
}

} // namespace smart
