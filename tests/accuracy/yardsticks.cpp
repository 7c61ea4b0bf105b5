// SPDX-License-Identifier: MIT
// Well-known tests in plain float, asked of every triangle: what they lose is lost by the test
// itself, not by a tree.
#include <cmath>

#include "tests/accuracy/engine.h"
#include "tests/support/woop_brute_force.h"

namespace smart::test {
namespace {

/// Moeller, Trumbore, "Fast, minimum storage ray/triangle intersection", 1997.
Claim mollerTrumbore(std::span<const Triangle> triangles, const Ray& ray) {
    const float* d = ray.dir;
    Claim claim;
    float best = INFINITY;
    for (std::size_t n = 0; n < triangles.size(); ++n) {
        const Triangle& triangle = triangles[n];
        float e1[3], e2[3], p[3], q[3], s[3];
        for (int k = 0; k < 3; ++k) {
            e1[k] = triangle.v1[k] - triangle.v0[k];
            e2[k] = triangle.v2[k] - triangle.v0[k];
            s[k] = ray.org[k] - triangle.v0[k];
        }
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            p[k] = d[i] * e2[j] - d[j] * e2[i];
            q[k] = s[i] * e1[j] - s[j] * e1[i];
        }
        const float determinant = e1[0] * p[0] + e1[1] * p[1] + e1[2] * p[2];
        if (determinant == 0) continue;
        const float inverse = 1 / determinant;
        const float u = (s[0] * p[0] + s[1] * p[1] + s[2] * p[2]) * inverse;
        if (!(u >= 0 && u <= 1)) continue;
        const float v = (d[0] * q[0] + d[1] * q[1] + d[2] * q[2]) * inverse;
        if (!(v >= 0 && u + v <= 1)) continue;
        const float t = (e2[0] * q[0] + e2[1] * q[1] + e2[2] * q[2]) * inverse;
        if (!(t >= std::fmax(ray.tNear, 0.0f) && t <= ray.tFar && t < best)) continue;
        best = t;
        claim = {uint32_t(n), t, u, v};
    }
    return claim;
}

/// Wald, "Realtime ray tracing and interactive global illumination", PhD thesis 2004, section 7.1.
struct WaldRecord {
    int axis = -1;
    float nu, nv, nd, bu, bv, bd, cu, cv, cd;

    explicit WaldRecord(const Triangle& triangle) {
        double e1[3], e2[3], n[3];
        for (int k = 0; k < 3; ++k) {
            e1[k] = double(triangle.v1[k]) - triangle.v0[k];
            e2[k] = double(triangle.v2[k]) - triangle.v0[k];
        }
        int k = 0;
        for (int c = 0; c < 3; ++c) {
            const int i = (c + 1) % 3, j = (c + 2) % 3;
            n[c] = e1[i] * e2[j] - e1[j] * e2[i];
            if (std::abs(n[c]) > std::abs(n[k])) k = c;
        }
        if (!(std::abs(n[k]) > 0) || !std::isfinite(n[0] + n[1] + n[2])) return;
        axis = k;
        const int u = (k + 1) % 3, v = (k + 2) % 3;
        const float* a = triangle.v0;
        nu = float(n[u] / n[k]);
        nv = float(n[v] / n[k]);
        nd = float((n[0] * a[0] + n[1] * a[1] + n[2] * a[2]) / n[k]);
        bu = float(e2[v] / n[k]);
        bv = float(-e2[u] / n[k]);
        bd = float((e2[u] * a[v] - e2[v] * a[u]) / n[k]);
        cu = float(-e1[v] / n[k]);
        cv = float(e1[u] / n[k]);
        cd = float((e1[v] * a[u] - e1[u] * a[v]) / n[k]);
    }
};

Claim waldNearest(std::span<const WaldRecord> records, const Ray& ray) {
    Claim claim;
    float best = INFINITY;
    for (std::size_t n = 0; n < records.size(); ++n) {
        const WaldRecord& r = records[n];
        if (r.axis < 0) continue;
        const int k = r.axis, ku = (k + 1) % 3, kv = (k + 2) % 3;
        const float t = (r.nd - ray.org[k] - r.nu * ray.org[ku] - r.nv * ray.org[kv]) /
                        (ray.dir[k] + r.nu * ray.dir[ku] + r.nv * ray.dir[kv]);
        if (!(t >= std::fmax(ray.tNear, 0.0f) && t <= ray.tFar && t < best)) continue;
        const float hu = ray.org[ku] + t * ray.dir[ku], hv = ray.org[kv] + t * ray.dir[kv];
        const float u = r.bu * hu + r.bv * hv + r.bd, v = r.cu * hu + r.cv * hv + r.cd;
        if (!(u >= 0 && v >= 0 && u + v <= 1)) continue;
        best = t;
        claim = {uint32_t(n), t, u, v};
    }
    return claim;
}

template <typename Nearest>
class BruteForce final : public Engine {
public:
    explicit BruteForce(Nearest nearest) : nearest_(std::move(nearest)) {}
    void trace(std::span<const Ray> rays, Claim* claims) const override {
        for (const Ray& ray : rays) *claims++ = nearest_(ray);
    }

private:
    const Nearest nearest_;
};

/// `prepare` makes of a mesh what finds the nearest triangle of a ray.
template <typename Prepare>
EngineKind kind(const char* name, Prepare prepare) {
    EngineKind result;
    result.name = name;
    result.bruteForce = true;
    result.make = [prepare](const Geometry& geometry) -> EnginePtr {
        if (!geometry.plain()) return nullptr;
        auto nearest = prepare(geometry.meshes[0]);
        return std::make_unique<BruteForce<decltype(nearest)>>(std::move(nearest));
    };
    return result;
}

} // namespace

std::vector<EngineKind> yardstickKinds() {
    return {kind("moeller-trumbore",
                 [](std::vector<Triangle> mesh) {
                     return [mesh = std::move(mesh)](const Ray& ray) {
                         return mollerTrumbore(mesh, ray);
                     };
                 }),
            kind("wald",
                 [](const std::vector<Triangle>& mesh) {
                     return [records = std::vector<WaldRecord>(mesh.begin(), mesh.end())](
                                const Ray& ray) { return waldNearest(records, ray); };
                 }),
            kind("woop",
                 [](std::vector<Triangle> mesh) {
                     return [mesh = std::move(mesh)](const Ray& ray) {
                         return woopNearest<false>(mesh, ray);
                     };
                 }),
            kind("defect-contracted-woop", [](std::vector<Triangle> mesh) {
                return [mesh = std::move(mesh)](const Ray& ray) {
                    return woopNearest<true>(mesh, ray);
                };
            })};
}

} // namespace smart::test
