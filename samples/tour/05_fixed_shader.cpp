// SPDX-License-Identifier: MIT
// A C++ program on the core, without the C interface: it makes its model, scene and frame itself,
// and compiles its one shader into the tracer. Between a hit and the shader there is no table and
// no pointer to a function; packets of sixteen points are shaded by the same template.
#include <cmath>
#include <cstdio>
#include <exception>

#include <glm/gtc/matrix_transform.hpp>

#include "libsmart/geometry/model_builder.h"
#include "libsmart/render/frame_queue.h"
#include "libsmart/render/packet_tracer.h"
#include "libsmart/render/worker.h"
#include "samples/common/refuse_options.h"
#include "samples/common/write_png.h"

namespace {

/// Land coloured by its height, with contour lines, under a sun that casts shadows.
struct Contours {
    static constexpr bool shadesPackets = true;
    static constexpr RTuint reads() {
        return openrt::READS_POSITION | openrt::READS_FACING_NORMAL | openrt::READS_TRACE;
    }
    static constexpr float kInterval = 0.12f, kLine = 0.05f; ///< of heights; of an interval

    openrt::Color low{0.10f, 0.35f, 0.12f}, high{0.75f, 0.65f, 0.45f}, ink{0.15f, 0.1f, 0.05f};
    openrt::Vec3 sun{0.55f, 0.65f, 0.52f};

    template <class Context>
    void shade(Context& c) const {
        using Float = typename Context::Float;
        using Color = typename Context::Color;
        const Float height = c.position().y;
        const Float share = openrt::max(Float(0.0f), openrt::min(Float(1.0f), height + 0.5f));
        const Color ground = low * (1.0f - share) + high * share;
        const Float steps = height / kInterval;
        const Color paint = select(steps - openrt::floor(steps) < kLine, Color(ink), ground);
        const auto direction = typename Context::Vec3(sun);
        const Float cosine = dot(c.facingNormal(), direction);
        const auto lit = cosine > 0.0f;
        const Float far = 1e9f;
        c.setRadiance(paint * 0.2f + paint * c.shadow(c.position(), direction, far, lit) * cosine);
    }
};

/// A square of hills around the origin.
smart::ModelPtr makeHills() {
    constexpr int kSteps = 200;
    smart::ModelBuilder builder;
    const auto corner = [](int i, int j, float (&to)[3]) {
        const double x = 4.0 * i / kSteps - 2.0, z = 4.0 * j / kSteps - 2.0;
        to[0] = float(x);
        to[1] = float(0.3 * std::sin(3.1 * x) * std::cos(2.3 * z) + 0.2 * std::sin(5 * z + x));
        to[2] = float(z);
    };
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            smart::Triangle a, b;
            corner(i, j, a.v0);
            corner(i, j + 1, a.v1);
            corner(i + 1, j + 1, a.v2);
            corner(i, j, b.v0);
            corner(i + 1, j + 1, b.v1);
            corner(i + 1, j, b.v2);
            builder.triangles.push_back(a);
            builder.triangles.push_back(b);
        }
    return std::move(builder).build();
}

} // namespace

int main(int argc, char* argv[]) try {
    refuseOptions(argc, argv, "05_fixed_shader [FILE]");
    constexpr uint32_t kWidth = 640, kHeight = 480;
    std::vector<unsigned char> pixels(4 * kWidth * kHeight);

    smart::Instance hills;
    hills.model = makeHills();
    const auto shader = std::make_shared<const smart::ShaderObject>(
        std::make_shared<const smart::ShaderClass>(*openrt::shaderClass<Contours>("Contours"),
                                                   nullptr),
        smart::ParameterValues());

    const auto frame = std::make_shared<smart::Frame>();
    frame->scene = std::make_shared<const smart::Scene>(
        std::vector<smart::Instance>{hills}, smart::Precision::Watertight, smart::coreCount());
    frame->shaders = std::make_shared<const smart::ShaderTable>(smart::ShaderTable{shader});
    const glm::dmat4 camera =
        glm::perspective(0.7, double(kWidth) / kHeight, 0.1, 100.0) *
        glm::lookAt(glm::dvec3(0, 2.6, 4.2), glm::dvec3(0, -0.1, 0), glm::dvec3(0, 1, 0));
    frame->matrixCamera = {camera, glm::inverse(camera)};
    frame->clearColor = {0.45f, 0.6f, 0.8f, 1.0f};
    frame->viewport = {0, 0, kWidth, kHeight};
    frame->samples = 4;
    frame->target.memory = pixels.data();
    frame->target.width = kWidth;
    frame->target.height = kHeight;
    frame->target.format = smart::PixelFormat::Rgba8;
    frame->target.srgb = true;

    const smart::PacketTracer<smart::FixedShading<Contours>> tracer;
    smart::FrameQueue queue;
    const smart::QueuedFramePtr queued = queue.prepare(frame);
    queue.submit(queued);
    queue.close(); // sends the team home when the frame is done
    { const smart::ThreadTeam team(smart::coreCount(), queue, tracer); }
    if (const std::exception_ptr error = queued->takeError()) std::rethrow_exception(error);
    return writePng(argc > 1 ? argv[1] : "05_fixed_shader.png", pixels.data(), kWidth, kHeight)
               ? 0
               : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "05_fixed_shader: %s\n", error.what());
    return 1;
}
