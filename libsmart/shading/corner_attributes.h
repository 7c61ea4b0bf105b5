// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "libsmart/scene/hit_chain.h"

namespace smart {

/// Attributes of the vertices of a model's triangles, by the rule that what an object did not set
/// comes from its instance, and what that one's parent did not set either from the instance above
/// it.
class CornerAttributes {
public:
    explicit CornerAttributes(const HitChain& chain)
        : chain_(chain), shading_(chain.model->shading) {}

    /// Those of the chain's triangle.
    template <class T>
    void get(const std::vector<T>& values, uint32_t first, bool InheritedAttributes::*own,
             T InheritedAttributes::*inherited, T (&corners)[3]) const {
        for (int i = 0; i < 3; ++i) {
            const T* value = find(values, first, i);
            corners[i] = value ? *value : inheritedValue(own, inherited);
        }
    }
    /// nullptr: the vertex has none of its own.
    template <class T>
    const T* find(const std::vector<T>& values, uint32_t first, int corner) const {
        return find(values, first, chain_.triangle, corner);
    }
    template <class T>
    const T* find(const std::vector<T>& values, uint32_t first, uint32_t triangle,
                  int corner) const {
        if (values.empty() || first == ShadingData::kNone || shading_.corners.empty())
            return nullptr;
        const uint32_t number = shading_.corners[triangle][std::size_t(corner)];
        return number < first ? nullptr : &values[number - first];
    }
    template <class T>
    const T& inheritedValue(bool InheritedAttributes::*own,
                            T InheritedAttributes::*inherited) const {
        uint32_t level = chain_.levels - 1;
        while (level > 0 && !(chain_.instances[level]->traits->inherited.*own)) --level;
        return chain_.instances[level]->traits->inherited.*inherited;
    }
    /// The same of a texture unit after the first.
    glm::vec4 inheritedTexCoord(std::size_t unit) const {
        const auto own = [&](uint32_t level) {
            return chain_.instances[level]->traits->inherited.ownMoreTexCoords >> unit & 1u;
        };
        uint32_t level = chain_.levels - 1;
        while (level > 0 && !own(level)) --level;
        const auto& values = chain_.instances[level]->traits->inherited.moreTexCoords;
        return values ? (*values)[unit] : MoreTexCoords()[unit];
    }

private:
    const HitChain& chain_;
    const ShadingData& shading_;
};

} // namespace smart
