// SPDX-License-Identifier: MIT
#include "libsmart/geometry/instance_list.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

namespace smart {
namespace {

/// Grows by doubling, as push_back does.
template <class T>
void makeRoomIn(std::vector<T>& vector, std::size_t more) {
    const std::size_t needed = vector.size() + more;
    if (needed > vector.capacity()) vector.reserve(std::max(needed, 2 * vector.capacity()));
}

template <class Vector>
bool sameBits(const Vector& a, const Vector& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

bool sameContent(const ShaderReplacement* a, const ShaderReplacement* b) {
    if (a == b || !a || !b) return a == b;
    return a->all == b->all && a->allBy == b->allBy && a->pairs == b->pairs &&
           a->keepAlive == b->keepAlive;
}

constexpr std::size_t kOwnerCounts = 2 * sizeof(void*); // beside an object that is shared

} // namespace

std::size_t ShaderReplacement::bytes() const {
    return sizeof(ShaderReplacement) + kOwnerCounts + pairs.capacity() * sizeof(pairs[0]) +
           keepAlive.capacity() * sizeof(keepAlive[0]);
}

bool InstanceTraits::sameAs(const InstanceTraits& other) const {
    const InheritedAttributes &a = inherited, &b = other.inherited;
    return model == other.model && state == other.state &&
           sameContent(replacement.get(), other.replacement.get()) &&
           sameBits(a.color, b.color) && sameBits(a.normal, b.normal) &&
           sameBits(a.texCoord, b.texCoord) && a.materials == b.materials &&
           sameBits(a.secondaryColor, b.secondaryColor) &&
           std::bit_cast<uint32_t>(a.fogCoordinate) == std::bit_cast<uint32_t>(b.fogCoordinate) &&
           a.ownColor == b.ownColor && a.ownNormal == b.ownNormal &&
           a.ownTexCoord == b.ownTexCoord && a.ownMaterials == b.ownMaterials &&
           a.ownSecondaryColor == b.ownSecondaryColor &&
           a.ownFogCoordinate == b.ownFogCoordinate && a.moreTexCoords == b.moreTexCoords &&
           a.ownMoreTexCoords == b.ownMoreTexCoords;
}

std::size_t InstanceTraits::hash() const {
    uint64_t sum = 0;
    const auto mix = [&sum](uint64_t word) {
        sum = (sum ^ word) * 0x9E3779B97F4A7C15u;
        sum ^= sum >> 29;
    };
    for (const void* pointer : {static_cast<const void*>(model.get()),
                                static_cast<const void*>(state.get()),
                                static_cast<const void*>(inherited.materials.get()),
                                static_cast<const void*>(inherited.moreTexCoords.get())})
        mix(uint64_t(reinterpret_cast<uintptr_t>(pointer)));
    if (replacement && replacement->all) mix(replacement->allBy);
    if (replacement)
        for (const auto& [replaced, by] : replacement->pairs) mix(uint64_t(replaced) << 32 | by);
    for (int k = 0; k < 4; ++k) {
        mix(std::bit_cast<uint32_t>(inherited.color[k]));
        mix(std::bit_cast<uint32_t>(inherited.texCoord[k]));
        if (k < 3) mix(std::bit_cast<uint32_t>(inherited.normal[k]));
        if (k < 3) mix(std::bit_cast<uint32_t>(inherited.secondaryColor[k]));
    }
    mix(std::bit_cast<uint32_t>(inherited.fogCoordinate));
    return std::size_t(sum);
}

Instance asGiven(const InstanceView& instance) {
    Instance given;
    static_cast<InstanceTraits&>(given) = *instance.traits;
    given.toParent = toParent(instance);
    given.objectId = instance.objectId;
    return given;
}

InstanceList::InstanceList(std::span<const Instance> instances) {
    views_.reserve(instances.size());
    for (const Instance& instance : instances) add(instance);
}

// Traits are never changed once they are in the list, so that copies share them.
InstanceList::InstanceList(const InstanceList& other)
    : views_(other.views_), traits_(other.traits_), places_(other.places_) {}

void InstanceList::makeRoom(std::size_t more) {
    makeRoomIn(views_, more);
    makeTraitsRoom(more);
    if (spare_.size() >= more) return;
    makeRoomIn(spare_, more);
    while (spare_.size() < more) spare_.push_back(std::make_shared<InstanceTraits>());
}

void InstanceList::makeTraitsRoom(std::size_t more) {
    makeRoomIn(traits_, more);
    const std::size_t needed = 2 * (traits_.size() + more);
    if (places_.size() < needed) rehash(std::bit_ceil(std::max<std::size_t>(needed, 8)));
}

uint32_t& InstanceList::placeOf(const InstanceTraits& traits) {
    const std::size_t mask = places_.size() - 1;
    std::size_t place = traits.hash() & mask;
    while (places_[place] && !traits_[places_[place] - 1]->sameAs(traits))
        place = (place + 1) & mask;
    return places_[place];
}

void InstanceList::rehash(std::size_t places) {
    std::vector<uint32_t> larger(places);
    places_.swap(larger);
    for (std::size_t i = 0; i < traits_.size(); ++i) placeOf(*traits_[i]) = uint32_t(i + 1);
}

const InstanceTraits* InstanceList::shared(Instance&& instance) {
    if (!views_.empty() && views_.back().traits->sameAs(instance)) return views_.back().traits;
    uint32_t& place = placeOf(instance);
    if (place == 0) {
        *spare_.back() = std::move(static_cast<InstanceTraits&>(instance));
        traits_.push_back(std::move(spare_.back()));
        spare_.pop_back();
        place = uint32_t(traits_.size());
    }
    return traits_[place - 1].get();
}

void InstanceList::add(Instance instance) {
    makeRoom(1);
    InstanceView view{};
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            view.toParent[column][row] = instance.toParent[column][row];
    view.objectId = instance.objectId;
    view.traits = shared(std::move(instance));
    views_.push_back(view);
}

void InstanceList::add(const InstanceList& more) {
    makeRoomIn(views_, more.size());
    makeTraitsRoom(more.traits_.size());
    std::vector<std::pair<const InstanceTraits*, const InstanceTraits*>> here; // by theirs
    here.reserve(more.traits_.size());
    for (const Traits& traits : more.traits_) {
        uint32_t& place = placeOf(*traits);
        if (place == 0) {
            traits_.push_back(traits);
            place = uint32_t(traits_.size());
        }
        here.emplace_back(traits.get(), traits_[place - 1].get());
    }
    std::sort(here.begin(), here.end());
    for (InstanceView view : more.views_) {
        const auto theirs = [](const auto& pair) { return pair.first; };
        view.traits = std::ranges::lower_bound(here, view.traits, {}, theirs)->second;
        views_.push_back(view);
    }
}

void InstanceList::shrink() {
    // Room for a few more costs less than moving all the others.
    if (views_.capacity() - views_.size() > views_.size() / 8) views_.shrink_to_fit();
    traits_.shrink_to_fit();
    spare_ = {};
    places_ = {};
}

std::size_t InstanceList::bytes() const {
    std::size_t bytes = views_.capacity() * sizeof(InstanceView) +
                        places_.capacity() * sizeof(uint32_t) +
                        (traits_.capacity() + spare_.capacity()) * sizeof(Traits) +
                        (traits_.size() + spare_.size()) * (sizeof(InstanceTraits) + kOwnerCounts);
    for (const Traits& traits : traits_)
        if (traits->replacement) bytes += traits->replacement->bytes();
    return bytes;
}

} // namespace smart
