// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace openrt::test {

/// A part of the interface in use: everything that a frame needs, its geometry and the call that
/// renders it, into the frame buffer set. Makes its things anew every time, keeps no ids.
struct Scene {
    const char* name;
    void (*describeAndRender)();
};

const std::vector<Scene>& scenes();

/// Ends whatever a program that was left in the middle has open, and sets the state that scenes
/// start from; errors are not looked at.
void backToStart();

} // namespace openrt::test
