// SPDX-License-Identifier: MIT
// Scenes that change: instances that move, and a sheet that is deformed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tests/bench/workload.h"

namespace smart::bench {

/// What is where at one moment.
struct DynamicStep {
    /// Of instances: three columns and the translation.
    std::vector<std::array<float, 12>> matrices;
    /// Of the sheet: x, y, z of its points, row by row.
    std::vector<float> points;
};

/// How a sheet is deformed from step to step.
enum class SheetMotion {
    Waves,   ///< that run through it
    Twist,   ///< its middle turns, and parts from what was near
    Crumple, ///< folds that grow
};

/// What does not change, and how the rest does.
class DynamicScene {
public:
    /// Bumpy balls on a square, as many as asked for over the same pixels, which turn and bob.
    static DynamicScene balls(uint32_t instances);
    /// A sheet of about so many triangles.
    static DynamicScene sheet(uint32_t triangles, SheetMotion motion = SheetMotion::Waves);

    DynamicStep step(unsigned number) const;
    View view() const;
    bool isSheet() const { return columns_ > 0; }
    uint32_t instances() const { return instances_; }
    /// Of the model that is instantiated; of the sheet at step 0.
    const std::vector<Triangle>& triangles() const { return triangles_; }
    /// Cells of the sheet; each is two triangles, in the order of RT_QUAD_STRIP.
    uint32_t columns() const { return columns_; }
    uint32_t rows() const { return rows_; }
    /// Three point numbers for each triangle of the sheet.
    std::vector<uint32_t> indices() const;

private:
    uint32_t instances_ = 1, columns_ = 0, rows_ = 0;
    SheetMotion motion_ = SheetMotion::Waves;
    std::vector<Triangle> triangles_;
};

} // namespace smart::bench
