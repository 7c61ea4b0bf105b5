// SPDX-License-Identifier: MIT
// The C++ face of openrt/rt.h: overloads by type, and shader classes that are C++ types.
//
//     struct Glow {
//         openrt::Color color{1, 1, 1};
//         void registerParams(const openrt::ShaderRegistrator& r) const {
//             r.registerParam<openrt::Color>("color", openrt::PER_SHADER, offsetof(Glow, color));
//         }
//         void shade(openrt::TraceContext& c) const { c.setRadiance(color); }
//     };
//     rtGenNewShaderClass<Glow>("Glow");
//     RTuint shader = rtGenNewShader();
//     rtParameter(rtParameterHandle("color"), openrt::Color(1, 0.5f, 0));
//
// Errors, threads and places are those of the C calls that these stand for. Since: 0.1
#pragma once

#include <string>
#include <type_traits>
#include <typeinfo>

#include "openrt/rt.h"
#include "openrt/shader.hpp"
#include "openrt/vectors.hpp"

/// Registers the shader class T of this program, and binds it as rtGenNewShaderClass does.
/// A constructor that throws is RT_INVALID_VALUE; of a class with registerParams it, and what
/// registerParams throws, come out here.
template <class T>
RTuint rtGenNewShaderClass(const char* name = typeid(T).name()) {
    return rtRegisterShaderClass(openrt::shaderClass<T>(name));
}

inline void rtVertex(const openrt::Vec2& v) { rtVertex2f(v.x, v.y); }
inline void rtVertex(const openrt::Vec3& v) { rtVertex3f(v.x, v.y, v.z); }
inline void rtVertex(const openrt::Vec4& v) { rtVertex4f(v.x, v.y, v.z, v.w); }
inline void rtNormal(const openrt::Vec3& v) { rtNormal3f(v.x, v.y, v.z); }
inline void rtTexCoord(const openrt::Vec2& v) { rtTexCoord2f(v.x, v.y); }
inline void rtTexCoord(const openrt::Vec3& v) { rtTexCoord3f(v.x, v.y, v.z); }
inline void rtTexCoord(const openrt::Vec4& v) { rtTexCoord4f(v.x, v.y, v.z, v.w); }
inline void rtColor(const openrt::Color& c) { rtColor3f(c.r, c.g, c.b); }
inline void rtColor(const openrt::Vec4& v) { rtColor4f(v.x, v.y, v.z, v.w); }

inline void rtLoadMatrix(const openrt::Mat4& m) { rtLoadMatrixf(m.m); }
inline void rtMultMatrix(const openrt::Mat4& m) { rtMultMatrixf(m.m); }
inline void rtTranslate(const openrt::Vec3& v) { rtTranslatef(v.x, v.y, v.z); }
inline void rtScale(const openrt::Vec3& v) { rtScalef(v.x, v.y, v.z); }
inline void rtRotate(float angle, const openrt::Vec3& axis) {
    rtRotatef(angle, axis.x, axis.y, axis.z);
}

inline void rtParameter(RTuint handle, bool value) { rtParameter1i(handle, value); }
inline void rtParameter(RTuint handle, int value) { rtParameter1i(handle, value); }
inline void rtParameter(RTuint handle, RTuint value) { rtParameter1i(handle, RTint(value)); }
inline void rtParameter(RTuint handle, float value) { rtParameter1f(handle, value); }
inline void rtParameter(RTuint handle, double value) { rtParameter1f(handle, float(value)); }
inline void rtParameter(RTuint handle, openrt::TextureId t) { rtParameter1i(handle, t.id); }
inline void rtParameter(RTuint handle, const openrt::Int2& v) { rtParameter2i(handle, v.x, v.y); }
inline void rtParameter(RTuint handle, const openrt::Int3& v) {
    rtParameter3i(handle, v.x, v.y, v.z);
}
inline void rtParameter(RTuint handle, const openrt::Vec2& v) { rtParameter2f(handle, v.x, v.y); }
inline void rtParameter(RTuint handle, const openrt::Vec3& v) {
    rtParameter3f(handle, v.x, v.y, v.z);
}
inline void rtParameter(RTuint handle, const openrt::Vec4& v) {
    rtParameter4f(handle, v.x, v.y, v.z, v.w);
}
inline void rtParameter(RTuint handle, const openrt::Color& c) {
    rtParameter3f(handle, c.r, c.g, c.b);
}
inline void rtParameter(RTuint handle, const openrt::Mat4& m) { rtParameter16fv(handle, m.m); }
inline void rtParameter(RTuint handle, const char* text) { rtParameterString(handle, text); }
inline void rtParameter(RTuint handle, const std::string& text) {
    rtParameterString(handle, text.c_str());
}
/// Of another library: it would convert to Vec3 and Color alike.
template <openrt::detail::Foreign<3> V>
void rtParameter(RTuint handle, const V& v) {
    rtParameter(handle, openrt::Vec3(v));
}
/// Any other plain struct.
template <class T>
    requires(std::is_class_v<T> && std::is_trivially_copyable_v<T> &&
             openrt::detail::kForeignLength<T> == 0)
void rtParameter(RTuint handle, const T& value) {
    rtParameterRaw(handle, &value, RTuint(sizeof value));
}
