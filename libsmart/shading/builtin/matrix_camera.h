// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <utility>

#include "openrt/shader.hpp"

namespace smart::builtin {

using namespace openrt;

/// OpenGL's camera: a ray leads through the points that projection * modelView maps to
/// (2 x - 1, 2 y - 1, z, 1), from the near plane z = -1 to the far plane z = 1; a far plane at
/// infinity or beyond does not end it. Rays that meet in an eye start there; parallel ones, and those
/// of a near plane beyond the far one, which lead to the eye, on the near plane. A product without inverse gives no rays: the pixels are black and counted as bad.
struct Matrix {
    Mat4 projection;
    Mat4 modelView;

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Mat4>("projection", PER_SHADER, offsetof(Matrix, projection));
        r.registerParam<Mat4>("modelView", PER_SHADER, offsetof(Matrix, modelView));
    }
    template <class Context>
    void initPrimaryRay(float x, float y, Context& c) const {
        Solver solver(projection, modelView);
        if (!solver.regular) {
            c.setRay(Vec3(), Vec3());
            return;
        }
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        // The columns of the inverse say where the clip coordinates' axes lead.
        const double (&inverse)[4][4] = solver.columns;
        const double (&step)[4] = inverse[2];
        double near[4];
        for (int k = 0; k < 4; ++k)
            near[k] = inverse[3][k] - step[k] + (2.0 * x - 1.0) * inverse[0][k] +
                      (2.0 * y - 1.0) * inverse[1][k];
        const double farW = near[3] + 2 * step[3];
        // Which way near + s step moves: the derivative of xyz / w, times a positive number.
        double motion[3];
        for (int k = 0; k < 3; ++k) motion[k] = near[3] * step[k] - step[3] * near[k];
        const double length = std::sqrt(motion[0] * motion[0] + motion[1] * motion[1] +
                                        motion[2] * motion[2]);
        const Vec3 direction(float(motion[0] / length), float(motion[1] / length),
                             float(motion[2] / length));
        const bool endless = !(farW * near[3] > 0);
        const double wScale = std::fmax(std::fabs(inverse[3][3]),
                                        std::fmax(std::fabs(inverse[0][3]),
                                                  std::fabs(inverse[1][3])));
        const double start = -length / (step[3] * near[3]);
        const double end = endless ? kInfinity : -length / (step[3] * farW);
        const bool hasEye = std::fabs(step[3]) > 0x1p-45 * wScale; // not merely what rounding left
        // Where the near plane is the farther one, rays lead to the eye and can not start there.
        if (hasEye && !(start < 0 && end < 0)) {
            c.setRay({float(step[0] / step[3]), float(step[1] / step[3]),
                      float(step[2] / step[3])},
                     direction, float(start > 0 ? start : 0), float(end));
        } else {
            const double range = 2 * length / std::fabs(near[3] * farW);
            c.setRay({float(near[0] / near[3]), float(near[1] / near[3]),
                      float(near[2] / near[3])},
                     direction, 0, float(endless ? kInfinity : range));
        }
    }

private:
    /// Columns of the inverse of a product in double: Gauss and Jordan, with the largest pivot of
    /// a column relative to its row.
    struct Solver {
        double columns[4][4];
        bool regular = true;

        Solver(const Mat4& a, const Mat4& b) {
            double m[4][8] = {}; // the product, and the identity that becomes the inverse
            for (int row = 0; row < 4; ++row) {
                for (int column = 0; column < 4; ++column)
                    for (int k = 0; k < 4; ++k)
                        m[row][column] += double(a(row, k)) * double(b(k, column));
                m[row][4 + row] = 1;
                double scale = 0;
                for (int k = 0; k < 4; ++k) scale = std::fmax(scale, std::fabs(m[row][k]));
                if (!(scale > 0 && std::isfinite(scale))) {
                    regular = false;
                    return;
                }
                for (double& value : m[row]) value /= scale;
            }
            for (int k = 0; k < 4; ++k) {
                int pivot = k;
                for (int row = k + 1; row < 4; ++row)
                    if (std::fabs(m[row][k]) > std::fabs(m[pivot][k])) pivot = row;
                // Rows have largest elements near 1; less than this is rounding.
                if (!(std::fabs(m[pivot][k]) > 0x1p-48)) {
                    regular = false;
                    return;
                }
                for (int i = 0; i < 8; ++i) std::swap(m[k][i], m[pivot][i]);
                const double inversePivot = 1 / m[k][k];
                for (double& value : m[k]) value *= inversePivot;
                for (int row = 0; row < 4; ++row) {
                    if (row == k) continue;
                    const double factor = m[row][k];
                    for (int i = 0; i < 8; ++i) m[row][i] -= factor * m[k][i];
                }
            }
            for (int column = 0; column < 4; ++column)
                for (int row = 0; row < 4; ++row) columns[column][row] = m[row][4 + column];
        }
    };
};

} // namespace smart::builtin
