// SPDX-License-Identifier: MIT
#include "tests/support/exact_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>

namespace smart::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<float>::max();
constexpr uint32_t kLeafSize = 4;

bool finite(const float* values) {
    return std::isfinite(values[0]) && std::isfinite(values[1]) && std::isfinite(values[2]);
}

/// The distance of floats at x.
double ulpAt(double x) {
    int exponent = 0;
    std::frexp(x, &exponent);
    return std::ldexp(1.0, std::max(exponent - 24, -149));
}

} // namespace

// With the corners seen from the origin as A, B, C and the direction d, the weights are
// d.(B x C), d.(C x A), d.(A x B), their sum is the denominator of the distance A.(B x C) / sum.
// Each is a sum of six products of three factors in which at most seven roundings of 2^-53 meet;
// 16 units of 2^-53 of the sum of absolute products bound the error with room to spare.
struct ExactScene::Filtered {
    double w[3], wBound[3], volume, volumeBound;

    Filtered(const std::array<double, 9>& v, const Ray& ray) {
        double p[9], d[3];
        for (int k = 0; k < 3; ++k) d[k] = ray.dir[k];
        for (std::size_t k = 0; k < 9; ++k) p[k] = v[k] - ray.org[k % 3];
        for (int c = 0; c < 3; ++c) {
            const int b = 3 * ((c + 1) % 3), e = 3 * ((c + 2) % 3);
            double sum = 0, size = 0;
            volume = volumeBound = 0;
            for (int k = 0; k < 3; ++k) {
                const int i = (k + 1) % 3, j = (k + 2) % 3;
                const double plus = p[b + i] * p[e + j], minus = p[b + j] * p[e + i];
                const double scale = std::abs(plus) + std::abs(minus);
                sum += d[k] * (plus - minus);
                size += std::abs(d[k]) * scale;
                volume += p[3 * c + k] * (plus - minus);
                volumeBound += std::abs(p[3 * c + k]) * scale;
            }
            w[c] = sum;
            wBound[c] = size * 0x1p-49;
        }
        volumeBound *= 0x1p-49;
    }
};

struct ExactScene::Exact {
    Expansion p[9];
    double d[3];

    Exact(const std::array<double, 9>& v, const Ray& ray) {
        for (int k = 0; k < 3; ++k) d[k] = ray.dir[k];
        for (std::size_t k = 0; k < 9; ++k) p[k] = Expansion::difference(v[k], ray.org[k % 3]);
    }
    Expansion normal(int c, int k) const { // component k of the cross product of the other corners
        const int b = 3 * ((c + 1) % 3), e = 3 * ((c + 2) % 3), i = (k + 1) % 3, j = (k + 2) % 3;
        return p[b + i] * p[e + j] - p[b + j] * p[e + i];
    }
    Expansion weight(int c) const {
        Expansion sum;
        for (int k = 0; k < 3; ++k) {
            if (d[k] != 0) sum = sum + normal(c, k) * Expansion(d[k]);
        }
        return sum;
    }
    Expansion volume() const {
        return p[0] * normal(0, 0) + p[1] * normal(0, 1) + p[2] * normal(0, 2);
    }
    Expansion sum() const { return weight(0) + weight(1) + weight(2); }
};

/// t = volume / sum.
struct Distance {
    Expansion volume, sum;
};

/// A crossing that may be the nearest, and its exact distance once somebody asked.
struct ExactScene::Contender {
    Crossing crossing;
    std::shared_ptr<const Distance> exact;

    const Distance& exactly(const ExactScene& scene, const Ray& ray) {
        if (!exact) {
            const Exact at(scene.reference_.corners(crossing.triangle), ray);
            exact = std::make_shared<const Distance>(Distance{at.volume(), at.sum()});
        }
        return *exact;
    }
};

ExactScene::ExactScene(const ExactReference& reference)
    : reference_(reference), delta_(verdictDelta(reference)), maxAbs_(reference.maxAbs()) {
    for (uint32_t i = 0; i < reference.count(); ++i) {
        if (reference.degenerate(i)) continue;
        if (!reference.exactInDouble(i)) throw std::invalid_argument("corners are rounded");
        order_.push_back(i);
    }
    if (order_.empty()) return;
    nodes_.emplace_back();
    build(0, 0, uint32_t(order_.size()));
}

void ExactScene::build(uint32_t node, uint32_t first, uint32_t last) {
    Node box{{kInfinity, kInfinity, kInfinity},
             {-kInfinity, -kInfinity, -kInfinity},
             first,
             last - first};
    double lo[3] = {kInfinity, kInfinity, kInfinity}, hi[3] = {-kInfinity, -kInfinity, -kInfinity};
    const auto centre = [&](uint32_t triangle, std::size_t k) {
        const auto& v = reference_.corners(triangle);
        return v[k] + v[3 + k] + v[6 + k];
    };
    for (uint32_t at = first; at < last; ++at) {
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t c = 0; c < 9; c += 3) {
                box.lo[k] = std::min(box.lo[k], reference_.corners(order_[at])[c + k]);
                box.hi[k] = std::max(box.hi[k], reference_.corners(order_[at])[c + k]);
            }
            lo[k] = std::min(lo[k], centre(order_[at], k));
            hi[k] = std::max(hi[k], centre(order_[at], k));
        }
    }
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) {
        if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
    }
    if (last - first <= kLeafSize) {
        nodes_[node] = box;
        return;
    }
    const uint32_t middle = first + (last - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](uint32_t a, uint32_t b) { return centre(a, axis) < centre(b, axis); });
    box.first = uint32_t(nodes_.size());
    box.count = 0;
    nodes_[node] = box;
    nodes_.resize(nodes_.size() + 2);
    build(box.first, first, middle);
    build(box.first + 1, middle, last);
}

/// visit(triangle, limit) for all triangles whose boxes the ray's line meets, at most `limit` away,
/// which the visits may lower. Boxes are padded by 1e-11 of the largest coordinate, ten thousand
/// times what the roundings of a slab's distances can move them.
template <typename Visit>
void ExactScene::visitNear(const Ray& ray, const Visit& visit) const {
    if (nodes_.empty()) return;
    double scale = maxAbs_, inverse[3];
    for (int k = 0; k < 3; ++k) {
        scale = std::max(scale, double(std::abs(ray.org[k])));
        inverse[k] = 1.0 / double(ray.dir[k]);
    }
    const double pad = 1e-11 * scale;
    double limit = kInfinity;
    const auto enter = [&](const Node& node) {
        double from = -kInfinity, to = kInfinity;
        for (int k = 0; k < 3; ++k) {
            const double low = node.lo[k] - pad - ray.org[k], high = node.hi[k] + pad - ray.org[k];
            if (ray.dir[k] == 0) {
                if (low > 0 || high < 0) return kInfinity;
                continue;
            }
            const double a = low * inverse[k], b = high * inverse[k];
            from = std::max(from, std::min(a, b));
            to = std::min(to, std::max(a, b));
        }
        return from <= to && to >= 0 ? from : kInfinity;
    };
    struct Entry {
        uint32_t node;
        double from;
    } stack[64];
    int top = 0;
    const double root = enter(nodes_[0]);
    if (root < kInfinity) stack[top++] = {0, root};
    while (top > 0) {
        const Entry entry = stack[--top];
        if (entry.from > limit) continue;
        const Node& node = nodes_[entry.node];
        for (uint32_t i = 0; i < node.count; ++i) visit(order_[node.first + i], limit);
        if (node.count) continue;
        const Entry left = {node.first, enter(nodes_[node.first])};
        const Entry right = {node.first + 1, enter(nodes_[node.first + 1])};
        const bool leftFirst = left.from <= right.from;
        const Entry &sooner = leftFirst ? left : right, &later = leftFirst ? right : left;
        if (later.from < kInfinity) stack[top++] = later;
        if (sooner.from < kInfinity) stack[top++] = sooner;
    }
}

bool ExactScene::crosses(uint32_t triangle, const Ray& ray, Crossing& crossing) const {
    const std::array<double, 9>& v = reference_.corners(triangle);
    Filtered f(v, ray);
    bool positive = false, negative = false, unsure = false;
    for (int c = 0; c < 3; ++c) {
        positive = positive || f.w[c] > f.wBound[c];
        negative = negative || f.w[c] < -f.wBound[c];
        unsure = unsure || !(std::abs(f.w[c]) > f.wBound[c]);
    }
    if (positive && negative) return false;
    crossing.triangle = triangle;
    crossing.zeros = 0;
    if (unsure) {
        const Exact exact(v, ray);
        for (int c = 0; c < 3; ++c) {
            if (std::abs(f.w[c]) > f.wBound[c]) continue;
            const Expansion weight = exact.weight(c);
            positive = positive || weight.sign() > 0;
            negative = negative || weight.sign() < 0;
            if (positive && negative) return false;
            if (weight.sign() == 0) crossing.zeros |= 1u << c;
            f.w[c] = weight.value();
            f.wBound[c] = std::abs(f.w[c]) * 0x1p-50;
        }
    }
    if (!positive && !negative) return false; // along the plane
    crossing.facing = positive ? 1 : -1;
    const double sum = f.w[0] + f.w[1] + f.w[2]; // all of one sign: no cancellation
    const double bound = f.wBound[0] + f.wBound[1] + f.wBound[2] + std::abs(sum) * 0x1p-51;
    crossing.t = f.volume / sum;
    const double least = std::abs(sum) - bound;
    crossing.error = least > 0 ? (f.volumeBound + std::abs(crossing.t) * bound) / least * 1.001 +
                                     std::abs(crossing.t) * 0x1p-52
                               : kInfinity;
    return true;
}

/// The sign of a.t - b.t.
int ExactScene::compareT(const Ray& ray, Contender& a, Contender& b) const {
    const Crossing &first = a.crossing, &second = b.crossing;
    if (first.t - first.error > second.t + second.error) return 1;
    if (first.t + first.error < second.t - second.error) return -1;
    const Distance &p = a.exactly(*this, ray), &q = b.exactly(*this, ray);
    return (p.volume * q.sum - q.volume * p.sum).sign() * first.facing * second.facing;
}

int ExactScene::compareT(const Ray& ray, Contender& a, double limit) const {
    const Crossing& crossing = a.crossing;
    if (crossing.t - crossing.error > limit) return 1;
    if (crossing.t + crossing.error < limit || limit == kInfinity) return -1;
    const Distance& exact = a.exactly(*this, ray);
    return (exact.volume - exact.sum * Expansion(limit)).sign() * crossing.facing;
}

Truth ExactScene::nearest(const Ray& ray) const {
    Truth truth;
    if (!finite(ray.org) || !finite(ray.dir)) return truth;
    if (ray.dir[0] == 0 && ray.dir[1] == 0 && ray.dir[2] == 0) return truth;
    const double tNear = std::max(ray.tNear, 0.0f);
    if (std::isnan(ray.tNear) || std::isnan(ray.tFar) || !(tNear <= ray.tFar)) return truth;
    const double tFar = ray.tFar;

    std::vector<Contender> contenders;
    visitNear(ray, [&](uint32_t triangle, double& limit) {
        Contender contender;
        Crossing& crossing = contender.crossing;
        if (!crosses(triangle, ray, crossing)) return;
        if (crossing.t - crossing.error > limit) return;
        if (compareT(ray, contender, tNear) < 0 || compareT(ray, contender, tFar) > 0) return;
        if (crossing.zeros == 0 && crossing.t - crossing.error > tNear &&
            crossing.t + crossing.error < kLargest) {
            limit = std::min(limit, crossing.t + crossing.error);
        }
        contenders.push_back(std::move(contender));
    });
    std::vector<Touch> layer;
    while (!contenders.empty() && !truth.must) {
        std::vector<Contender> first, rest;
        for (Contender& contender : contenders) {
            const int side = first.empty() ? -1 : compareT(ray, contender, first[0]);
            if (side < 0) {
                rest.insert(rest.end(), first.begin(), first.end());
                first.clear();
            }
            (side > 0 ? rest : first).push_back(std::move(contender));
        }
        // Beyond the largest float a distance has no name.
        const bool atLimit = compareT(ray, first[0], tNear) == 0 ||
                             compareT(ray, first[0], tFar) == 0 ||
                             compareT(ray, first[0], kLargest) > 0;
        layer.clear();
        for (const Contender& contender : first) layer.push_back(contender.crossing);
        truth.must = !atLimit && reference_.topology().isMust(layer);
        std::vector<Crossing>& kind = truth.must ? truth.nearest : truth.touches;
        for (const Contender& contender : first) kind.push_back(contender.crossing);
        contenders = std::move(rest);
    }
    return truth;
}

Verdict ExactScene::judge(const Truth& truth, const Ray& ray, const Claim& claim) const {
    if (claim.triangle == kNoHit) return truth.must ? Verdict::Miss : Verdict::Right;
    const auto isClaimed = [&](const Crossing& crossing) {
        return crossing.triangle == claim.triangle;
    };
    for (const auto* crossings : {&truth.nearest, &truth.touches}) {
        const auto found = std::find_if(crossings->begin(), crossings->end(), isClaimed);
        if (found == crossings->end()) continue;
        if (found->t > kLargest && claim.t >= float(kLargest)) return Verdict::Right;
        double square = 0;
        for (float x : ray.dir) square += double(x) * x;
        // Well within delta, or the same float: the rest is left to the reference.
        const double length = std::sqrt(square), off = std::abs(claim.t - found->t) + found->error;
        if (off * length <= 0.5 * delta_ || off <= ulpAt(found->t)) return Verdict::Right;
    }
    ExactAnswer answer;
    answer.must = truth.must;
    const auto convert = [&](const std::vector<Crossing>& from, std::vector<ExactCrossing>& to) {
        for (const Crossing& crossing : from) {
            ExactCrossing exact;
            if (reference_.crosses(crossing.triangle, ray, exact)) to.push_back(std::move(exact));
        }
    };
    convert(truth.nearest, answer.nearest);
    convert(truth.touches, answer.touches);
    return test::judge(reference_, answer, ray, claim);
}

ClaimErrors ExactScene::errors(const Ray& ray, const Claim& claim) const {
    const std::array<double, 9>& v = reference_.corners(claim.triangle);
    const Filtered f(v, ray);
    const double sum = f.w[0] + f.w[1] + f.w[2];
    const double bound = f.wBound[0] + f.wBound[1] + f.wBound[2] + std::abs(sum) * 0x1p-51;
    const double least = std::abs(sum) - bound;
    std::optional<Exact> exact;
    // |value - numerator / sum| in units(quotient), from double where that is sure to a thousandth.
    const auto error = [&](float value, double numerator, double numeratorBound, const auto& units,
                           const auto& exactly) {
        if (least > 0) {
            const double quotient = numerator / sum, unit = units(quotient);
            const double off = std::abs(value - quotient) / unit;
            const double doubt = (numeratorBound + std::abs(quotient) * bound) / least / unit +
                                 std::abs(quotient) * 0x1p-52 / unit;
            if (doubt < 1e-3 && (off + doubt < 0.5 || off - doubt > 0.5)) return off;
        }
        if (!exact) exact.emplace(v, ray);
        const Expansion denominator = exact->sum(), top = exactly(*exact);
        const Expansion rest = Expansion(double(value)) * denominator - top;
        return std::abs(rest.value() / denominator.value()) /
               units(top.value() / denominator.value());
    };
    const auto units24 = [](double) { return 0x1p-24; };
    ClaimErrors errors{};
    errors.t =
        error(claim.t, f.volume, f.volumeBound, ulpAt, [](const Exact& e) { return e.volume(); });
    const float claimed[2] = {claim.u, claim.v};
    for (int k = 0; k < 2; ++k) {
        const auto weight = [&](const Exact& e) { return e.weight(k + 1); };
        const double w = f.w[k + 1], wBound = f.wBound[k + 1];
        errors.uv = std::max(errors.uv, error(claimed[k], w, wBound, units24, weight));
        errors.uvUlp = std::max(errors.uvUlp, error(claimed[k], w, wBound, ulpAt, weight));
    }
    return errors;
}

} // namespace smart::test
