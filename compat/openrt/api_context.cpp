// SPDX-License-Identifier: MIT
#include <cstdint>
#include <string>
#include <utility>

#include "compat/openrt/frame_callback.h"
#include "compat/openrt/guard.h"
#include "compat/openrt/init_arguments.h"
#include "compat/openrt/other_processes.h"
#include "compat/openrt/query_handles.h"
#include "compat/openrt/tokens.h"
#include "compat/recorder/frame_table.h"
#include "libsmart/kernel/kernels.h"
#include "libsmart/shading/plugin_search.h"
#include "openrt/rt_core.h"
#include "openrt/version.h"

using namespace smart;
using namespace smart::compat;

namespace {

/// What became part of OpenGL 1.1 to 1.5, and works whole.
constexpr const char* kExtensions =
    "GL_ARB_multitexture GL_ARB_point_parameters GL_ARB_texture_border_clamp "
    "GL_ARB_texture_env_add GL_ARB_texture_env_combine GL_ARB_texture_env_crossbar "
    "GL_ARB_texture_env_dot3 GL_ARB_texture_mirrored_repeat GL_ARB_transpose_matrix "
    "GL_ARB_vertex_buffer_object GL_ARB_window_pos GL_EXT_bgra GL_EXT_blend_color "
    "GL_EXT_blend_func_separate GL_EXT_blend_minmax GL_EXT_blend_subtract "
    "GL_EXT_draw_range_elements GL_EXT_fog_coord GL_EXT_multi_draw_arrays GL_EXT_packed_pixels "
    "GL_EXT_rescale_normal GL_EXT_secondary_color GL_EXT_separate_specular_color "
    "GL_EXT_subtexture GL_EXT_texture_lod_bias GL_EXT_texture_object GL_SGIS_generate_mipmap "
    "GL_SGIS_texture_edge_clamp GL_SGIS_texture_lod";

// A context's handle is its id in the clothes of a pointer: never dangling, never used again.
RTcontext handleOf(ContextId id) {
    return reinterpret_cast<RTcontext>(std::uintptr_t(id));
}
ContextId idOf(RTcontext context) {
    return reinterpret_cast<std::uintptr_t>(context);
}

using ErrorFunction = void(RTAPIENTRY*)(RTenum, const char*, const char*, void*);

class CallbackListener final : public ErrorListener {
public:
    CallbackListener(ErrorFunction function, void* user) : function_(function), user_(user) {}
    void error(ErrorCode code, const char* function, const char* text) override {
        function_(errorToken(code), function, text, user_);
    }

private:
    ErrorFunction function_;
    void* user_;
};

/// Those that library and machine have, best first.
const char* instructionSets() {
    static const std::string names = [] {
        std::string all;
        for (const char* name : {"avx512", "avx2", "sse4", "neon", "generic"})
            if (findKernels(name)) all.append(all.empty() ? "" : " ").append(name);
        return all;
    }();
    return names.c_str();
}

const char* shaderFoldersText() {
    thread_local std::string text;
    std::string all;
    for (const std::string& folder : shaderFolders())
        all.append(all.empty() ? "" : ":").append(folder);
    text = std::move(all);
    return text.c_str();
}

} // namespace

RTAPI void RTAPIENTRY rtInit(int* argcp, char* argv[]) {
    if (refusedHere(__func__)) return;
    try {
        if (Context* context = currentContext()) context->recorder().requireOutsidePrimitive();
        joinOtherProcesses();
        const InitOptions options = takeInitArguments(argcp, argv);
        resetDefaultContext(options.threads);
        FrameSettings& settings = currentContext()->recorder().frameSettings();
        if (options.precision) settings.precision = *options.precision;
        if (options.samples) settings.samples = *options.samples;
    } catch (...) {
        report("rtInit");
    }
    serveOtherProcess();
}

RTAPI void RTAPIENTRY rtExit(void) {
    if (refusedHere(__func__)) return;
    destroyAllContexts();
    releaseAllQueryScenes();
    frameTable().forgetAll();
}

RTAPI RTcontext RTAPIENTRY rtCreateContext(void) {
    if (refusedHere(__func__)) return nullptr;
    try {
        return handleOf(createContext(threadsFromEnvironment()));
    } catch (...) {
        report("rtCreateContext");
        return nullptr;
    }
}

RTAPI RTboolean RTAPIENTRY rtMakeCurrent(RTcontext context) {
    if (refusedHere(__func__)) return RT_FALSE;
    try {
        makeContextCurrent(idOf(context));
        return RT_TRUE;
    } catch (...) {
        report("rtMakeCurrent");
        return RT_FALSE;
    }
}

RTAPI void RTAPIENTRY rtDestroyContext(RTcontext context) {
    if (refusedHere(__func__)) return;
    try {
        if (context) destroyContext(idOf(context));
    } catch (...) {
        report("rtDestroyContext");
    }
}

RTAPI RTcontext RTAPIENTRY rtGetCurrentContext(void) {
    refusedInCallback(__func__); // there is none on a thread of the library
    return handleOf(currentContextId());
}

RTAPI RTenum RTAPIENTRY rtGetError(void) {
    const RTenum none = currentContext() ? RT_NO_ERROR : RT_INVALID_OPERATION;
    return guardedOr(none, __func__, [](Context& c) -> RTenum {
        c.recorder().requireOutsidePrimitive();
        const std::optional<ErrorCode> code = c.errors().take();
        return code ? errorToken(*code) : RT_NO_ERROR;
    });
}

RTAPI const char* RTAPIENTRY rtGetErrorText(void) {
    const char* const none =
        whyUnusable() ? whyUnusable() : "no context is current on this thread";
    return guardedOr(none, __func__, [](Context& c) { return c.errors().text(); });
}

RTAPI void RTAPIENTRY rtErrorCallback(ErrorFunction cb, void* user) {
    guarded(__func__, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        c.errors().setListener(cb ? std::make_shared<CallbackListener>(cb, user) : nullptr);
    });
}

RTAPI const RTubyte* RTAPIENTRY rtGetString(RTenum name) {
    return guardedOr<const RTubyte*>(nullptr, __func__, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        const char* text = nullptr;
        switch (name) {
        case RT_VERSION: text = "1.5 OpenRT " OPENRT_VERSION_STRING; break;
        case RT_VENDOR: text = "OpenRT project"; break;
        case RT_RENDERER: text = "OpenRT on libsmart"; break;
        case RT_EXTENSIONS: text = kExtensions; break;
        case RT_ISA: text = kernels().name; break;
        case RT_ISA_NAMES: text = instructionSets(); break;
        case RT_SHADER_FOLDERS: text = shaderFoldersText(); break;
        default: throwError(ErrorCode::InvalidEnum, "no such text");
        }
        return reinterpret_cast<const RTubyte*>(text);
    });
}

RTAPI void RTAPIENTRY rtThreads(RTuint n) {
    guarded(__func__, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        if (n > kMaxThreads) throwError(ErrorCode::InvalidValue, "more than 1024 threads");
        c.frames().setThreads(n);
    });
}
