// SPDX-License-Identifier: MIT
#include "tests/bench/phong_frame.h"

#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "libsmart/shading/shader_registry.h"

namespace smart::bench {
namespace {

std::vector<std::byte> bytesOf(const glm::vec3& value) {
    std::vector<std::byte> bytes(sizeof value);
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

} // namespace

std::unique_ptr<Frame> phongFrame(const ScenePtr& scene, const View& view, uint32_t size,
                                  std::vector<float>& pixels) {
    const auto vector = [](const double (&v)[3]) { return glm::dvec3(v[0], v[1], v[2]); };
    const glm::dvec3 eye = vector(view.camera.eye), target = vector(view.camera.target);
    const glm::dvec3 toLight = vector(view.light) - target;
    const double distance = glm::length(target - eye);
    const ShaderClassPtr light = findBuiltinClass("PointLight");
    const ParameterValues values{
        {uint32_t(light->findParameter("position")), bytesOf(glm::vec3(vector(view.light)))},
        {uint32_t(light->findParameter("radiance")),
         bytesOf(glm::vec3(float(glm::dot(toLight, toLight))))}};
    const glm::dmat4 matrix =
        glm::perspective(glm::radians(view.camera.fov), 1.0, distance * 1e-3, distance * 1e3) *
        glm::lookAt(eye, target, vector(view.camera.up));

    auto frame = std::make_unique<Frame>();
    frame->scene = scene;
    frame->shaders = std::make_shared<const ShaderTable>(ShaderTable{
        std::make_shared<const ShaderObject>(findBuiltinClass("Phong"), ParameterValues())});
    frame->lights = {std::make_shared<const ShaderObject>(light, values)};
    frame->matrixCamera = {matrix, glm::inverse(matrix)};
    frame->viewport = {0, 0, size, size};
    pixels.resize(std::size_t(size) * size * 4);
    frame->target.memory = pixels.data();
    frame->target.width = frame->target.height = size;
    frame->target.format = PixelFormat::Rgba32f;
    return frame;
}

} // namespace smart::bench
