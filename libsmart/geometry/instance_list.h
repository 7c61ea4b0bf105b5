// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <vector>

#include "libsmart/geometry/instance.h"

namespace smart {

/// Instances in a row, in little memory: a matrix each, and once what several have in common.
/// Throws std::bad_alloc; what threw had no effect.
class InstanceList {
public:
    using Traits = std::shared_ptr<InstanceTraits>;

    InstanceList() = default;
    InstanceList(const std::vector<Instance>& instances)
        : InstanceList(std::span(instances)) {}
    InstanceList(std::initializer_list<Instance> instances)
        : InstanceList(std::span(instances.begin(), instances.size())) {}
    InstanceList(const InstanceList& other);
    InstanceList& operator=(const InstanceList& other) { return *this = InstanceList(other); }
    InstanceList(InstanceList&&) = default;
    InstanceList& operator=(InstanceList&&) = default;

    /// Memory for so many in all.
    void reserve(std::size_t count) { views_.reserve(count); }
    /// So many more can be added without throwing.
    void makeRoom(std::size_t more);
    void add(Instance instance);
    void add(const InstanceList& more);
    /// Gives back what only adding needs.
    void shrink();

    bool empty() const { return views_.empty(); }
    std::size_t size() const { return views_.size(); }
    /// Matrices, ids and traits; the rest is InstanceGroup's to fill in.
    std::span<const InstanceView> views() const { return views_; }
    std::span<InstanceView> views() { return views_; }
    /// Each that some instance has, once.
    std::span<const Traits> traits() const { return traits_; }
    /// Of itself and of the replacements in it, other than sizeof.
    std::size_t bytes() const;

private:
    explicit InstanceList(std::span<const Instance> instances);
    void makeTraitsRoom(std::size_t more);
    const InstanceTraits* shared(Instance&& instance);
    void rehash(std::size_t places);
    uint32_t& placeOf(const InstanceTraits& traits);

    std::vector<InstanceView> views_;
    std::vector<Traits> traits_, spare_;
    /// Numbers in traits_ plus one at a place by their hash, or the next free one. A power of two,
    /// at least twice as many as there are traits.
    std::vector<uint32_t> places_;
};

} // namespace smart
