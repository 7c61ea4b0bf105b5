// SPDX-License-Identifier: MIT
#include "compat/openrt/guard.h"
#include "openrt/enums.h"
#include "openrt/rt_fixed.h"

using namespace smart;
using namespace smart::compat;

static_assert(kCurrentGroup == RT_CURRENT_BIT && kLightingGroup == RT_LIGHTING_BIT &&
              kDepthBufferGroup == RT_DEPTH_BUFFER_BIT && kEnableGroup == RT_ENABLE_BIT &&
              kTextureGroup == RT_TEXTURE_BIT && kMultisampleGroup == RT_MULTISAMPLE_BIT);

RTAPI void RTAPIENTRY rtPushAttrib(RTbitfield mask) {
    recorded(__func__, [=](Context& c) { pushAttributes(c, mask); });
}
RTAPI void RTAPIENTRY rtPopAttrib(void) {
    recorded(__func__, [](Context& c) { popAttributes(c); });
}
RTAPI void RTAPIENTRY rtPushClientAttrib(RTbitfield mask) {
    guarded(__func__, [=](Context& c) {
        pushClientAttributes(c, (mask & RT_CLIENT_PIXEL_STORE_BIT) != 0,
                             (mask & RT_CLIENT_VERTEX_ARRAY_BIT) != 0);
    });
}
RTAPI void RTAPIENTRY rtPopClientAttrib(void) {
    guarded(__func__, [](Context& c) { popClientAttributes(c); });
}
