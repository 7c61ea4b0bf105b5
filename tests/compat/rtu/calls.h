// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

namespace testing_rtu {

/// A call that draws, of OpenGL or of OpenRT; modes are OpenGL's.
struct Call {
    enum Kind { Begin, End, Vertex, Normal, TexCoord } kind;
    float values[3];
};

/// A level of a texture, as glTexImage and rtTexImage got it.
struct Level {
    int level, width, height;
    std::vector<unsigned char> bytes;
};

// This program defines the functions of OpenGL and of OpenRT that GLU and rtu draw with, so that
// the libraries call these instead; what they were called with is kept here.
extern std::vector<Call> glCalls, rtCalls;
extern std::vector<Level> glLevels, rtLevels;
extern double glMatrix[16]; ///< what OpenGL's calls of matrices make, column-major

/// Is called with every level of rtTexImage2D.
extern std::function<void()> whenLevelComes;

/// Bytes of a pixel of the texture calls to come.
extern int bytesPerPixel;

} // namespace testing_rtu
