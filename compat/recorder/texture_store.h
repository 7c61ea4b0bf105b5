// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "libsmart/geometry/texture_units.h"
#include "libsmart/shading/texture.h"

namespace smart::compat {

/// What rtTexParameter sets; firstLevel and lastLevel of the options are RT_TEXTURE_BASE_LEVEL and
/// RT_TEXTURE_MAX_LEVEL.
struct TextureParameters {
    TextureOptions options{.minification = {TextureFilter::Nearest, LevelChoice::Linear}};
    bool generateMipmap = false;
    float priority = 1.0f; ///< without effect, as all textures are in memory
    TextureWrap wrapR = TextureWrap::Repeat; ///< without effect for lack of a third dimension
    bool operator==(const TextureParameters&) const = default;
};

/// What is known of a level of a texture.
struct TextureLevelInfo {
    uint32_t width = 0, height = 0, channels = 0;
    TexelType type = TexelType::Byte;
    int32_t internalFormat = 1; ///< as the application named it
    TexelFormat format = TexelFormat::ByChannels;
};

enum class TextureTarget : uint8_t { OneDimensional, TwoDimensional };

/// OpenGL's texture objects of one context; those of one dimension have images of height 1. A
/// function that throws has changed nothing.
class TextureStore {
public:
    TextureStore();

    static constexpr uint32_t kMaxId = (1u << 20) - 1; ///< frames keep textures in a table by id
    static constexpr uint32_t kMaxSize = 16384;
    static constexpr uint32_t kMaxLevel = 14; ///< of a texture of that size, a single texel

    /// The texture unit whose bindings all that follows is about.
    void selectUnit(std::size_t unit) { unit_ = unit; }

    /// An unused id, reserved until it is bound.
    uint32_t generate();
    void remove(uint32_t id);
    /// A texture has the number of dimensions that it was first bound with.
    void bind(uint32_t id, TextureTarget target = kDefaultTarget);
    uint32_t bound(TextureTarget target = kDefaultTarget) const {
        return boundTo(target, unit_);
    }
    bool exists(uint32_t id) const;
    /// It exists and has this number of dimensions.
    bool exists(uint32_t id, TextureTarget target) const {
        return exists(id) && objects_.at(id).target == target;
    }

    // Of the texture bound to a target:
    /// Image of a level, which was not made const; nullptr: none. Where the parameters say so, the levels below the base
    /// level are to be made from it.
    void setImage(uint32_t level, TextureImagePtr image, int32_t internalFormat,
                  TexelFormat format = TexelFormat::ByChannels,
                  TextureTarget target = kDefaultTarget);
    /// Replaces a part of a level that there is: in place, unless a frame has the image. Throws Error
    /// as TextureImage::setPart() does.
    void setPart(uint32_t level, uint32_t x, uint32_t y, const TextureImage& part,
                 TextureTarget target = kDefaultTarget);
    /// nullptr: the level has none.
    TextureImagePtr image(uint32_t level, TextureTarget target = kDefaultTarget) const;
    TextureLevelInfo info(uint32_t level, TextureTarget target = kDefaultTarget) const;
    const TextureParameters& parameters(TextureTarget target = kDefaultTarget) const {
        return objects_.at(keyOfBound(target)).parameters;
    }
    void setParameters(const TextureParameters& parameters,
                       TextureTarget target = kDefaultTarget);

    // Of the proxies, of which there is one for each target: how an image would be, without one.
    void setProxy(uint32_t level, const TextureLevelInfo& info, TextureTarget target) {
        proxies_[std::size_t(target)][level] = info;
    }
    const TextureLevelInfo& proxy(uint32_t level, TextureTarget target) const {
        return proxies_[std::size_t(target)][level];
    }

    /// The table as it is now; the same one again if nothing changed since. An incomplete texture
    /// is its base level, enlarged or reduced by the magnification filter.
    std::shared_ptr<const TextureTable> freeze();
    /// The bound texture as it is now, for fixed function; nullptr: it is incomplete. Texture 0 is
    /// one too.
    std::shared_ptr<const Texture> completeBound(TextureTarget target = kDefaultTarget) {
        return completeBound(target, unit_);
    }
    /// The same of any unit.
    std::shared_ptr<const Texture> completeBound(TextureTarget target, std::size_t unit);
    uint32_t boundTo(TextureTarget target, std::size_t unit) const {
        const uint32_t key = bound_[unit].keys[std::size_t(target)];
        return key == kDefault1D ? 0 : key;
    }

private:
    static constexpr TextureTarget kDefaultTarget = TextureTarget::TwoDimensional;
    /// Under which the texture 0 of one dimension is kept.
    static constexpr uint32_t kDefault1D = kMaxId + 1;

    struct Level {
        TextureImagePtr image;
        int32_t internalFormat = 1;
        TexelFormat format = TexelFormat::ByChannels;
    };
    struct Object {
        std::optional<TextureTarget> target; ///< empty: never bound
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
    uint32_t keyOfBound(TextureTarget target) const {
        return bound_[unit_].keys[std::size_t(target)];
    }
    struct Bindings {
        uint32_t keys[2] = {kDefault1D, 0}; ///< by target
    };
    Bindings bound_[kTextureUnits];
    std::size_t unit_ = 0;
    TextureLevelInfo proxies_[2][kMaxLevel + 1]; ///< by target and level
    uint32_t lastGenerated_ = 0;
    std::shared_ptr<const TextureTable> table_; ///< nullptr: something changed
};

} // namespace smart::compat
