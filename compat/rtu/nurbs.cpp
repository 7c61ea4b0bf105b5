// SPDX-License-Identifier: MIT
// NURBS are not part of this release: every call says so, and does nothing else.
#include "compat/openrt/guard.h"
#include "openrt/rtu.h"

using smart::compat::refused;

RTAPI RTUnurbs* RTAPIENTRY rtuNewNurbsRenderer(void) {
    refused(__func__);
    return nullptr;
}
RTAPI void RTAPIENTRY rtuDeleteNurbsRenderer(RTUnurbs*) { refused(__func__); }
RTAPI void RTAPIENTRY rtuBeginCurve(RTUnurbs*) { refused(__func__); }
RTAPI void RTAPIENTRY rtuEndCurve(RTUnurbs*) { refused(__func__); }
RTAPI void RTAPIENTRY rtuBeginSurface(RTUnurbs*) { refused(__func__); }
RTAPI void RTAPIENTRY rtuEndSurface(RTUnurbs*) { refused(__func__); }
RTAPI void RTAPIENTRY rtuBeginTrim(RTUnurbs*) { refused(__func__); }
RTAPI void RTAPIENTRY rtuEndTrim(RTUnurbs*) { refused(__func__); }
RTAPI void RTAPIENTRY rtuNurbsProperty(RTUnurbs*, RTenum, RTfloat) { refused(__func__); }
RTAPI void RTAPIENTRY rtuGetNurbsProperty(RTUnurbs*, RTenum, RTfloat*) { refused(__func__); }
RTAPI void RTAPIENTRY rtuNurbsCallback(RTUnurbs*, RTenum, RTUfuncptr) { refused(__func__); }
RTAPI void RTAPIENTRY rtuNurbsCallbackData(RTUnurbs*, void*) { refused(__func__); }
RTAPI void RTAPIENTRY rtuNurbsCallbackDataEXT(RTUnurbs*, void*) { refused(__func__); }
RTAPI void RTAPIENTRY rtuLoadSamplingMatrices(RTUnurbs*, const RTfloat*, const RTfloat*,
                                              const RTint*) {
    refused(__func__);
}
RTAPI void RTAPIENTRY rtuNurbsCurve(RTUnurbs*, RTint, RTfloat*, RTint, RTfloat*, RTint, RTenum) {
    refused(__func__);
}
RTAPI void RTAPIENTRY rtuNurbsSurface(RTUnurbs*, RTint, RTfloat*, RTint, RTfloat*, RTint, RTint,
                                      RTfloat*, RTint, RTint, RTenum) {
    refused(__func__);
}
RTAPI void RTAPIENTRY rtuPwlCurve(RTUnurbs*, RTint, RTfloat*, RTint, RTenum) { refused(__func__); }
