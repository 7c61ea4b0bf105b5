// SPDX-License-Identifier: MIT
// The vertices of quadrics, in the order in which the sample implementation of GLU gives them.
#include <algorithm>
#include <cmath>
#include <vector>

#include "compat/recorder/transforms.h"
#include "compat/rtu/quadric.h"
#include "openrt/rt.h"

namespace smart::compat {

namespace {

/// Sine and cosine of angles in equal steps.
class Circle {
public:
    /// steps + 1 directions, from start over sweep (degrees); a full circle closes exactly.
    Circle(int steps, double start, double sweep) {
        directions_.reserve(std::size_t(steps) + 1);
        for (int i = 0; i <= steps; ++i)
            directions_.push_back(sinCosDegrees(start + sweep * i / steps));
        if (sweep == 360) directions_.back() = directions_.front();
    }
    double sin(int i) const { return directions_[std::size_t(i)].sin; }
    double cos(int i) const { return directions_[std::size_t(i)].cos; }

private:
    std::vector<SinCos> directions_;
};

/// Gives normals and texture coordinates only where the quadric asks for them.
class Pen {
public:
    explicit Pen(const RTUquadric& quad)
        : normals_(quad.normals != RTU_NONE), texture_(quad.texture) {}

    void normal(double x, double y, double z) const {
        if (normals_) rtNormal3f(float(x), float(y), float(z));
    }
    void vertex(double s, double t, double x, double y, double z) const {
        if (texture_) rtTexCoord2f(float(s), float(t));
        rtVertex3f(float(x), float(y), float(z));
    }

private:
    bool normals_, texture_;
};

class Sphere {
public:
    Sphere(const RTUquadric& quad, double radius, int slices, int stacks)
        : quad_(quad), pen_(quad), radius_(radius), slices_(slices), stacks_(stacks),
          flat_(quad.normals == RTU_FLAT), sign_(quad.inside ? -1 : 1), around_(slices, 0, 360),
          aroundFlat_(slices, -180.0 / slices, 360), down_(stacks, 0, 180),
          downFlat_(stacks, -90.0 / stacks, 180) {}

    void fill() const {
        if (!quad_.texture) {
            cap(true);
            cap(false);
        }
        // Textured poles are quads: each has texture coordinates of its own.
        const int first = quad_.texture ? 0 : 1;
        for (int j = first; j < stacks_ - first; ++j) {
            rtBegin(RT_QUAD_STRIP);
            const int leading = quad_.inside ? j : j + 1, trailing = quad_.inside ? j + 1 : j;
            for (int i = 0; i <= slices_; ++i) {
                if (!flat_) smoothNormal(i, leading);
                vertex(i, leading);
                if (flat_)
                    flatNormal(i, j + 1);
                else
                    smoothNormal(i, trailing);
                vertex(i, trailing);
            }
            rtEnd();
        }
    }
    void lines() const {
        for (int j = 1; j < stacks_; ++j) {
            rtBegin(RT_LINE_STRIP);
            for (int i = 0; i <= slices_; ++i) {
                lineNormal(flat_ ? aroundFlat_ : around_, i, down_, j);
                vertex(i, j);
            }
            rtEnd();
        }
        for (int i = 0; i < slices_; ++i) {
            rtBegin(RT_LINE_STRIP);
            for (int j = 0; j <= stacks_; ++j) {
                lineNormal(around_, i, flat_ ? downFlat_ : down_, j);
                vertex(i, j);
            }
            rtEnd();
        }
    }
    void points() const {
        rtBegin(RT_POINTS);
        for (int j = 0; j <= stacks_; ++j)
            for (int i = 0; i < slices_; ++i) {
                smoothNormal(i, j);
                vertex(i, j);
            }
        rtEnd();
    }

private:
    void lineNormal(const Circle& around, int i, const Circle& down, int j) const {
        pen_.normal(sign_ * around.sin(i) * down.sin(j), sign_ * around.cos(i) * down.sin(j),
                    sign_ * down.cos(j));
    }
    void smoothNormal(int i, int j) const { lineNormal(around_, i, down_, j); }
    void flatNormal(int i, int j) const { lineNormal(aroundFlat_, i, downFlat_, j); }
    void vertex(int i, int j) const {
        const double ring = j == 0 || j == stacks_ ? 0 : radius_ * down_.sin(j);
        pen_.vertex(1 - double(i) / slices_, 1 - double(j) / stacks_, ring * around_.sin(i),
                    ring * around_.cos(i), radius_ * down_.cos(j));
    }
    /// The fan about a pole. It turns so that its outside is in front; a face takes its flat
    /// normal from the later of its two vertices on the ring.
    void cap(bool north) const {
        const int ring = north ? 1 : stacks_ - 1, pole = north ? 0 : stacks_;
        const bool backwards = north != quad_.inside;
        if (!flat_) smoothNormal(0, pole);
        rtBegin(RT_TRIANGLE_FAN);
        rtVertex3f(0, 0, float(north ? radius_ : -radius_));
        for (int step = 0; step <= slices_; ++step) {
            const int i = backwards ? slices_ - step : step;
            if (!flat_)
                smoothNormal(i, ring);
            else if (!backwards)
                flatNormal(i, north ? 1 : stacks_);
            else if (i != slices_)
                flatNormal(i + 1, north ? 1 : stacks_);
            vertex(i, ring);
        }
        rtEnd();
    }

    const RTUquadric& quad_;
    Pen pen_;
    double radius_;
    int slices_, stacks_;
    bool flat_;
    double sign_;
    Circle around_, aroundFlat_, down_, downFlat_;
};

class Cylinder {
public:
    Cylinder(const RTUquadric& quad, double base, double top, double height, int slices,
             int stacks)
        : quad_(quad), pen_(quad), base_(base), top_(top), height_(height), slices_(slices),
          stacks_(stacks), flat_(quad.normals == RTU_FLAT), around_(slices, 0, 360),
          aroundFlat_(slices, -180.0 / slices, 360) {
        const double length = std::hypot(base - top, height);
        // GLU turns the normals of RTU_INSIDE in x and y only.
        normalXY_ = (quad.inside ? -1 : 1) * height / length;
        normalZ_ = (base - top) / length;
    }

    void fill() const {
        for (int j = 0; j < stacks_; ++j) {
            rtBegin(RT_QUAD_STRIP);
            for (int i = 0; i <= slices_; ++i) {
                normal(flat_, i, normalZ_);
                vertex(i, quad_.inside ? j + 1 : j);
                vertex(i, quad_.inside ? j : j + 1);
            }
            rtEnd();
        }
    }
    void lines(bool inner) const {
        if (inner)
            for (int j = 1; j < stacks_; ++j) ring(j);
        ring(0);
        ring(stacks_);
        for (int i = 0; i < slices_; ++i) {
            normal(false, i, 0);
            rtBegin(RT_LINE_STRIP);
            for (int j = 0; j <= stacks_; ++j) vertex(i, j);
            rtEnd();
        }
    }
    void points() const {
        rtBegin(RT_POINTS);
        for (int i = 0; i < slices_; ++i) {
            normal(false, i, normalZ_);
            for (int j = 0; j <= stacks_; ++j) vertex(i, j);
        }
        rtEnd();
    }

private:
    void ring(int j) const {
        rtBegin(RT_LINE_STRIP);
        for (int i = 0; i <= slices_; ++i) {
            normal(flat_, i, normalZ_);
            vertex(i, j);
        }
        rtEnd();
    }
    void normal(bool flat, int i, double z) const {
        const Circle& circle = flat ? aroundFlat_ : around_;
        pen_.normal(circle.sin(i) * normalXY_, circle.cos(i) * normalXY_, z);
    }
    void vertex(int i, int j) const {
        const double up = double(j) / stacks_, radius = base_ - (base_ - top_) * up;
        pen_.vertex(1 - double(i) / slices_, up, radius * around_.sin(i), radius * around_.cos(i),
                    height_ * up);
    }

    const RTUquadric& quad_;
    Pen pen_;
    double base_, top_, height_;
    int slices_, stacks_;
    bool flat_;
    Circle around_, aroundFlat_;
    double normalXY_, normalZ_;
};

class Disk {
public:
    Disk(const RTUquadric& quad, double inner, double outer, int slices, int loops, double start,
         double sweep)
        : quad_(quad), pen_(quad), inner_(inner), outer_(outer), slices_(slices), loops_(loops),
          whole_(sweep == 360), around_(slices, start, sweep) {}

    void fill() const {
        const bool pointed = inner_ == 0;
        if (pointed) {
            rtBegin(RT_TRIANGLE_FAN);
            pen_.vertex(0.5, 0.5, 0, 0, 0);
            for (int step = 0; step <= slices_; ++step)
                vertex(quad_.inside ? step : slices_ - step, loops_ - 1);
            rtEnd();
        }
        for (int j = 0; j < loops_ - pointed; ++j) {
            rtBegin(RT_QUAD_STRIP);
            for (int i = 0; i <= slices_; ++i) {
                vertex(i, quad_.inside ? j + 1 : j);
                vertex(i, quad_.inside ? j : j + 1);
            }
            rtEnd();
        }
    }
    void lines() const {
        if (inner_ == outer_) return arc(0);
        for (int j = 0; j <= loops_; ++j) arc(j);
        for (int i = 0; i < radii(); ++i) spoke(i);
    }
    void silhouette() const {
        if (!whole_) {
            spoke(0);
            spoke(slices_);
        }
        arc(0);
        if (inner_ != outer_) arc(loops_);
    }
    void points() const {
        rtBegin(RT_POINTS);
        for (int i = 0; i < radii(); ++i)
            for (int j = 0; j <= loops_; ++j) vertex(i, j);
        rtEnd();
    }

private:
    int radii() const { return whole_ ? slices_ : slices_ + 1; }
    void arc(int j) const {
        rtBegin(RT_LINE_STRIP);
        for (int i = 0; i <= slices_; ++i) vertex(i, j);
        rtEnd();
    }
    void spoke(int i) const {
        rtBegin(RT_LINE_STRIP);
        for (int j = 0; j <= loops_; ++j) vertex(i, j);
        rtEnd();
    }
    void vertex(int i, int j) const {
        const double radius = outer_ - (outer_ - inner_) * (double(j) / loops_);
        const double scale = radius / outer_ / 2;
        pen_.vertex(scale * around_.sin(i) + 0.5, scale * around_.cos(i) + 0.5,
                    radius * around_.sin(i), radius * around_.cos(i), 0);
    }

    const RTUquadric& quad_;
    Pen pen_;
    double inner_, outer_;
    int slices_, loops_;
    bool whole_;
    Circle around_;
};

} // namespace

void drawSphere(const RTUquadric& quad, double radius, int slices, int stacks) {
    const Sphere sphere(quad, radius, std::min(slices, kMaxSlices),
                        std::min(stacks, kMaxSlices));
    switch (quad.style) {
    case RTU_FILL: return sphere.fill();
    case RTU_POINT: return sphere.points();
    default: return sphere.lines();
    }
}

void drawCylinder(const RTUquadric& quad, double base, double top, double height, int slices,
                  int stacks) {
    const Cylinder cylinder(quad, base, top, height, std::min(slices, kMaxSlices), stacks);
    switch (quad.style) {
    case RTU_FILL: return cylinder.fill();
    case RTU_POINT: return cylinder.points();
    default: return cylinder.lines(quad.style == RTU_LINE);
    }
}

void drawPartialDisk(const RTUquadric& quad, double inner, double outer, int slices, int loops,
                     double start, double sweep) {
    if (sweep < -360 || sweep > 360) sweep = 360;
    if (sweep < 0) {
        start += sweep;
        sweep = -sweep;
    }
    const Disk disk(quad, inner, outer, std::min(slices, kMaxSlices), loops, start, sweep);
    if (quad.normals != RTU_NONE) rtNormal3f(0, 0, quad.inside ? -1.0f : 1.0f);
    switch (quad.style) {
    case RTU_FILL: return disk.fill();
    case RTU_POINT: return disk.points();
    case RTU_LINE: return disk.lines();
    default: return disk.silhouette();
    }
}

} // namespace smart::compat
