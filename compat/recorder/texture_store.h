// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "libsmart/shading/texture.h"

namespace smart::compat {

/// What rtTexParameter sets; firstLevel and lastLevel of the options are RT_TEXTURE_BASE_LEVEL and
/// RT_TEXTURE_MAX_LEVEL.
struct TextureParameters {
    TextureOptions options{.minification = {TextureFilter::Nearest, LevelChoice::Linear}};
    bool generateMipmap = false;
    bool operator==(const TextureParameters&) const = default;
};

/// What is known of a level of a texture.
struct TextureLevelInfo {
    uint32_t width = 0, height = 0, channels = 0;
    TexelType type = TexelType::Byte;
    int32_t internalFormat = 1; ///< as the application named it
    TexelFormat format = TexelFormat::ByChannels;
};

/// OpenGL's two-dimensional texture objects of one context. A function that throws has changed
/// nothing.
class TextureStore {
public:
    TextureStore();

    static constexpr uint32_t kMaxId = (1u << 20) - 1; ///< frames keep textures in a table by id
    static constexpr uint32_t kMaxSize = 16384;
    static constexpr uint32_t kMaxLevel = 14; ///< of a texture of that size, a single texel

    /// An unused id, reserved until it is bound.
    uint32_t generate();
    void remove(uint32_t id);
    void bind(uint32_t id);
    uint32_t bound() const { return bound_; }
    bool exists(uint32_t id) const;

    // Of the bound texture:
    /// Image of a level; nullptr: none. Where the parameters say so, the levels below the base
    /// level are to be made from it.
    void setImage(uint32_t level, TextureImagePtr image, int32_t internalFormat,
                  TexelFormat format = TexelFormat::ByChannels);
    /// nullptr: the level has none.
    TextureImagePtr image(uint32_t level) const;
    TextureLevelInfo info(uint32_t level) const;
    const TextureParameters& parameters() const { return objects_.at(bound_).parameters; }
    void setParameters(const TextureParameters& parameters);

    /// The table as it is now; the same one again if nothing changed since. An incomplete texture
    /// is its base level, enlarged or reduced by the magnification filter.
    std::shared_ptr<const TextureTable> freeze();
    /// One texture as it is now, for fixed function; nullptr: it does not exist, or is incomplete.
    /// Texture 0 is one too.
    std::shared_ptr<const Texture> complete(uint32_t id);

private:
    struct Level {
        TextureImagePtr image;
        int32_t internalFormat = 1;
        TexelFormat format = TexelFormat::ByChannels;
    };
    struct Object {
        bool everBound = false;
        TextureParameters parameters;
        std::map<uint32_t, Level> levels; ///< those that were given
        std::optional<uint32_t> madeFrom; ///< levels after this one, where not given, are made
        std::shared_ptr<const TextureLevels> images; ///< of `texture`; nullptr: they changed
        uint32_t imagesStart = 0;                    ///< number of the first of them
        std::shared_ptr<const Texture> texture;
        bool whole = false; ///< `texture` has all the levels that its filters ask for
        bool stale = false; ///< `texture` is not what the rest says

        const Level* find(uint32_t level) const;
        uint32_t lastMade() const;
        bool complete(uint32_t start, uint32_t count) const;
        void gather(uint32_t start, uint32_t count, bool all);
        void freeze();
    };

    std::map<uint32_t, Object> objects_;
    uint32_t bound_ = 0, lastGenerated_ = 0;
    std::shared_ptr<const TextureTable> table_; ///< nullptr: something changed
};

} // namespace smart::compat
