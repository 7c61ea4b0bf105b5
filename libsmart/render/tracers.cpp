// SPDX-License-Identifier: MIT
#include "libsmart/render/tracers.h"

#include "libsmart/shading/builtin/ambient_occlusion.h"
#include "libsmart/shading/builtin/glass.h"
#include "libsmart/shading/builtin/metallic_roughness.h"
#include "libsmart/shading/builtin/surfaces.h"

namespace smart {
namespace {

template <class S>
const Tracer* fixedTracer(const FrameShading& shading, ShadingForm form) {
    static const PacketTracer<FixedShading<S>> packets(ShadingForm::Packets),
        points(ShadingForm::Points);
    if (!FixedShading<S>::serves(shading)) return nullptr;
    return form == ShadingForm::Packets ? &packets : &points;
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
    static const PacketTracer<> packets(ShadingForm::Packets), points(ShadingForm::Points);
    const Tracer* const fixed =
        firstOf<FixedFunction, ConstantShader, DiffuseShader, TexturedDiffuseShader, TextureShader,
                MirrorShader, Phong, MetallicRoughness, Glass, AmbientOcclusion>(
            shading, form);
    return fixed ? *fixed : form == ShadingForm::Packets ? packets : points;
}

} // namespace smart
