// SPDX-License-Identifier: MIT
#include "libsmart/shading/fixed_frame_light.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "libsmart/base/transcendental.h"
#include "openrt/shader.hpp"

namespace smart {

namespace {

using openrt::Color;
using openrt::Vec3;
using openrt::Vec4;

struct FixedFunctionLight {
    Vec4 position{0, 0, 1, 0}; ///< w = 0: at infinity in this direction
    Color color{1.0f};
    Vec3 direction{0, 0, -1};
    float cutoff = 180, exponent = 0;
    Vec3 attenuation{1, 0, 0}; ///< constant, linear, quadratic

    void registerParams(const openrt::ShaderRegistrator& r) const {
        using openrt::PER_SHADER;
        r.registerParam<Vec4>("position", PER_SHADER, offsetof(FixedFunctionLight, position));
        r.registerParam<Color>("color", PER_SHADER, offsetof(FixedFunctionLight, color));
        r.registerParam<Vec3>("direction", PER_SHADER, offsetof(FixedFunctionLight, direction));
        r.registerParam<float>("cutoff", PER_SHADER, offsetof(FixedFunctionLight, cutoff));
        r.registerParam<float>("exponent", PER_SHADER, offsetof(FixedFunctionLight, exponent));
        r.registerParam<Vec3>("attenuation", PER_SHADER,
                              offsetof(FixedFunctionLight, attenuation));
    }

    bool illuminate(const Vec3& at, Vec3& toLight, float& distance, Color& arriving) const {
        const bool infinite = position.w == 0;
        const double w = infinite ? 1.0 : double(position.w);
        const double from = infinite ? 0.0 : 1.0;
        const double x = position.x / w - from * at.x, y = position.y / w - from * at.y,
                     z = position.z / w - from * at.z;
        const double length = std::sqrt(x * x + y * y + z * z);
        if (!(length > 0) || !std::isfinite(length)) return false;
        toLight = {float(x / length), float(y / length), float(z / length)};
        distance = infinite ? std::numeric_limits<float>::infinity() : float(length);
        arriving = color;
        if (infinite) return true;
        const double falloff =
            attenuation.x + attenuation.y * length + attenuation.z * length * length;
        arriving *= float(1.0 / falloff);
        if (cutoff < 180) {
            const float cosine = -dot(toLight, normalize(direction));
            if (cosine < math::cos(float(cutoff * (math::kPi / 180)))) return false;
            if (exponent != 0) arriving *= math::pow(cosine > 0 ? cosine : 0.0f, exponent);
        }
        return std::isfinite(arriving.r) && std::isfinite(arriving.g) && std::isfinite(arriving.b);
    }
};

const ShaderClassPtr& lightClass() {
    static const ShaderClassPtr made = std::make_shared<ShaderClass>(
        *openrt::shaderClass<FixedFunctionLight>("fixed-function light"), nullptr);
    return made;
}

template <class T>
void set(ParameterValues& values, const char* name, const T& value) {
    std::vector<std::byte> bytes(sizeof(T));
    std::memcpy(bytes.data(), &value, sizeof(T));
    values[uint32_t(lightClass()->findParameter(name))] = std::move(bytes);
}

} // namespace

std::shared_ptr<const ShaderObject> makeFrameLight(const FixedLight& light) {
    ParameterValues values;
    set(values, "position", light.position);
    set(values, "color", glm::vec3(light.diffuse));
    set(values, "direction", light.spotDirection);
    set(values, "cutoff", light.spotCutoff);
    set(values, "exponent", light.spotExponent);
    set(values, "attenuation", glm::vec3(light.constantAttenuation, light.linearAttenuation,
                                         light.quadraticAttenuation));
    return std::make_shared<const ShaderObject>(lightClass(), values);
}

} // namespace smart
