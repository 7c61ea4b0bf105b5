// SPDX-License-Identifier: MIT
#include <algorithm>
#include <stdexcept>

#include "openrt/rt.h"
#include "tests/bench/dynamic_engine.h"

namespace smart::bench {
namespace {

constexpr std::size_t kBatch = 64; ///< packets that one call traces

class DynamicOpenrt final : public DynamicEngine {
public:
    DynamicOpenrt(const DynamicScene& scene, unsigned threads, SheetWay way, uint32_t quality,
                  const std::string& name)
        : scene_(scene), way_(way), name_(name), context_(rtCreateContext()) {
        if (!context_) throw std::runtime_error("OpenRT makes no context");
        rtMakeCurrent(context_);
        rtThreads(threads);
        rtObjectHint(RT_BUILD_QUALITY, quality);
        object_ = rtNewObject(RT_DEFINE);
        if (scene.isSheet()) {
            giveStrips(scene.step(0).points);
        } else {
            rtBegin(RT_TRIANGLES);
            for (const Triangle& triangle : scene.triangles())
                for (const float* corner : {triangle.v0, triangle.v1, triangle.v2})
                    rtVertex3fv(corner);
            rtEnd();
        }
        rtEndObject();
        check();
        objectBytes_ = bytesNow();
    }
    ~DynamicOpenrt() override { rtDestroyContext(context_); }
    DynamicOpenrt(const DynamicOpenrt&) = delete;
    DynamicOpenrt& operator=(const DynamicOpenrt&) = delete;

    std::string name() const override { return name_; }
    bool peer() const override { return false; }

    void update(const DynamicStep& step) override {
        rtMakeCurrent(context_);
        if (bound_) rtDeleteScene(bound_);
        bound_ = rtGenScene();
        rtBindScene(bound_);
        if (scene_.isSheet()) {
            giveSheet(step.points);
            rtInstantiateObject(object_);
        } else {
            for (const auto& m : step.matrices) {
                const float matrix[16] = {m[0], m[1], m[2], 0, m[3], m[4],  m[5],  0,
                                          m[6], m[7], m[8], 0, m[9], m[10], m[11], 1};
                rtLoadMatrixf(matrix);
                rtInstantiateObject(object_);
            }
        }
        check();
    }

    void build() override {
        rtMakeCurrent(context_);
        if (compiled_) rtReleaseScene(compiled_);
        compiled_ = rtCompileScene();
        check();
    }

    void trace(const RaySet& rays, std::size_t first, std::size_t count,
               DynamicFound* found) const override {
        alignas(64) float t[kBatch * kPacketSize];
        alignas(64) uint32_t instance[kBatch * kPacketSize], triangle[kBatch * kPacketSize];
        for (std::size_t p = first, n = 0; p < first + count; p += n) {
            n = std::min(kBatch, first + count - p);
            const std::size_t at = p * kPacketSize;
            const RTraystream stream{rays.org[0].data(),      rays.org[1].data(),
                                     rays.org[2].data(),      rays.dir[0].data() + at,
                                     rays.dir[1].data() + at, rays.dir[2].data() + at,
                                     rays.tNear.data() + at,  rays.tFar.data() + at,
                                     RT_COMMON_ORIGIN};
            RThitstream hits{};
            hits.t = t;
            hits.instance = instance;
            hits.primitive = triangle;
            rtIntersectStream(compiled_, &stream, &hits, RTsizei(n * kPacketSize), RT_COHERENT);
            for (std::size_t i = 0; i < n; ++i) {
                std::copy_n(t + i * kPacketSize, kPacketSize, found[p + i].t);
                std::copy_n(instance + i * kPacketSize, kPacketSize, found[p + i].instance);
                std::copy_n(triangle + i * kPacketSize, kPacketSize, found[p + i].triangle);
            }
        }
    }

    std::size_t bytes() const override {
        rtMakeCurrent(context_);
        const std::size_t now = bytesNow();
        return scene_.isSheet() ? now : now - std::min(now, objectBytes_);
    }

private:
    static void check() {
        if (rtGetError() != RT_NO_ERROR) throw std::runtime_error(rtGetErrorText());
    }
    static std::size_t bytesNow() {
        RTint64 bytes = 0;
        rtGetInteger64v(RT_STAT_BYTES, &bytes);
        return std::size_t(bytes);
    }

    /// The vertices of the strips, in the order in which they are given.
    template <class Give>
    void forEachVertex(const std::vector<float>& points, const Give& give) const {
        const std::size_t width = scene_.columns() + 1;
        for (std::size_t row = 0; row < scene_.rows(); ++row) {
            for (std::size_t column = 0; column < width; ++column) {
                give(&points[(row * width + column) * 3], column == 0, false);
                give(&points[((row + 1) * width + column) * 3], false, column + 1 == width);
            }
        }
    }
    void giveStrips(const std::vector<float>& points) const {
        forEachVertex(points, [](const float* point, bool begins, bool ends) {
            if (begins) rtBegin(RT_QUAD_STRIP);
            rtVertex3fv(point);
            if (ends) rtEnd();
        });
    }
    void giveSheet(const std::vector<float>& points) {
        if (way_ != SheetWay::Update) {
            if (way_ == SheetWay::Redefine) {
                rtReplaceObject(object_);
            } else {
                rtRemoveObject(object_);
                object_ = rtNewObject(RT_DEFINE);
            }
            giveStrips(points);
            rtEndObject();
            return;
        }
        vertices_.clear();
        forEachVertex(points, [this](const float* point, bool, bool) {
            vertices_.insert(vertices_.end(), point, point + 3);
        });
        rtUpdateObject(object_, 0, RTsizei(vertices_.size() / 3), vertices_.data());
    }

    const DynamicScene& scene_;
    const SheetWay way_;
    const std::string name_;
    const RTcontext context_;
    RTuint object_ = 0, bound_ = 0, compiled_ = 0;
    std::size_t objectBytes_ = 0;
    std::vector<float> vertices_;
};

} // namespace

DynamicEnginePtr dynamicOpenrt(const DynamicScene& scene, unsigned threads, SheetWay way,
                               uint32_t quality, const std::string& name) {
    return std::make_unique<DynamicOpenrt>(scene, threads, way, quality, name);
}

} // namespace smart::bench
