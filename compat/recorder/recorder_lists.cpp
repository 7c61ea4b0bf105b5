// SPDX-License-Identifier: MIT
// Runs of primitives of display lists.
#include <cstring>
#include <utility>

#include "compat/recorder/recorder.h"
#include "compat/recorder/transforms.h"
#include "libsmart/kernel/affine_inverse.h"

namespace smart::compat {

// A matrix that flattens or divides leaves no instance, but vertices by themselves. Points and
// lines, which polygons may be drawn as, are no part of models.
bool Recorder::canPlaceRuns() const {
    if (insidePrimitive_ || open_) return false;
    const glm::dmat4& m = matrices_.modelView();
    if (m[0].w != 0 || m[1].w != 0 || m[2].w != 0) return false;
    const glm::dmat4x3 matrix = makeAffine(m);
    AffineColumns columns;
    static_assert(sizeof columns == sizeof matrix);
    std::memcpy(columns, &matrix[0][0], sizeof columns);
    if (!isInvertible(columns)) return false;
    const FixedRaster& raster = fixedState_.state().raster;
    return raster.polygonMode[0] == FixedPolygonMode::Fill &&
           raster.polygonMode[1] == FixedPolygonMode::Fill;
}

CompiledRun Recorder::compileRun(const std::function<void()>& calls) {
    openObject(0, ObjectMode::Define);
    struct Close {
        Recorder& recorder;
        ~Close() {
            recorder.insidePrimitive_ = false;
            recorder.closeObject();
        }
    } const close{*this};
    calls();
    requireOutsidePrimitive();
    ModelPtr model = compiler_.compile(open_->recording, BuildQuality::DontCare, false);
    return {std::move(model), shaders_.bound(), open_->savedAttributes.materials};
}

} // namespace smart::compat
