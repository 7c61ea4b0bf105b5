// SPDX-License-Identifier: MIT
// Polygons, lines, points and clip planes (OpenGL 1.5, sections 2.11 and 3.3 to 3.5).
#include <algorithm>
#include <array>

#include "compat/openrt/call_values.h"
#include "compat/openrt/fixed_tokens.h"
#include "compat/openrt/guard.h"
#include "compat/recorder/transforms.h"
#include "openrt/rt_fixed.h"

using namespace smart;
using namespace smart::compat;

namespace {

using StippleRows = std::array<uint32_t, 32>;

/// Of a bitmap 32 bits wide.
std::size_t bytesOfRow(const PixelStore& store) {
    const std::size_t alignment = store.alignment;
    const std::size_t pixels = store.rowLength > 0 ? store.rowLength : 32;
    return (pixels + 8 * alignment - 1) / (8 * alignment) * alignment;
}

/// A bitmap of 32 x 32 in the application's memory, as its pixel storage has it: bytes of which
/// the most significant bit is leftmost, unless they are the other way round.
StippleRows stippleFrom(const RTubyte* mask, const PixelStore& store) {
    const std::size_t stride = bytesOfRow(store);
    StippleRows rows;
    for (std::size_t y = 0; y < 32; ++y) {
        const RTubyte* const row = mask + (store.skipRows + y) * stride;
        rows[y] = 0;
        for (std::size_t x = 0; x < 32; ++x) {
            const std::size_t bit = store.skipPixels + x;
            const std::size_t shift = store.lsbFirst ? bit % 8 : 7 - bit % 8;
            rows[y] = rows[y] << 1 | (row[bit / 8] >> shift & 1u);
        }
    }
    return rows;
}

/// The reverse; bits beside the bitmap stay as they are.
void stippleTo(RTubyte* mask, const PixelStore& store, const uint32_t (&rows)[32]) {
    const std::size_t stride = bytesOfRow(store);
    for (std::size_t y = 0; y < 32; ++y) {
        RTubyte* const row = mask + (store.skipRows + y) * stride;
        for (std::size_t x = 0; x < 32; ++x) {
            const std::size_t bit = store.skipPixels + x;
            const auto one = RTubyte(1u << (store.lsbFirst ? bit % 8 : 7 - bit % 8));
            const bool set = (rows[y] >> (31 - x) & 1u) != 0;
            row[bit / 8] = RTubyte(set ? row[bit / 8] | one : row[bit / 8] & ~one);
        }
    }
}

int clipPlaneNumber(RTenum plane) {
    if (plane < RT_CLIP_PLANE0 || plane - RT_CLIP_PLANE0 >= RTenum(kFixedClipPlanes))
        throwError(ErrorCode::InvalidEnum, "there are RT_CLIP_PLANE0 to RT_CLIP_PLANE5");
    return int(plane - RT_CLIP_PLANE0);
}

float positive(RTfloat value) {
    if (!(value > 0)) throwError(ErrorCode::InvalidValue, "a size is above 0");
    return value;
}

int pointValues(RTenum pname) {
    switch (pname) {
    case RT_POINT_DISTANCE_ATTENUATION: return 3;
    case RT_POINT_SIZE_MIN:
    case RT_POINT_SIZE_MAX:
    case RT_POINT_FADE_THRESHOLD_SIZE: return 1;
    default: return 0;
    }
}

void setPointParameter(const char* function, RTenum pname, const CallValues& values) noexcept {
    recorded(function, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        const auto size = [&] {
            const float checked = values.number();
            if (!(checked >= 0)) throwError(ErrorCode::InvalidValue, "a size is below 0");
            return checked;
        };
        FixedRaster raster = fixed.state().raster;
        switch (pname) {
        case RT_POINT_SIZE_MIN: raster.pointSizeMin = size(); break;
        case RT_POINT_SIZE_MAX: raster.pointSizeMax = size(); break;
        case RT_POINT_FADE_THRESHOLD_SIZE: raster.pointFadeThreshold = size(); break;
        case RT_POINT_DISTANCE_ATTENUATION: raster.pointAttenuation = values.direction(); break;
        default: throwError(ErrorCode::InvalidEnum, "unknown property of points");
        }
        fixed.change().raster = raster;
    });
}

} // namespace

RTAPI void RTAPIENTRY rtCullFace(RTenum mode) {
    recorded(__func__, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        const FixedFace face = fixedFaceOf(mode);
        fixed.change().raster.cullFace = face;
    });
}

RTAPI void RTAPIENTRY rtFrontFace(RTenum mode) {
    recorded(__func__, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        if (mode != RT_CW && mode != RT_CCW)
            throwError(ErrorCode::InvalidEnum, "front faces are RT_CW or RT_CCW");
        fixed.change().raster.frontFaceClockwise = mode == RT_CW;
    });
}

RTAPI void RTAPIENTRY rtPolygonMode(RTenum face, RTenum mode) {
    recorded(__func__, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        const FixedFace faces = fixedFaceOf(face);
        const FixedPolygonMode polygonMode = polygonModeOf(mode);
        FixedRaster& raster = fixed.change().raster;
        if (faces != FixedFace::Back) raster.polygonMode[0] = polygonMode;
        if (faces != FixedFace::Front) raster.polygonMode[1] = polygonMode;
    });
}

RTAPI void RTAPIENTRY rtPolygonOffset(RTfloat factor, RTfloat units) {
    recorded(__func__, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        requireNumber(factor);
        requireNumber(units);
        FixedRaster& raster = fixed.change().raster;
        raster.offsetFactor = factor;
        raster.offsetUnits = units;
    });
}

RTAPI void RTAPIENTRY rtPolygonStipple(const RTubyte* mask) {
    // The application's memory is read when the call is made, also for display lists.
    StippleRows rows{};
    bool read = false;
    guarded(__func__, [&](Context& c) {
        const PixelStore& store = c.recorder().pixelStore();
        requirePointer(mask, "mask");
        rows = stippleFrom(mask, store);
        read = true;
    });
    if (!read) return;
    recorded(__func__, [=](Context& c) {
        std::copy(rows.begin(), rows.end(),
                  c.recorder().fixedState().change().raster.polygonStipple);
    });
}

RTAPI void RTAPIENTRY rtGetPolygonStipple(RTubyte* mask) {
    guarded(__func__, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        requirePointer(mask, "mask");
        stippleTo(mask, c.recorder().packStore(),
                  c.recorder().fixedStateNow().raster.polygonStipple);
    });
}

RTAPI void RTAPIENTRY rtPointSize(RTfloat size) {
    recorded(__func__, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        const float checked = positive(size);
        fixed.change().raster.pointSize = checked;
    });
}

RTAPI void RTAPIENTRY rtPointParameterf(RTenum pname, RTfloat param) {
    setPointParameter(__func__, pname, CallValues::one(param));
}
RTAPI void RTAPIENTRY rtPointParameteri(RTenum pname, RTint param) {
    setPointParameter(__func__, pname, CallValues::one(param));
}
RTAPI void RTAPIENTRY rtPointParameterfv(RTenum pname, const RTfloat* params) {
    setPointParameter(__func__, pname, CallValues::array(params, pointValues(pname)));
}
RTAPI void RTAPIENTRY rtPointParameteriv(RTenum pname, const RTint* params) {
    setPointParameter(__func__, pname, CallValues::array(params, pointValues(pname)));
}

RTAPI void RTAPIENTRY rtLineWidth(RTfloat width) {
    recorded(__func__, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        const float checked = positive(width);
        fixed.change().raster.lineWidth = checked;
    });
}

RTAPI void RTAPIENTRY rtLineStipple(RTint factor, RTushort pattern) {
    recorded(__func__, [=](Context& c) {
        FixedRaster& raster = c.recorder().fixedState().change().raster;
        raster.lineFactor = std::clamp(factor, 1, 256);
        raster.linePattern = pattern;
    });
}

RTAPI void RTAPIENTRY rtClipPlane(RTenum plane, const RTdouble* equation) {
    glm::dvec4 given(0.0);
    if (equation)
        for (int k = 0; k < 4; ++k) given[k] = equation[k];
    recorded(__func__, [=, isNull = !equation](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        const int i = clipPlaneNumber(plane);
        if (isNull) throwError(ErrorCode::InvalidValue, "equation is NULL");
        for (int k = 0; k < 4; ++k) requireNumber(given[k]);
        glm::dmat4 eyeToObject;
        if (!invert(c.recorder().matrices().modelView(), eyeToObject))
            throwError(ErrorCode::InvalidOperation, "the model-view matrix has no inverse");
        fixed.change().raster.clipPlane[i] = given * eyeToObject;
    });
}

RTAPI void RTAPIENTRY rtGetClipPlane(RTenum plane, RTdouble* equation) {
    guarded(__func__, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        const glm::dvec4& p =
            c.recorder().fixedStateNow().raster.clipPlane[clipPlaneNumber(plane)];
        requirePointer(equation, "equation");
        for (int k = 0; k < 4; ++k) equation[k] = p[k];
    });
}
