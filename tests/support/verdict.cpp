// SPDX-License-Identifier: MIT
#include "tests/support/verdict.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace smart::test {
namespace {

/// Distance of a point from a triangle, in double.
double distance(const double point[3], const std::array<double, 9>& corners) {
    const auto inner = [](const double* a, const double* b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    double edge[3][3], offset[3][3], normal[3];
    for (int c = 0; c < 3; ++c) {
        for (int k = 0; k < 3; ++k) {
            edge[c][k] = corners[3 * ((c + 1) % 3) + k] - corners[3 * c + k];
            offset[c][k] = point[k] - corners[3 * c + k];
        }
    }
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        normal[k] = edge[0][i] * edge[1][j] - edge[0][j] * edge[1][i];
    }
    bool inside = true;
    double nearest = INFINITY;
    for (int c = 0; c < 3; ++c) {
        double side[3], rest = 0;
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            side[k] = normal[i] * edge[c][j] - normal[j] * edge[c][i];
        }
        inside = inside && inner(side, offset[c]) >= 0;
        const double square = inner(edge[c], edge[c]);
        const double along =
            square > 0 ? std::clamp(inner(edge[c], offset[c]) / square, 0.0, 1.0) : 0.0;
        for (int k = 0; k < 3; ++k) {
            const double x = offset[c][k] - along * edge[c][k];
            rest += x * x;
        }
        nearest = std::min(nearest, std::sqrt(rest));
    }
    const double size = std::sqrt(inner(normal, normal));
    if (inside && size > 0) nearest = std::min(nearest, std::abs(inner(normal, offset[0])) / size);
    return nearest;
}

const ExactCrossing* find(const std::vector<ExactCrossing>& crossings, uint32_t triangle) {
    const auto place = std::find_if(crossings.begin(), crossings.end(),
                                    [&](const auto& c) { return c.triangle == triangle; });
    return place == crossings.end() ? nullptr : &*place;
}

int facingInDouble(const std::array<double, 9>& v, const Ray& ray) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        sum += ray.dir[k] *
               ((v[3 + i] - v[i]) * (v[6 + j] - v[j]) - (v[3 + j] - v[j]) * (v[6 + i] - v[i]));
    }
    return (sum > 0) - (sum < 0);
}

} // namespace

double verdictDelta(const ExactReference& reference) {
    return std::min(std::ldexp(reference.maxAbs(), -16), 0.25 * reference.extent());
}

Verdict judge(const ExactReference& reference, const ExactAnswer& truth, const Ray& ray,
              const Claim& claim) {
    if (claim.triangle == kNoHit) return truth.must ? Verdict::Miss : Verdict::Right;
    if (claim.triangle >= reference.count() || !std::isfinite(claim.t)) return Verdict::Gross;
    const double delta = verdictDelta(reference);
    double point[3], length = 0;
    for (int k = 0; k < 3; ++k) {
        point[k] = ray.org[k] + double(claim.t) * ray.dir[k];
        length += double(ray.dir[k]) * ray.dir[k];
    }
    length = std::sqrt(length);
    const ExactCrossing* exact = find(truth.nearest, claim.triangle);
    if (!exact) exact = find(truth.touches, claim.triangle);
    if (exact && (std::abs(claim.t - exact->t.get_d()) * length <= delta ||
                  ulpError(claim.t, exact->t) <= 16)) {
        return Verdict::Right;
    }
    if (distance(point, reference.corners(claim.triangle)) > delta) return Verdict::Gross;
    if (!truth.must) return Verdict::False;

    const double behind = (claim.t - truth.nearest[0].t.get_d()) * length;
    ExactCrossing crossing;
    const bool real =
        reference.crosses(claim.triangle, ray, crossing) && crossing.t > truth.nearest[0].t;
    if (std::abs(behind) <= delta) return real ? Verdict::Order : Verdict::WrongPrim;
    const bool sameFacing =
        std::any_of(truth.nearest.begin(), truth.nearest.end(), [&](const ExactCrossing& c) {
            return c.facing == facingInDouble(reference.corners(claim.triangle), ray);
        });
    if (behind > 0) return real || !sameFacing ? Verdict::Through : Verdict::Slide;
    return sameFacing ? Verdict::Early : Verdict::False;
}

void VerdictCounts::add(const ExactReference& reference, const Ray& ray, const Claim& claim) {
    add(reference, reference.nearest(ray), ray, claim);
}

void VerdictCounts::add(const ExactReference& reference, const ExactAnswer& truth, const Ray& ray,
                        const Claim& claim) {
    ++rays;
    ++of[std::size_t(judge(reference, truth, ray, claim))];
    if (claim.triangle == kNoHit) return;
    ++hits;
    const ExactCrossing* crossing = find(truth.nearest, claim.triangle);
    if (!crossing) crossing = find(truth.touches, claim.triangle);
    if (!crossing) return;
    worstT = std::max(worstT, ulpError(claim.t, crossing->t));
    const mpq_class u = abs(mpq_class(claim.u) - crossing->u);
    const mpq_class v = abs(mpq_class(claim.v) - crossing->v);
    worstUv = std::max({worstUv, u.get_d() * 0x1p24, v.get_d() * 0x1p24});
}

std::ostream& operator<<(std::ostream& out, const VerdictCounts& counts) {
    static const char* const names[] = {"right", "miss",  "through", "slide",    "early",
                                        "order", "false", "gross",   "wrongprim"};
    out << counts.rays << " rays, " << counts.hits << " hits:";
    for (std::size_t k = 0; k < std::size_t(Verdict::Count); ++k) {
        if (counts.of[k]) out << ' ' << counts.of[k] << ' ' << names[k];
    }
    return out << "; t off by " << counts.worstT << " ulp, u and v by " << counts.worstUv
               << " of 2^-24 at most";
}

} // namespace smart::test
