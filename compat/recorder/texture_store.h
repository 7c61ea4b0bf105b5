// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "libsmart/shading/texture.h"

namespace smart::compat {

/// OpenGL's two-dimensional texture objects of one context. A function that throws has changed
/// nothing.
class TextureStore {
public:
    static constexpr uint32_t kMaxId = (1u << 20) - 1; ///< frames keep textures in a table by id
    static constexpr uint32_t kMaxSize = 16384;

    /// An unused id, reserved until it is bound.
    uint32_t generate();
    void remove(uint32_t id);
    void bind(uint32_t id);
    uint32_t bound() const { return bound_; }
    bool exists(uint32_t id) const;

    /// Image of the bound texture, and with it its options; nullptr: none.
    void setImage(std::shared_ptr<const Texture> image);
    const TextureOptions& options() const;
    void setOptions(const TextureOptions& options);

    /// The table as it is now; the same one again if nothing changed since.
    std::shared_ptr<const TextureTable> freeze();

private:
    struct Object {
        bool everBound = false;
        bool stale = false; ///< the image has other options than the texture
        TextureOptions options;
        std::shared_ptr<const Texture> image;
    };
    std::map<uint32_t, Object> objects_{{0, Object{true, false, {}, nullptr}}};
    uint32_t bound_ = 0, lastGenerated_ = 0;
    std::shared_ptr<const TextureTable> table_; ///< nullptr: something changed
};

} // namespace smart::compat
