// SPDX-License-Identifier: MIT
#pragma once

#include <set>

#include "openrt/rtu.h"

namespace smart::compat {

/// The objects of rtu.h that a player made and the recorded program has not deleted: they belong to
/// no context, so that nothing else frees them. Used by one thread at a time.
class UtilityObjects {
public:
    UtilityObjects() = default;
    ~UtilityObjects() {
        for (RTUquadric* const quadric : quadrics_) rtuDeleteQuadric(quadric);
        for (RTUtesselator* const tessellator : tessellators_) rtuDeleteTess(tessellator);
    }
    UtilityObjects(const UtilityObjects&) = delete;
    UtilityObjects& operator=(const UtilityObjects&) = delete;

    void made(RTUquadric* quadric) { quadrics_.insert(quadric); }
    void made(RTUtesselator* tessellator) { tessellators_.insert(tessellator); }
    void deleted(RTUquadric* quadric) { quadrics_.erase(quadric); }
    void deleted(RTUtesselator* tessellator) { tessellators_.erase(tessellator); }

private:
    std::set<RTUquadric*> quadrics_;
    std::set<RTUtesselator*> tessellators_;
};

} // namespace smart::compat
