// SPDX-License-Identifier: MIT
#include "libsmart/render/tracers.h"

#include "libsmart/render/packet_tracer.h"
#include "libsmart/shading/builtin/ambient_occlusion.h"
#include "libsmart/shading/builtin/glass.h"
#include "libsmart/shading/builtin/metallic_roughness.h"
#include "libsmart/shading/builtin/surfaces.h"

namespace smart {
namespace {

template <class S>
const Tracer* fixedTracer(const FrameShading& shading) {
    static const PacketTracer<FixedShading<S>> tracer;
    return FixedShading<S>::serves(shading) ? &tracer : nullptr;
}

template <class... Surfaces>
const Tracer* firstOf(const FrameShading& shading) {
    const Tracer* found = nullptr;
    ((found = found ? found : fixedTracer<Surfaces>(shading)), ...);
    return found;
}

} // namespace

const Tracer& tracerFor(const FrameShading& shading) {
    using namespace builtin;
    static const PacketTracer<> general;
    const Tracer* const fixed =
        firstOf<FixedFunction, ConstantShader, DiffuseShader, TexturedDiffuseShader, TextureShader,
                MirrorShader, Phong, MetallicRoughness, Glass, AmbientOcclusion>(shading);
    return fixed ? *fixed : general;
}

} // namespace smart
