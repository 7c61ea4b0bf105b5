// SPDX-License-Identifier: MIT
#include "tests/support/exact_reference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace smart::test {
namespace {

bool finite(const float* values, int count) {
    return std::all_of(values, values + count, [](float x) { return std::isfinite(x); });
}

/// Bits behind the binary point that a value needs.
int fractionBits(double value) {
    if (value == 0) return 0;
    int exponent = 0;
    const auto mantissa = int64_t(std::ldexp(std::frexp(value, &exponent), 53));
    return std::max(0, 53 - exponent - __builtin_ctzll(uint64_t(mantissa)));
}

int fractionBits(const mpq_class& dyadic) {
    return int(mpz_sizeinbase(dyadic.get_den_mpz_t(), 2)) - 1;
}

void scaled(double value, int shift, mpz_class& result) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    result = std::ldexp(fraction, 53);
    const int places = exponent - 53 + shift;
    if (places >= 0) {
        mpz_mul_2exp(result.get_mpz_t(), result.get_mpz_t(), mp_bitcnt_t(places));
    } else {
        mpz_tdiv_q_2exp(result.get_mpz_t(), result.get_mpz_t(), mp_bitcnt_t(-places));
    }
}

void scaled(const mpq_class& dyadic, int shift, mpz_class& result) {
    mpz_mul_2exp(result.get_mpz_t(), dyadic.get_num_mpz_t(),
                 mp_bitcnt_t(shift - fractionBits(dyadic)));
}

void cross(const mpz_class* a, const mpz_class* b, mpz_class* result) {
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        result[k] = a[i] * b[j];
        mpz_submul(result[k].get_mpz_t(), a[j].get_mpz_t(), b[i].get_mpz_t());
    }
}

void dot(const mpz_class* a, const mpz_class* b, mpz_class& result) {
    result = a[0] * b[0];
    mpz_addmul(result.get_mpz_t(), a[1].get_mpz_t(), b[1].get_mpz_t());
    mpz_addmul(result.get_mpz_t(), a[2].get_mpz_t(), b[2].get_mpz_t());
}

} // namespace

uint32_t ExactReference::add(std::span<const Triangle> triangles) {
    return append(triangles, {});
}

uint32_t ExactReference::add(std::span<const Triangle> triangles,
                             std::span<const Matrix34> toWorld) {
    return append(triangles, toWorld);
}

uint32_t ExactReference::append(std::span<const Triangle> triangles,
                                std::span<const Matrix34> toWorld) {
    const uint32_t first = count();
    if (first == 0) {
        std::fill(lo_, lo_ + 3, std::numeric_limits<double>::infinity());
        std::fill(hi_, hi_ + 3, -std::numeric_limits<double>::infinity());
    }
    const bool placed = std::all_of(toWorld.begin(), toWorld.end(), [](const Matrix34& matrix) {
        return std::all_of(matrix.begin(), matrix.end(), [](double x) { return std::isfinite(x); });
    });
    topology_.startMesh();
    for (const Triangle& triangle : triangles) {
        const uint32_t index = count();
        const float* const source[3] = {triangle.v0, triangle.v1, triangle.v2};
        std::array<double, 9> corners{};
        const bool valid =
            placed && finite(triangle.v0, 3) && finite(triangle.v1, 3) && finite(triangle.v2, 3);
        for (int c = 0; c < 3 && valid; ++c) {
            for (int k = 0; k < 3; ++k) corners[3 * c + k] = source[c][k];
        }
        if (valid && !toWorld.empty()) {
            std::array<mpq_class, 9>& exact = exact_[index];
            for (int k = 0; k < 9; ++k) exact[k] = corners[k];
            for (std::size_t m = toWorld.size(); m-- > 0;) {
                for (int c = 0; c < 3; ++c) {
                    const std::array<mpq_class, 3> p = {exact[3 * c], exact[3 * c + 1],
                                                        exact[3 * c + 2]};
                    for (int row = 0; row < 3; ++row) {
                        const double* r = &toWorld[m][4 * row];
                        exact[3 * c + row] = mpq_class(r[0]) * p[0] + mpq_class(r[1]) * p[1] +
                                             mpq_class(r[2]) * p[2] + mpq_class(r[3]);
                    }
                }
            }
            for (int k = 0; k < 9; ++k) {
                corners[k] = exact[k].get_d();
                shift_ = std::max(shift_, fractionBits(exact[k]));
            }
        }
        double centre[3], radius = 0;
        for (int k = 0; k < 3; ++k) {
            centre[k] = (corners[k] + corners[3 + k] + corners[6 + k]) / 3;
        }
        for (int c = 0; c < 3 && valid; ++c) {
            double square = 0;
            for (int k = 0; k < 3; ++k) {
                const double x = corners[3 * c + k];
                shift_ = std::max(shift_, fractionBits(x));
                maxAbs_ = std::max(maxAbs_, std::abs(x));
                lo_[k] = std::min(lo_[k], x);
                hi_[k] = std::max(hi_[k], x);
                square += (x - centre[k]) * (x - centre[k]);
            }
            radius = std::max(radius, std::sqrt(square) * (1 + 1e-12));
        }
        corners_.push_back(corners);
        for (int k = 0; k < 3; ++k) centre_[k].push_back(centre[k]);
        degenerate_.push_back(uint8_t(!valid || isDegenerate(index)));
        radius_.push_back(degenerate_.back() ? -std::numeric_limits<double>::infinity() : radius);
        topology_.add(triangle, !degenerate_.back());
    }
    return first;
}

double ExactReference::extent() const {
    double side = 0;
    for (int k = 0; k < 3; ++k) side = std::max(side, hi_[k] - lo_[k]);
    return side;
}

bool ExactReference::exactInDouble(uint32_t triangle) const {
    const auto exact = exact_.find(triangle);
    if (exact == exact_.end()) return true;
    for (std::size_t k = 0; k < 9; ++k) {
        if (exact->second[k] != mpq_class(corners_[triangle][k])) return false;
    }
    return true;
}

void ExactReference::exactCorners(uint32_t triangle, int shift, mpz_class corners[9]) const {
    const auto exact = exact_.find(triangle);
    for (int k = 0; k < 9; ++k) {
        if (exact == exact_.end()) {
            scaled(corners_[triangle][k], shift, corners[k]);
        } else {
            scaled(exact->second[k], shift, corners[k]);
        }
    }
}

bool ExactReference::isDegenerate(uint32_t triangle) const {
    mpz_class p[9], normal[3];
    exactCorners(triangle, shift_, p);
    for (int k = 0; k < 3; ++k) {
        p[3 + k] -= p[k];
        p[6 + k] -= p[k];
    }
    cross(p + 3, p + 6, normal);
    return normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
}

void ExactReference::determinants(uint32_t triangle, const Ray& ray, Determinants& result) const {
    int shift = shift_;
    for (int k = 0; k < 3; ++k) {
        shift = std::max({shift, fractionBits(ray.org[k]), fractionBits(ray.dir[k])});
    }
    mpz_class p[9], dir[3], org, normal[3];
    exactCorners(triangle, shift, p);
    for (int k = 0; k < 3; ++k) {
        scaled(ray.org[k], shift, org);
        scaled(ray.dir[k], shift, dir[k]);
        for (int c = 0; c < 3; ++c) p[3 * c + k] -= org;
    }
    cross(p + 3, p + 6, normal);
    dot(dir, normal, result.w[0]);
    dot(p, normal, result.volume);
    cross(p + 6, p, normal);
    dot(dir, normal, result.w[1]);
    cross(p, p + 3, normal);
    dot(dir, normal, result.w[2]);
    result.sum = result.w[0] + result.w[1] + result.w[2];
}

bool ExactReference::crosses(uint32_t triangle, const Ray& ray, ExactCrossing& crossing) const {
    if (degenerate(triangle)) return false;
    Determinants d;
    determinants(triangle, ray, d);
    crossing.facing = sgn(d.sum);
    if (crossing.facing == 0) return false;
    crossing.triangle = triangle;
    crossing.zeros = 0;
    for (int k = 0; k < 3; ++k) {
        const int side = sgn(d.w[k]);
        if (side == -crossing.facing) return false;
        if (side == 0) crossing.zeros |= 1u << k;
    }
    crossing.t = mpq_class(d.volume, d.sum);
    crossing.u = mpq_class(d.w[1], d.sum);
    crossing.v = mpq_class(d.w[2], d.sum);
    crossing.t.canonicalize();
    crossing.u.canonicalize();
    crossing.v.canonicalize();
    return true;
}

// Each weight w is a sum of six products of three factors; a factor v - o carries one rounding,
// and a second one where v itself is rounded. 16 units of 2^-53 of the sum of absolute products
// bound the error with room to spare.
bool ExactReference::certainlyMissed(uint32_t triangle, const Ray& ray) const {
    const std::array<double, 9>& v = corners_[triangle];
    const bool rounded = !exact_.empty();
    double p[9], m[9];
    for (int k = 0; k < 9; ++k) {
        p[k] = v[k] - ray.org[k % 3];
        m[k] = std::abs(p[k]) + (rounded ? std::abs(v[k]) : 0.0);
    }
    bool positive = false, negative = false;
    for (int c = 0; c < 3; ++c) {
        const int b = 3 * ((c + 1) % 3), e = 3 * ((c + 2) % 3);
        double w = 0, size = 0;
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            w += ray.dir[k] * (p[b + i] * p[e + j] - p[b + j] * p[e + i]);
            size += std::abs(ray.dir[k]) * (m[b + i] * m[e + j] + m[b + j] * m[e + i]);
        }
        const double bound = std::ldexp(size, -49);
        positive = positive || w > bound;
        negative = negative || w < -bound;
    }
    return positive && negative;
}

ExactAnswer ExactReference::nearest(const Ray& ray) const {
    ExactAnswer answer;
    if (!finite(ray.org, 3) || !finite(ray.dir, 3)) return answer;
    if (ray.dir[0] == 0 && ray.dir[1] == 0 && ray.dir[2] == 0) return answer;
    const float tNear = std::max(ray.tNear, 0.0f);
    if (std::isnan(ray.tNear) || std::isnan(ray.tFar) || !(tNear <= ray.tFar)) return answer;

    const double d[3] = {ray.dir[0], ray.dir[1], ray.dir[2]};
    const double square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    double slack = maxAbs_;
    for (float x : ray.org) slack = std::max(slack, double(std::abs(x)));
    slack *= 1e-12;
    std::vector<ExactCrossing> crossings;
    for (uint32_t i = 0; i < count(); ++i) {
        const double e[3] = {centre_[0][i] - ray.org[0], centre_[1][i] - ray.org[1],
                             centre_[2][i] - ray.org[2]};
        const double c[3] = {e[1] * d[2] - e[2] * d[1], e[2] * d[0] - e[0] * d[2],
                             e[0] * d[1] - e[1] * d[0]};
        const double reach = radius_[i] + slack;
        if (!(c[0] * c[0] + c[1] * c[1] + c[2] * c[2] <= reach * reach * square)) continue;
        if (degenerate(i) || certainlyMissed(i, ray)) continue;
        ExactCrossing crossing;
        if (!crosses(i, ray, crossing)) continue;
        const bool before = crossing.t < mpq_class(tNear);
        const bool behind = std::isfinite(ray.tFar) && crossing.t > mpq_class(ray.tFar);
        if (!before && !behind) crossings.push_back(std::move(crossing));
    }
    std::sort(crossings.begin(), crossings.end(), [](auto& a, auto& b) { return a.t < b.t; });
    for (std::size_t first = 0, last; first < crossings.size() && !answer.must; first = last) {
        last = first + 1;
        while (last < crossings.size() && crossings[last].t == crossings[first].t) ++last;
        const std::span<const ExactCrossing> layer(&crossings[first], last - first);
        const mpq_class& t = crossings[first].t;
        const bool atLimit =
            t == mpq_class(tNear) || (std::isfinite(ray.tFar) && t == mpq_class(ray.tFar));
        answer.must =
            !atLimit && topology_.isMust(std::vector<Touch>(layer.begin(), layer.end()));
        auto& kind = answer.must ? answer.nearest : answer.touches;
        kind.insert(kind.end(), layer.begin(), layer.end());
    }
    return answer;
}

double ulpError(float value, const mpq_class& exact) {
    int exponent = 0;
    std::frexp(std::abs(exact.get_d()), &exponent);
    const int place = std::max(exponent - 24, -149);
    const mpq_class error = abs(mpq_class(value) - exact);
    return std::ldexp(error.get_d(), -place);
}

bool crossesMollerTrumbore(const Triangle& triangle, const Ray& ray, ExactCrossing& crossing) {
    using Vector = std::array<mpq_class, 3>;
    Vector edge1, edge2, offset, dir;
    for (int k = 0; k < 3; ++k) {
        edge1[k] = mpq_class(triangle.v1[k]) - mpq_class(triangle.v0[k]);
        edge2[k] = mpq_class(triangle.v2[k]) - mpq_class(triangle.v0[k]);
        offset[k] = mpq_class(ray.org[k]) - mpq_class(triangle.v0[k]);
        dir[k] = ray.dir[k];
    }
    const auto product = [](const Vector& a, const Vector& b) {
        return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                      a[0] * b[1] - a[1] * b[0]};
    };
    const auto inner = [](const Vector& a, const Vector& b) -> mpq_class {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    const Vector p = product(dir, edge2);
    const mpq_class determinant = inner(edge1, p);
    if (determinant == 0) return false;
    const mpq_class u = inner(offset, p) / determinant;
    const Vector q = product(offset, edge1);
    const mpq_class v = inner(dir, q) / determinant;
    const mpq_class rest = 1 - u - v;
    if (u < 0 || v < 0 || rest < 0) return false;
    crossing.t = inner(edge2, q) / determinant;
    crossing.u = u;
    crossing.v = v;
    crossing.zeros = (rest == 0 ? 1u : 0u) | (u == 0 ? 2u : 0u) | (v == 0 ? 4u : 0u);
    crossing.facing = -sgn(determinant); // determinant = -direction . (edge1 x edge2)
    return true;
}

} // namespace smart::test
