// SPDX-License-Identifier: MIT
#include "tests/support/mesh_topology.h"

#include <algorithm>

namespace smart::test {

void MeshTopology::add(const Triangle& triangle, bool canBeHit) {
    std::array<uint32_t, 3> vertices{};
    const float* const corners[3] = {triangle.v0, triangle.v1, triangle.v2};
    for (std::size_t c = 0; c < 3 && canBeHit; ++c) {
        const float* p = corners[c];
        const std::array<float, 3> key = {p[0] + 0.0f, p[1] + 0.0f, p[2] + 0.0f}; // -0 is 0
        const auto [place, isNew] = numbers_.try_emplace(key, uint32_t(around_.size()));
        if (isNew) around_.emplace_back();
        vertices[c] = place->second;
        around_[vertices[c]].push_back(uint32_t(vertices_.size()));
    }
    vertices_.push_back(vertices);
}

std::vector<uint32_t> MeshTopology::neighbours(uint32_t triangle) const {
    std::vector<uint32_t> result;
    for (uint32_t vertex : vertices_[triangle]) {
        result.insert(result.end(), around_[vertex].begin(), around_[vertex].end());
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

// The point that is touched lies inside the surface when every triangle at that edge or vertex is
// touched here, faces the same way, and each of their edges there is shared in balance.
bool MeshTopology::surrounds(const Touch& touch, std::span<const Touch> layer) const {
    const std::array<uint32_t, 3>& own = vertices_[touch.triangle];
    const bool atVertex = (touch.zeros & (touch.zeros - 1)) != 0;
    uint32_t centre = 0, other = 0;
    for (uint32_t k = 0; k < 3; ++k) {
        if (atVertex && !(touch.zeros & (1u << k))) centre = own[k];
        if (!atVertex && (touch.zeros & (1u << k))) {
            centre = own[(k + 1) % 3];
            other = own[(k + 2) % 3];
        }
    }
    struct Balance {
        uint32_t vertex;
        int sum;
    };
    std::vector<Balance> balances; // of edges centre-neighbour: leaving minus arriving
    const auto count = [&](uint32_t vertex, int by) {
        for (Balance& balance : balances) {
            if (balance.vertex == vertex) {
                balance.sum += by;
                return;
            }
        }
        balances.push_back({vertex, by});
    };
    for (uint32_t triangle : around_[centre]) {
        const std::array<uint32_t, 3>& v = vertices_[triangle];
        if (!atVertex && std::find(v.begin(), v.end(), other) == v.end()) continue;
        const auto same = std::find_if(layer.begin(), layer.end(), [&](const Touch& t) {
            return t.triangle == triangle && t.facing == touch.facing;
        });
        if (same == layer.end()) return false;
        const auto k = std::size_t(std::find(v.begin(), v.end(), centre) - v.begin());
        count(v[(k + 1) % 3], 1);
        count(v[(k + 2) % 3], -1);
    }
    return std::all_of(balances.begin(), balances.end(), [&](const Balance& balance) {
        return balance.sum == 0 || (!atVertex && balance.vertex != other);
    });
}

bool MeshTopology::isMust(std::span<const Touch> layer) const {
    return std::any_of(layer.begin(), layer.end(), [&](const Touch& touch) {
        return touch.zeros == 0 || surrounds(touch, layer);
    });
}

} // namespace smart::test
