// SPDX-License-Identifier: MIT
#include "tests/bench/truth.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/support/ray_sets.h"

namespace smart::bench {
namespace {

constexpr uint32_t kLeaf = 8;
constexpr int kCorners = 64, kBetween = 192;   // rays tried beside the ray itself
constexpr double kEqualDistances = 0x1p-22;    // relative
constexpr double kDistanceError = 0x1p-10;     // relative, allowed to the distance that is named

/// Half a unit in the last place of the largest of three floats.
double halfUlp(const float (&v)[3]) {
    const float largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    if (largest == 0) return 0;
    return std::ldexp(1.0, std::ilogb(largest) - 24);
}

} // namespace

struct Truth::NearRay {
    double org[3], dir[3], tNear, tFar;

    /// Distance at which the ray meets the triangle; NaN if it does not. Edge functions of
    /// neighbours are each other's negatives to the bit, whatever rounding does to them, so that
    /// nothing passes between them.
    double meet(const Triangle& triangle) const {
        const float* corners[3] = {triangle.v0, triangle.v1, triangle.v2};
        double edge[3];
        for (int e = 0; e < 3; ++e) {
            const float *a = corners[(e + 1) % 3], *b = corners[(e + 2) % 3];
            const bool swapped = std::lexicographical_compare(b, b + 3, a, a + 3);
            if (swapped) std::swap(a, b);
            double p[3], q[3], value = 0;
            for (int k = 0; k < 3; ++k) {
                p[k] = a[k] - org[k];
                q[k] = b[k] - org[k];
            }
            for (int k = 0; k < 3; ++k) {
                const int i = (k + 1) % 3, j = (k + 2) % 3;
                value += dir[k] * (p[i] * q[j] - p[j] * q[i]);
            }
            edge[e] = swapped ? -value : value;
        }
        const auto [least, most] = std::minmax({edge[0], edge[1], edge[2]});
        const double sum = edge[0] + edge[1] + edge[2];
        if ((least < 0 && most > 0) || sum == 0) return NAN;
        double e1[3], e2[3], normal[3], above = 0, along = 0;
        for (int k = 0; k < 3; ++k) {
            e1[k] = double(triangle.v1[k]) - triangle.v0[k];
            e2[k] = double(triangle.v2[k]) - triangle.v0[k];
        }
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            normal[k] = e1[i] * e2[j] - e1[j] * e2[i];
            above += normal[k] * (triangle.v0[k] - org[k]);
            along += normal[k] * dir[k];
        }
        const double t = above / along;
        return t >= tNear && t <= tFar ? t : NAN;
    }
};

void Truth::build() const {
    order_.resize(triangles_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.clear();
    nodes_.push_back({});
    if (!order_.empty()) split(0, 0, uint32_t(order_.size()));
    for (const Triangle& triangle : triangles_) {
        for (const float* v : {triangle.v0, triangle.v1, triangle.v2})
            for (int k = 0; k < 3; ++k)
                if (std::isfinite(v[k])) largest_ = std::max(largest_, double(std::abs(v[k])));
    }
}

void Truth::split(uint32_t node, uint32_t first, uint32_t last) const {
    Node box{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, first, last - first};
    for (uint32_t i = first; i < last; ++i) {
        const Triangle& triangle = triangles_[order_[i]];
        for (const float* v : {triangle.v0, triangle.v1, triangle.v2}) {
            for (int k = 0; k < 3; ++k) {
                box.lo[k] = std::min(box.lo[k], v[k]);
                box.hi[k] = std::max(box.hi[k], v[k]);
            }
        }
    }
    if (last - first > kLeaf) {
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (box.hi[k] - box.lo[k] > box.hi[axis] - box.lo[axis]) axis = k;
        const auto centre = [&](uint32_t number) {
            const Triangle& t = triangles_[number];
            return double(t.v0[axis]) + t.v1[axis] + t.v2[axis];
        };
        const uint32_t middle = first + (last - first) / 2;
        std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                         [&](uint32_t a, uint32_t b) { return centre(a) < centre(b); });
        box.first = uint32_t(nodes_.size());
        box.count = 0;
        nodes_.resize(nodes_.size() + 2);
        nodes_[node] = box;
        split(box.first, first, middle);
        split(box.first + 1, middle, last);
        return;
    }
    nodes_[node] = box;
}

std::vector<uint32_t> Truth::candidates(const Ray& ray) const {
    std::call_once(built_, [this] { build(); });
    std::vector<uint32_t> found;
    if (order_.empty()) return found;
    double reach = largest_;
    for (const float v : ray.org) reach = std::max(reach, double(std::abs(v)));
    const double pad = reach * 0x1p-18; // far more than rays near the ray stray
    std::vector<uint32_t> stack{0};
    while (!stack.empty()) {
        const Node& node = nodes_[stack.back()];
        stack.pop_back();
        double low = -INFINITY, high = INFINITY;
        bool beside = false;
        for (int k = 0; k < 3; ++k) {
            const double lo = node.lo[k] - pad - ray.org[k], hi = node.hi[k] + pad - ray.org[k];
            if (ray.dir[k] == 0) {
                beside = beside || lo > 0 || hi < 0;
                continue;
            }
            const double a = lo / ray.dir[k], b = hi / ray.dir[k];
            low = std::max(low, std::min(a, b));
            high = std::min(high, std::max(a, b));
        }
        if (beside || low > high || high < ray.tNear * (1 - 0x1p-18) ||
            low > ray.tFar * (1 + 0x1p-18))
            continue;
        if (node.count == 0) {
            stack.push_back(node.first);
            stack.push_back(node.first + 1);
        } else {
            found.insert(found.end(), order_.begin() + node.first,
                         order_.begin() + node.first + node.count);
        }
    }
    return found;
}

template <class Accept>
Verdict Truth::judge(const Ray& ray, const Accept& accept) const {
    NearRay exact;
    for (int k = 0; k < 3; ++k) {
        exact.org[k] = ray.org[k];
        exact.dir[k] = ray.dir[k];
    }
    exact.tNear = std::max(ray.tNear, 0.0f);
    exact.tFar = ray.tFar;
    if (accept(exact)) return Verdict::Right;
    const double org = halfUlp(ray.org), dir = halfUlp(ray.dir);
    test::Random random(1);
    for (int i = 0; i < kCorners + kBetween; ++i) {
        NearRay near = exact;
        const auto step = [&](int number) {
            return i < kCorners ? (i >> number & 1 ? 1.0 : -1.0) : random.between(-1, 1);
        };
        for (int k = 0; k < 3; ++k) {
            near.org[k] += org * step(k);
            near.dir[k] += dir * step(3 + k);
        }
        near.tNear *= 1 - 0x1p-24;
        near.tFar *= 1 + 0x1p-24 * (i % 3 - 1);
        if (accept(near)) return Verdict::Tie;
    }
    return Verdict::Wrong;
}

Verdict Truth::closest(const Ray& ray, uint32_t triangle, float t) const {
    if (triangle != kNoHit && triangle >= triangles_.size()) return Verdict::Wrong;
    const std::vector<uint32_t> near = candidates(ray);
    return judge(ray, [&](const NearRay& one) {
        double own = INFINITY;
        if (triangle != kNoHit) {
            own = one.meet(triangles_[triangle]);
            if (!(std::abs(own - t) <= kDistanceError * std::abs(own))) return false;
        }
        return std::none_of(near.begin(), near.end(), [&](uint32_t number) {
            const double other = one.meet(triangles_[number]);
            return triangle == kNoHit ? !std::isnan(other)
                                      : other < own - kEqualDistances * std::abs(own);
        });
    });
}

Verdict Truth::any(const Ray& ray, bool blocked) const {
    const std::vector<uint32_t> near = candidates(ray);
    return judge(ray, [&](const NearRay& one) {
        return blocked == std::any_of(near.begin(), near.end(), [&](uint32_t number) {
                   return !std::isnan(one.meet(triangles_[number]));
               });
    });
}

} // namespace smart::bench
