// SPDX-License-Identifier: MIT
#pragma once

#include "openrt/types.h"
#include "tests/bench/dynamic_scene.h"

namespace smart::bench {

/// An application that renders moving instances: its context, current while it lives.
class BallFrames {
public:
    /// lit: by one light with shadows; else in flat colours.
    BallFrames(const DynamicScene& scene, unsigned threads, bool lit);
    ~BallFrames();
    BallFrames(const BallFrames&) = delete;
    BallFrames& operator=(const BallFrames&) = delete;

    /// The instances of a frame.
    void describe(const DynamicStep& step) const;
    /// Throws std::runtime_error where a call was refused.
    void check() const;

private:
    RTcontext context_;
    RTuint object_ = 0;
};

} // namespace smart::bench
