// SPDX-License-Identifier: MIT
// Meshes made by rule: nothing to load, the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "libsmart/kernel/view.h"

namespace smart::test {

/// Vertices are rounded to float once and shared, so neighbours hold them bit for bit.
struct IndexedMesh {
    std::vector<double> xyz; ///< three a vertex
    std::vector<uint32_t> indices; ///< three a triangle

    uint32_t addVertex(double x, double y, double z) {
        xyz.insert(xyz.end(), {x, y, z});
        return uint32_t(xyz.size() / 3 - 1);
    }
    void addTriangle(uint32_t a, uint32_t b, uint32_t c) {
        indices.insert(indices.end(), {a, b, c});
    }
    void addQuad(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
        addTriangle(a, b, c);
        addTriangle(a, c, d);
    }
    std::vector<Triangle> triangles() const {
        std::vector<Triangle> result(indices.size() / 3);
        for (std::size_t i = 0; i < result.size(); ++i) {
            float* corners[3] = {result[i].v0, result[i].v1, result[i].v2};
            for (std::size_t c = 0; c < 3; ++c) {
                for (std::size_t k = 0; k < 3; ++k) {
                    corners[c][k] = float(xyz[std::size_t(indices[3 * i + c]) * 3 + k]);
                }
            }
        }
        return result;
    }
};

/// Icosahedron subdivided `level` times, vertices on the unit sphere, facing outward:
/// 20 * 4^level triangles, closed.
inline IndexedMesh icosphereMesh(int level) {
    IndexedMesh mesh;
    const auto addNormalised = [&mesh](double x, double y, double z) {
        const double length = std::sqrt(x * x + y * y + z * z);
        return mesh.addVertex(x / length, y / length, z / length);
    };
    const double golden = (1 + std::sqrt(5.0)) / 2;
    for (int k = 0; k < 3; ++k) { // three golden rectangles
        for (int corner = 0; corner < 4; ++corner) {
            double p[3];
            p[k] = 0;
            p[(k + 1) % 3] = (corner & 1) ? 1 : -1;
            p[(k + 2) % 3] = (corner & 2) ? golden : -golden;
            addNormalised(p[0], p[1], p[2]);
        }
    }
    // Faces: all triples whose three edges have the icosahedron's edge length, wound outward.
    const auto& p = mesh.xyz;
    const auto isEdge = [&p](uint32_t a, uint32_t b) {
        double squared = 0;
        for (uint32_t k = 0; k < 3; ++k) {
            squared += (p[3 * a + k] - p[3 * b + k]) * (p[3 * a + k] - p[3 * b + k]);
        }
        return squared < 1.2;
    };
    for (uint32_t a = 0; a < 12; ++a) {
        for (uint32_t b = a + 1; b < 12; ++b) {
            for (uint32_t c = b + 1; c < 12; ++c) {
                if (!isEdge(a, b) || !isEdge(b, c) || !isEdge(a, c)) continue;
                const double *u = &p[3 * a], *v = &p[3 * b], *w = &p[3 * c];
                const double determinant = u[0] * (v[1] * w[2] - v[2] * w[1]) +
                                           u[1] * (v[2] * w[0] - v[0] * w[2]) +
                                           u[2] * (v[0] * w[1] - v[1] * w[0]);
                if (determinant > 0) mesh.addTriangle(a, b, c);
                else mesh.addTriangle(a, c, b);
            }
        }
    }
    for (int step = 0; step < level; ++step) {
        std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
        const auto middle = [&](uint32_t a, uint32_t b) {
            const std::pair<uint32_t, uint32_t> key{a < b ? a : b, a < b ? b : a};
            const auto found = middles.find(key);
            if (found != middles.end()) return found->second;
            const double x = mesh.xyz[3 * a] + mesh.xyz[3 * b];
            const double y = mesh.xyz[3 * a + 1] + mesh.xyz[3 * b + 1];
            const double z = mesh.xyz[3 * a + 2] + mesh.xyz[3 * b + 2];
            return middles[key] = addNormalised(x, y, z);
        };
        const std::vector<uint32_t> coarse = std::exchange(mesh.indices, {});
        for (std::size_t i = 0; i < coarse.size(); i += 3) {
            const uint32_t a = coarse[i], b = coarse[i + 1], c = coarse[i + 2];
            const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            mesh.addTriangle(a, ab, ca);
            mesh.addTriangle(ab, b, bc);
            mesh.addTriangle(ca, bc, c);
            mesh.addTriangle(ab, bc, ca);
        }
    }
    return mesh;
}

inline std::vector<Triangle> icosphere(int level) { return icosphereMesh(level).triangles(); }

/// Star-shaped closed surface with bumps, of about n triangles: rings between two poles.
inline std::vector<Triangle> bumpySphere(uint32_t n) {
    const double pi = 3.14159265358979323846;
    const uint32_t rings = uint32_t(std::fmax(3.0, std::round(std::sqrt(n / 4.0))));
    const uint32_t segments = 2 * rings;
    IndexedMesh mesh;
    const auto add = [&mesh](double theta, double phi) {
        const double radius = 1 + 0.1 * std::sin(7 * theta) * std::sin(5 * phi) +
                              0.03 * std::sin(31 * theta) * std::cos(23 * phi);
        return mesh.addVertex(radius * std::sin(theta) * std::cos(phi), radius * std::cos(theta),
                              radius * std::sin(theta) * std::sin(phi));
    };
    for (uint32_t i = 1; i < rings; ++i) {
        for (uint32_t j = 0; j < segments; ++j) add(pi * i / rings, 2 * pi * j / segments);
    }
    const uint32_t top = mesh.addVertex(0, 1, 0), bottom = mesh.addVertex(0, -1, 0);
    for (uint32_t j = 0; j < segments; ++j) {
        const uint32_t next = (j + 1) % segments, last = (rings - 2) * segments;
        mesh.addTriangle(top, next, j);
        mesh.addTriangle(bottom, last + j, last + next);
        for (uint32_t i = 0; i + 2 < rings; ++i) {
            const uint32_t upper = i * segments, lower = upper + segments;
            mesh.addQuad(upper + j, upper + next, lower + next, lower + j);
        }
    }
    return mesh.triangles();
}

/// Hills over the square [-1,1]^2 in x and z, of about n triangles.
inline std::vector<Triangle> heightfield(uint32_t n) {
    const uint32_t side = uint32_t(std::fmax(1.0, std::round(std::sqrt(n / 2.0))));
    IndexedMesh mesh;
    for (uint32_t i = 0; i <= side; ++i) {
        for (uint32_t j = 0; j <= side; ++j) {
            const double x = 2.0 * j / side - 1, z = 2.0 * i / side - 1;
            const double y = 0.2 * std::sin(5 * x) * std::cos(4 * z) +
                             0.04 * std::sin(23 * x + 3 * z) + 0.01 * std::cos(71 * z - 13 * x);
            mesh.addVertex(x, y, z);
        }
    }
    for (uint32_t i = 0; i < side; ++i) {
        for (uint32_t j = 0; j < side; ++j) {
            const uint32_t corner = i * (side + 1) + j;
            mesh.addQuad(corner, corner + side + 1, corner + side + 2, corner + 1);
        }
    }
    return mesh.triangles();
}

/// n unconnected triangles in [-1,1]^3, corners within `size` of a common point on every axis.
inline std::vector<Triangle> triangleSoup(uint32_t n, float size, uint32_t seed) {
    std::mt19937 generator(seed);
    const auto uniform = [&generator] { // the standard distributions differ between libraries
        return float(generator() >> 8) * 0x1p-23f - 1.0f;
    };
    std::vector<Triangle> result(n);
    for (Triangle& triangle : result) {
        for (int k = 0; k < 3; ++k) {
            const float centre = uniform();
            triangle.v0[k] = centre + size * uniform();
            triangle.v1[k] = centre + size * uniform();
            triangle.v2[k] = centre + size * uniform();
        }
    }
    return result;
}

/// Adds an axis-aligned cube of `cells` x `cells` quads a face; faces outward, or inward.
inline void addCube(IndexedMesh& mesh, double halfSize, uint32_t cells, bool inward) {
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
            const uint32_t first = uint32_t(mesh.xyz.size() / 3);
            for (uint32_t i = 0; i <= cells; ++i) {
                for (uint32_t j = 0; j <= cells; ++j) {
                    double p[3];
                    p[axis] = side ? halfSize : -halfSize;
                    p[(axis + 1) % 3] = halfSize * (2.0 * j / cells - 1);
                    p[(axis + 2) % 3] = halfSize * (2.0 * i / cells - 1);
                    mesh.addVertex(p[0], p[1], p[2]);
                }
            }
            for (uint32_t i = 0; i < cells; ++i) {
                for (uint32_t j = 0; j < cells; ++j) {
                    const uint32_t a = first + i * (cells + 1) + j, b = a + 1;
                    const uint32_t d = a + cells + 1, c = d + 1;
                    if ((side == 1) != inward) mesh.addQuad(a, b, c, d);
                    else mesh.addQuad(a, d, c, b);
                }
            }
        }
    }
}

/// Prism of long thin sides about the y axis, closed, facing outward.
inline std::vector<Triangle> prism(uint32_t sides, double radius, double halfHeight) {
    IndexedMesh mesh;
    for (uint32_t i = 0; i < sides; ++i) {
        const double angle = 2 * 3.14159265358979323846 * i / sides;
        for (const double y : {-halfHeight, halfHeight}) {
            mesh.addVertex(radius * std::cos(angle), y, -radius * std::sin(angle));
        }
    }
    const uint32_t bottom = mesh.addVertex(0, -halfHeight, 0);
    const uint32_t top = mesh.addVertex(0, halfHeight, 0);
    for (uint32_t i = 0; i < sides; ++i) {
        const uint32_t a = 2 * i, b = 2 * ((i + 1) % sides);
        mesh.addQuad(a, b, b + 1, a + 1);
        mesh.addTriangle(bottom, b, a);
        mesh.addTriangle(top, a + 1, b + 1);
    }
    return mesh.triangles();
}

/// Room [-8,8]^3 with a box [-4,4]^3 in it, 16 x 16 quads a side, all coordinates exact, many of
/// them on common planes.
inline std::vector<Triangle> closedRoom() {
    IndexedMesh mesh;
    addCube(mesh, 8, 16, true);
    addCube(mesh, 4, 16, false);
    return mesh.triangles();
}

} // namespace smart::test
