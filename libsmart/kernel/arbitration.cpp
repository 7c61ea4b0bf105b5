// SPDX-License-Identifier: MIT
#include "libsmart/kernel/arbitration.h"

#include <cmath>
#include <limits>

namespace smart {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

float roundedDown(double x) {
    const float nearest = float(x);
    return nearest > x ? std::nextafterf(nearest, -kInfinity) : nearest;
}
float roundedUp(double x) {
    return -roundedDown(-x);
}

/// A meeting known as well as it had to be so far.
class Meeting {
public:
    Meeting(const ModelView& scene, const WorldRay& ray, const TriangleName& name)
        : scene_(scene), ray_(ray), name_(name) {
        meetInDouble(scene, ray, name, inDouble_);
        setInterval(inDouble_.t);
    }

    bool inside() {
        if (inDouble_.side == Side::Unsure) return exact().inside;
        return inDouble_.side == Side::Inside;
    }
    /// The interval that the distance is known to lie in, of a meeting that is inside.
    double low() const { return low_; }
    double high() const { return high_; }

    /// Sign of the distance minus a finite limit.
    int compare(double limit) {
        if (low_ > limit) return 1;
        if (high_ < limit) return -1;
        return compareQuotient(exact().depth, exact().size, limit);
    }
    int compare(Meeting& other) {
        if (low_ > other.high_) return 1;
        if (high_ < other.low_) return -1;
        return compareDistances(exact(), other.exact());
    }
    /// Narrows an interval that double left open.
    void makeFinite() {
        if (low_ > -kInfinity && high_ < kInfinity) return;
        const float nearest = roundedQuotient(exact().depth, exact().size, 1);
        low_ = std::nextafterf(nearest, -kInfinity);
        high_ = std::nextafterf(nearest, kInfinity);
    }
    bool wasExact() const { return isExact_; }

private:
    void setInterval(const Estimate& t) {
        low_ = t.value - t.error; // the error includes these roundings
        high_ = t.value + t.error;
    }
    const ExactMeeting& exact() {
        if (!isExact_) meetExactly(scene_, ray_, name_, exact_);
        isExact_ = true;
        return exact_;
    }

    const ModelView& scene_;
    const WorldRay& ray_;
    const TriangleName& name_;
    DoubleMeeting inDouble_;
    double low_ = -kInfinity, high_ = kInfinity;
    ExactMeeting exact_;
    bool isExact_ = false;
};

Order orderOf(Meeting& meeting, const ModelView& scene, const WorldRay& ray,
              const TriangleName& best, float bestLow, float bestHigh, bool& exact) {
    if (!meeting.inside() || meeting.compare(ray.tNear) < 0) return Order::Nothing;
    if (best.triangle == kNoHit) {
        const bool reached = ray.tFar == kInfinity || meeting.compare(ray.tFar) <= 0;
        return reached ? Order::Nearer : Order::Nothing;
    }
    if (meeting.high() < bestLow) return Order::Nearer;
    if (meeting.low() > bestHigh) return Order::Nothing;
    Meeting other(scene, ray, best);
    const int order = meeting.compare(other);
    exact = other.wasExact();
    return order > 0 ? Order::Nothing : order < 0 ? Order::Nearer : Order::Equal;
}

} // namespace

void arbitrate(const ModelView& scene, const WorldRay& ray, const TriangleName& candidate,
               const TriangleName& best, float bestLow, float bestHigh, Ruling& ruling) {
    Meeting meeting(scene, ray, candidate);
    bool exact = false;
    ruling.order = orderOf(meeting, scene, ray, best, bestLow, bestHigh, exact);
    if (ruling.order != Order::Nothing) {
        meeting.makeFinite();
        ruling.low = roundedDown(meeting.low());
        ruling.high = roundedUp(meeting.high());
    }
    ruling.exact = exact || meeting.wasExact();
}

uint32_t placeHit(const ModelView& scene, const WorldRay& ray, const TriangleName& name, float& t,
                  float& u, float& v) {
    DoubleMeeting meeting;
    meetInDouble(scene, ray, name, meeting);
    const auto settled = [](const Estimate& x, double scale, float& result) {
        const float low = float((x.value - x.error) * scale);
        result = float((x.value + x.error) * scale);
        return low == result && low != 0;
    };
    const bool sure = settled(meeting.t, ray.scale, t) && settled(meeting.u, 1, u) &&
                      settled(meeting.v, 1, v);
    if (sure) return 0;
    ExactMeeting exact;
    meetExactly(scene, ray, name, exact);
    t = roundedQuotient(exact.depth, exact.size, ray.scale);
    u = roundedQuotient(exact.second, exact.size, 1);
    v = roundedQuotient(exact.third, exact.size, 1);
    return 1;
}

} // namespace smart
