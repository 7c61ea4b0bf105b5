// SPDX-License-Identifier: MIT
#include "compat/openrt/tokens.h"

#include <algorithm>
#include <iterator>

#include "compat/openrt/guard.h"

namespace smart::compat {

namespace {

/// Tokens from first to last, all of which OpenGL uses for the same purpose.
struct Range {
    RTenum first, last;
};

template <std::size_t n>
bool contains(const Range (&ranges)[n], RTenum token) {
    return std::any_of(std::begin(ranges), std::end(ranges), [token](const Range& range) {
        return range.first <= token && token <= range.last;
    });
}

constexpr Range one(RTenum token) {
    return {token, token};
}

} // namespace

Primitive primitiveOf(RTenum mode) {
    switch (mode) {
    case RT_TRIANGLES: return Primitive::Triangles;
    case RT_TRIANGLE_STRIP: return Primitive::TriangleStrip;
    case RT_TRIANGLE_FAN: return Primitive::TriangleFan;
    case RT_QUADS: return Primitive::Quads;
    case RT_QUAD_STRIP: return Primitive::QuadStrip;
    case RT_POLYGON: return Primitive::Polygon;
    case RT_POINTS: return Primitive::Points;
    case RT_LINES: return Primitive::Lines;
    case RT_LINE_STRIP: return Primitive::LineStrip;
    case RT_LINE_LOOP: return Primitive::LineLoop;
    default: throwError(ErrorCode::InvalidEnum, "unknown kind of primitive");
    }
}

MatrixMode matrixModeOf(RTenum mode) {
    switch (mode) {
    case RT_MODELVIEW: return MatrixMode::ModelView;
    case RT_PROJECTION: return MatrixMode::Projection;
    case RT_TEXTURE: return MatrixMode::Texture;
    default: throwError(ErrorCode::InvalidEnum, "unknown matrix mode");
    }
}

RTenum tokenOf(MatrixMode mode) {
    switch (mode) {
    case MatrixMode::ModelView: return RT_MODELVIEW;
    case MatrixMode::Projection: return RT_PROJECTION;
    case MatrixMode::Texture: break;
    }
    return RT_TEXTURE;
}

RTenum tokenOf(FrameStatus status) {
    switch (status) {
    case FrameStatus::Queued: return RT_QUEUED;
    case FrameStatus::Rendering: return RT_RENDERING;
    case FrameStatus::Done: return RT_DONE;
    case FrameStatus::Cancelled: return RT_CANCELLED;
    case FrameStatus::Failed: break;
    }
    return RT_FAILED;
}

PixelFormat pixelFormatOf(RTenum format) {
    switch (format) {
    case RT_BGR_32: return PixelFormat::Bgr32f;
    case RT_RGB_8: return PixelFormat::Rgb8;
    case RT_RGBA_8: return PixelFormat::Rgba8;
    case RT_BGRA_8: return PixelFormat::Bgra8;
    case RT_RGB_32F: return PixelFormat::Rgb32f;
    case RT_RGBA_32F: return PixelFormat::Rgba32f;
    default: throwError(ErrorCode::InvalidEnum, "unknown frame buffer format");
    }
}

Coherence coherenceOf(RTenum coherence) {
    switch (coherence) {
    case RT_COHERENT: return Coherence::Coherent;
    case RT_INCOHERENT: return Coherence::Incoherent;
    default: throwError(ErrorCode::InvalidEnum, "unknown coherence");
    }
}

bool isCapability(RTenum token) {
    static constexpr Range kCapabilities[] = {
        one(RT_POINT_SMOOTH), one(RT_LINE_SMOOTH), one(RT_LINE_STIPPLE), one(RT_POLYGON_SMOOTH),
        one(RT_POLYGON_STIPPLE), one(RT_CULL_FACE), one(RT_LIGHTING), one(RT_COLOR_MATERIAL),
        one(RT_FOG), one(RT_COLOR_SUM), one(RT_DEPTH_TEST), one(RT_STENCIL_TEST),
        one(RT_NORMALIZE), one(RT_ALPHA_TEST), one(RT_DITHER), one(RT_BLEND),
        one(RT_INDEX_LOGIC_OP), one(RT_COLOR_LOGIC_OP), one(RT_SCISSOR_TEST),
        {RT_TEXTURE_GEN_S, RT_TEXTURE_GEN_Q}, one(RT_AUTO_NORMAL),
        {RT_MAP1_COLOR_4, RT_MAP1_VERTEX_4},
        {RT_MAP2_COLOR_4, RT_MAP2_VERTEX_4}, {RT_TEXTURE_1D, RT_TEXTURE_2D},
        {RT_POLYGON_OFFSET_POINT, RT_POLYGON_OFFSET_LINE}, {RT_CLIP_PLANE0, RT_CLIP_PLANE5},
        {RT_LIGHT0, RT_LIGHT7}, one(RT_CONVOLUTION_1D), one(RT_CONVOLUTION_2D),
        one(RT_SEPARABLE_2D), one(RT_HISTOGRAM), one(RT_MINMAX), one(RT_POLYGON_OFFSET_FILL),
        one(RT_RESCALE_NORMAL), one(RT_TEXTURE_3D), {RT_VERTEX_ARRAY, RT_EDGE_FLAG_ARRAY},
        {RT_MULTISAMPLE, RT_SAMPLE_COVERAGE}, one(RT_COLOR_TABLE),
        one(RT_POST_CONVOLUTION_COLOR_TABLE), one(RT_POST_COLOR_MATRIX_COLOR_TABLE),
        {RT_FOG_COORDINATE_ARRAY, RT_SECONDARY_COLOR_ARRAY}, one(RT_TEXTURE_CUBE_MAP),
        // Ours
        {RT_SHADOWS, RT_REFLECTIONS}, one(RT_FRAMEBUFFER_SRGB)};
    return contains(kCapabilities, token);
}

bool isStateVariable(RTenum token) {
    static constexpr Range kVariables[] = {
        {RT_CURRENT_COLOR, RT_EDGE_FLAG},
        {RT_POINT_SMOOTH, RT_LINE_STIPPLE_REPEAT},
        {RT_LIST_MODE, RT_LIST_INDEX},
        {RT_POLYGON_MODE, RT_FRONT_FACE},
        {RT_LIGHTING, RT_COLOR_MATERIAL},
        {RT_FOG, RT_FOG_COLOR},
        {RT_DEPTH_RANGE, RT_DEPTH_FUNC},
        {RT_ACCUM_CLEAR_VALUE, RT_ACCUM_CLEAR_VALUE},
        {RT_STENCIL_TEST, RT_STENCIL_WRITEMASK},
        {RT_MATRIX_MODE, RT_CLIENT_ATTRIB_STACK_DEPTH},
        {RT_ALPHA_TEST, RT_ALPHA_TEST_REF},
        one(RT_DITHER),
        {RT_BLEND_DST, RT_BLEND},
        {RT_LOGIC_OP_MODE, RT_COLOR_LOGIC_OP},
        {RT_AUX_BUFFERS, RT_READ_BUFFER},
        {RT_SCISSOR_BOX, RT_SCISSOR_TEST},
        {RT_INDEX_CLEAR_VALUE, RT_STEREO},
        one(RT_RENDER_MODE),
        {RT_PERSPECTIVE_CORRECTION_HINT, RT_FOG_HINT},
        {RT_TEXTURE_GEN_S, RT_TEXTURE_GEN_Q},
        {RT_PIXEL_MAP_I_TO_I_SIZE, RT_PIXEL_MAP_A_TO_A_SIZE},
        {RT_UNPACK_SWAP_BYTES, RT_PACK_ALIGNMENT},
        {RT_MAP_COLOR, RT_DEPTH_BIAS},
        {RT_MAX_EVAL_ORDER, RT_MAX_CLIENT_ATTRIB_STACK_DEPTH},
        {RT_SUBPIXEL_BITS, RT_NAME_STACK_DEPTH},
        {RT_MAP1_GRID_DOMAIN, RT_MAP2_GRID_SEGMENTS},
        {RT_FEEDBACK_BUFFER_SIZE, RT_SELECTION_BUFFER_SIZE},
        one(RT_POLYGON_OFFSET_UNITS),
        {RT_BLEND_COLOR, RT_BLEND_EQUATION},
        one(RT_POLYGON_OFFSET_FACTOR),
        {RT_TEXTURE_BINDING_1D, RT_TEXTURE_BINDING_3D},
        {RT_PACK_SKIP_IMAGES, RT_UNPACK_IMAGE_HEIGHT},
        one(RT_MAX_3D_TEXTURE_SIZE),
        {RT_VERTEX_ARRAY_SIZE, RT_EDGE_FLAG_ARRAY_STRIDE},
        {RT_SAMPLE_BUFFERS, RT_SAMPLE_COVERAGE_INVERT},
        {RT_COLOR_MATRIX, RT_MAX_COLOR_MATRIX_STACK_DEPTH},
        {RT_MAX_ELEMENTS_VERTICES, RT_MAX_ELEMENTS_INDICES},
        {RT_POINT_SIZE_MIN, RT_POINT_DISTANCE_ATTENUATION},
        one(RT_LIGHT_MODEL_COLOR_CONTROL),
        {RT_CURRENT_FOG_COORDINATE, RT_CURRENT_SECONDARY_COLOR},
        {RT_ALIASED_POINT_SIZE_RANGE, RT_ALIASED_LINE_WIDTH_RANGE},
        {RT_ACTIVE_TEXTURE, RT_MAX_TEXTURE_UNITS},
        {RT_TRANSPOSE_MODELVIEW_MATRIX, RT_TRANSPOSE_COLOR_MATRIX},
        one(RT_MAX_TEXTURE_LOD_BIAS),
        one(RT_TEXTURE_BINDING_CUBE_MAP),
        one(RT_MAX_CUBE_MAP_TEXTURE_SIZE),
        {RT_NUM_COMPRESSED_TEXTURE_FORMATS, RT_COMPRESSED_TEXTURE_FORMATS},
        {RT_ARRAY_BUFFER_BINDING, RT_FOG_COORDINATE_ARRAY_BUFFER_BINDING}};
    return contains(kVariables, token) || isCapability(token);
}

bool isHintTarget(RTenum token) {
    static constexpr Range kHints[] = {{RT_PERSPECTIVE_CORRECTION_HINT, RT_FOG_HINT},
                                       one(RT_GENERATE_MIPMAP_HINT),
                                       one(RT_TEXTURE_COMPRESSION_HINT),
                                       one(RT_PRECISION_HINT)};
    return contains(kHints, token);
}

} // namespace smart::compat
