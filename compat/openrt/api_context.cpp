// SPDX-License-Identifier: MIT
#include <cstdint>
#include <utility>

#include "compat/openrt/guard.h"
#include "compat/openrt/init_arguments.h"
#include "compat/openrt/query_handles.h"
#include "compat/openrt/tokens.h"
#include "libsmart/kernel/kernels.h"
#include "openrt/rt_core.h"
#include "openrt/version.h"

using namespace smart;
using namespace smart::compat;

namespace {

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

} // namespace

RTAPI void RTAPIENTRY rtInit(int* argcp, char* argv[]) {
    try {
        if (Context* context = currentContext()) context->recorder().requireOutsidePrimitive();
        const InitOptions options = takeInitArguments(argcp, argv);
        resetDefaultContext(options.threads);
        FrameSettings& settings = currentContext()->recorder().frameSettings();
        if (options.precision) settings.precision = *options.precision;
        if (options.samples) settings.samples = *options.samples;
    } catch (...) {
        report("rtInit");
    }
}

RTAPI void RTAPIENTRY rtExit(void) {
    destroyAllContexts();
    releaseAllQueryScenes();
}

RTAPI RTcontext RTAPIENTRY rtCreateContext(void) {
    try {
        return handleOf(createContext(threadsFromEnvironment()));
    } catch (...) {
        report("rtCreateContext");
        return nullptr;
    }
}

RTAPI RTboolean RTAPIENTRY rtMakeCurrent(RTcontext context) {
    try {
        makeContextCurrent(idOf(context));
        return RT_TRUE;
    } catch (...) {
        report("rtMakeCurrent");
        return RT_FALSE;
    }
}

RTAPI void RTAPIENTRY rtDestroyContext(RTcontext context) {
    try {
        if (context) destroyContext(idOf(context));
    } catch (...) {
        report("rtDestroyContext");
    }
}

RTAPI RTcontext RTAPIENTRY rtGetCurrentContext(void) {
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
    return guardedOr<const char*>("no context is current on this thread", __func__,
                                  [](Context& c) { return c.errors().text(); });
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
        case RT_VERSION: text = OPENRT_VERSION_STRING; break;
        case RT_VENDOR: text = "OpenRT project"; break;
        case RT_RENDERER: text = "OpenRT on libsmart"; break;
        case RT_EXTENSIONS: text = ""; break;
        case RT_ISA: text = kernels().name; break;
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

RTAPI void RTAPIENTRY rtHint(RTenum target, RTenum mode) {
    guarded(__func__, [&](Context& c) {
        c.recorder().requireOutsideObject();
        if (!isHintTarget(target)) throwError(ErrorCode::InvalidEnum, "no such hint");
        if (mode != RT_FASTEST && mode != RT_DONT_CARE && mode != RT_NICEST)
            throwError(ErrorCode::InvalidEnum, "a hint is RT_FASTEST, RT_DONT_CARE or RT_NICEST");
        if (target != RT_PRECISION_HINT)
            throwError(ErrorCode::InvalidOperation, "this hint is not part of this release");
        c.recorder().frameSettings().precision = mode == RT_FASTEST   ? Precision::Fast
                                                 : mode == RT_NICEST ? Precision::Precise
                                                                     : Precision::Watertight;
    });
}
