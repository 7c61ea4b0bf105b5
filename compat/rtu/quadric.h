// SPDX-License-Identifier: MIT
#pragma once

#include "openrt/rtu.h"

/// How the shapes of rtuSphere and its like are drawn. Owned by the application.
struct RTUquadric {
    RTenum style = RTU_FILL;
    RTenum normals = RTU_SMOOTH;
    bool inside = false;
    bool texture = false;
    void(RTAPIENTRY* error)(RTenum) = nullptr;
};

namespace smart::compat {

/// GLU draws at most so many slices, whatever was asked for; its pictures have them.
inline constexpr int kMaxSlices = 239;
/// More stacks or loops than this are refused.
inline constexpr int kMaxStacks = 65536;

// Each takes valid arguments, checked by its caller.
void drawSphere(const RTUquadric& quad, double radius, int slices, int stacks);
void drawCylinder(const RTUquadric& quad, double base, double top, double height, int slices,
                  int stacks);
void drawPartialDisk(const RTUquadric& quad, double inner, double outer, int slices, int loops,
                     double start, double sweep);

} // namespace smart::compat
