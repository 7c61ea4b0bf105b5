// SPDX-License-Identifier: MIT
#pragma once

#include "samples/common/view.h"

namespace samples {

/// A camera that circles around a point, driven by the mouse. Angles in radians, distances as
/// shares of the picture's height.
class OrbitCamera {
public:
    explicit OrbitCamera(const View& start);

    void orbit(float right, float up);
    /// Moves eye and target so that the target's depth follows the pointer.
    void pan(float right, float up);
    /// Above 1: nearer.
    void zoom(float factor);
    /// Circles from now on around the point at this distance in the middle of the picture.
    void focus(float distance);
    void reset() { view_ = start_; }
    const View& view() const { return view_; }

private:
    View start_, view_;
};

} // namespace samples
