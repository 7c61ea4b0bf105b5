// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/conformance/picture.h"

namespace conformance {

struct Frame {
    Picture color;
    DepthPicture depth;
};

// What OpenGL allows for one frame, as far as OSMesa shows it: the picture, and others that OSMesa
// gives when moved by a small part of a pixel (OpenGL asks for a sixteenth at most) or when it
// splits quads along the other diagonal and rounds nothing to 8 bits in between.
struct Reference {
    Frame frame;
    std::vector<Frame> others;
    std::array<std::uint8_t, 3> clear{}; // colour of pixels without an object
};

// How equal a port's pictures are meant to be.
enum class Kind {
    kEqual,    // colour and depth as OpenGL's
    kGeometry, // coverage and depth as OpenGL's, the colour has more light paths
};

// Errors are distances to the range that the reference's frames span at a pixel. A silhouette is a
// pixel around which (3x3) OSMesa's object mask is mixed; the inside is every other pixel with an
// object.
struct Measures {
    double silhouettes = 0;      // share of the picture
    double open = 0;             // share of pixels where the reference's frames differ visibly
    long coverageInside = 0;     // wrong pixels away from silhouettes
    long coverageSilhouette = 0; // wrong pixels at silhouettes
    long silhouettePixels = 0;
    double depthMax = 0;            // inside, of the depth range
    double colorMean = 0;           // inside, in 1/255, mean of the largest channel
    double color999 = 0;            // the same, 99.9 percentile
    double silhouetteColorMean = 0; // at silhouettes and the empty pixels
    double flip = 0;                // of the whole picture against the reference's own frame
};

// flip takes time: left out (0) unless withFlip.
Measures compare(const Reference& reference, const Frame& test, bool withFlip);

// Empty if the measures pass, else what does not.
std::vector<std::string> failuresOf(const Measures& measures, Kind kind, int width, int height);

// The difference to the reference's own frame, eight times, at most white.
Picture differencePicture(const Picture& reference, const Picture& test);

} // namespace conformance
