// SPDX-License-Identifier: MIT
#include "tests/accuracy/hard_case.h"

#include <cmath>

namespace smart::test {

Geometry::Geometry(std::vector<Triangle> mesh) {
    meshes.push_back(std::move(mesh));
    placements.push_back({0, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, true});
}

void Geometry::addTo(ExactReference& reference) const {
    for (const Placement& placement : placements) {
        Matrix34 matrix = placement.toWorld;
        if (placement.dropped) matrix.fill(NAN); // all its triangles are none
        if (placement.identity)
            reference.add(meshes[placement.mesh]);
        else
            reference.add(meshes[placement.mesh], {&matrix, 1});
    }
}

std::size_t Geometry::triangles() const {
    std::size_t count = 0;
    for (const Placement& placement : placements) count += meshes[placement.mesh].size();
    return count;
}

std::vector<NamedCase> hardCases(uint32_t crowd) {
    std::vector<NamedCase> all;
    for (const auto& part :
         {aimedCases(), alignedCases(), crowdedCases(crowd), placedCases(), limitCases()}) {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

} // namespace smart::test
