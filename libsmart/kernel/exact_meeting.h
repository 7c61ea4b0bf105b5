// SPDX-License-Identifier: MIT
// Where a ray meets one triangle, decided by double with error bounds first and, where those do
// not suffice, by exact arithmetic. Compiled once, for every instruction set.
//
// The truth is meant in world space: vertices as given, multiplied by the matrices as given, all
// without rounding; the line of the ray likewise. A triangle is closed: a line through its edge or
// vertex meets it, a line in its plane does not.
#pragma once

#include "libsmart/kernel/exact_number.h"
#include "libsmart/kernel/packet.h"
#include "libsmart/kernel/view.h"

namespace smart {

/// A ray of the application, exactly: its direction times a power of two, its limits divided by
/// the same. Distances below are in units of this direction.
struct WorldRay {
    double org[3], dir[3];
    double tNear, tFar;
    double scale; ///< distance here * scale = distance in units of the direction as given
};

/// Names a triangle in a scene, or none: triangle = kNoHit.
struct TriangleName {
    uint32_t path[kMaxLevels];
    uint32_t levels;
    uint32_t triangle;
};

/// A ray in object space, in double; no component is off by more than the errors.
struct ObjectRay {
    double org[3], dir[3];
    double orgError, dirError;
};
/// Takes the ray to the space of the triangle named, which is returned.
const Triangle& enterModel(const ModelView& scene, const WorldRay& world, const TriangleName& name,
                           ObjectRay& ray);

enum class Side : uint32_t { Outside, Inside, Unsure };

/// A number that lies in [value - error, value + error]; error is never NaN.
struct Estimate {
    double value, error;
};

struct DoubleMeeting {
    Side side;
    Estimate t, u, v; ///< infinite errors unless inside
};
void meetInDouble(const ModelView& scene, const WorldRay& ray, const TriangleName& name,
                  DoubleMeeting& result);

/// t = depth / size, u = second / size, v = third / size.
struct ExactMeeting {
    ExactNumber depth, second, third, size; ///< size > 0 where inside
    bool inside;
};
void meetExactly(const ModelView& scene, const WorldRay& ray, const TriangleName& name,
                 ExactMeeting& result);

/// Sign of numerator / denominator - x, for a denominator above 0 and a finite x.
int compareQuotient(const ExactNumber& numerator, const ExactNumber& denominator, double x);
/// Sign of the difference of two distances.
int compareDistances(const ExactMeeting& a, const ExactMeeting& b);
/// numerator / denominator * scale, a power of two, as the nearest float, the even one of two.
float roundedQuotient(const ExactNumber& numerator, const ExactNumber& denominator, double scale);

} // namespace smart
