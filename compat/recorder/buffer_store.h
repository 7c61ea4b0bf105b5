// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "compat/recorder/name_ranges.h"
#include "compat/recorder/vertex_arrays.h"

namespace smart::compat {

/// The buffer objects of one context by name. A name that was generated names a buffer from its
/// first binding on; any other name does too. A function that throws has changed nothing.
class BufferStore {
public:
    /// Of several calls in a row only the first may throw.
    uint32_t generate() { return names_.addFree(1); }
    bool exists(uint32_t name) const { return buffers_.contains(name); }
    /// What binding `name` binds.
    BufferBinding bind(uint32_t name) {
        if (name == 0) return {};
        const auto known = buffers_.find(name);
        if (known != buffers_.end()) return {name, known->second};
        const auto made = buffers_.emplace(name, std::make_shared<BufferObject>()).first;
        try {
            names_.add(name);
        } catch (...) {
            buffers_.erase(made);
            throw;
        }
        return {name, made->second};
    }
    void remove(uint32_t name) {
        if (name == 0) return;
        names_.remove(name, name);
        buffers_.erase(name);
    }

private:
    NameRanges names_;
    std::map<uint32_t, BufferPtr> buffers_;
};

} // namespace smart::compat
