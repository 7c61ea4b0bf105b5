// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <memory>
#include <vector>

#include "libsmart/shading/fixed_state.h"

namespace smart::compat {

/// What a block's texture unit holds that other parts of the recorder keep.
struct TextureSource {
    uint32_t texture1D = 0, texture2D = 0; ///< ids bound
    std::shared_ptr<const Texture> image;  ///< of the enabled one; nullptr: no complete one
    glm::dmat4 matrix{1.0};
};

/// The same of a block.
struct FixedStateSources {
    TextureSource texture;
    std::vector<TextureSource> moreTextures; ///< up to the last unit with a texture
    /// Of loose geometry, whose vertices are kept in eye space: what leads there from the
    /// coordinates that the application gave. The identity for objects, which keep their own.
    glm::dmat4 objectToEye{1.0};
};

/// OpenGL's fixed-function state of one context, and the immutable blocks that instances share.
class FixedStateRecorder {
public:
    FixedStateRecorder();

    /// As the calls left it, including what is switched off. The sources of blocks are not
    /// kept here.
    const FixedState& state() const { return state_; }
    /// To be changed; what was handed out stays as it was.
    FixedState& change() {
        changed_ = true;
        return state_;
    }

    /// The texture unit that is asked for and changed.
    void selectUnit(std::size_t unit) noexcept { unit_ = unit; }
    const FixedTexture& texture() const;
    FixedTexture& changeTexture();

    /// Programs that never clear a buffer, nor choose, have the depth test on from the start;
    /// from the first clear on it is OpenGL's start, off.
    void setDepthTest(bool on, bool chosen = true);
    bool depthTestChosen() const { return depthTestChosen_; }
    void bufferCleared();

    /// The state as geometry latches it: nullptr as long as it comes to nothing but what the
    /// library does on its own. What is switched off stands in a block as at the start, and
    /// equal states are the same block as far as the last few ones go.
    FixedStatePtr block(FixedStateSources sources);

private:
    static constexpr std::size_t kRemembered = 8;

    FixedState effective(const FixedStateSources& sources) const;
    /// What changed since the last block was made does not show in blocks.
    bool sameSources(const FixedStateSources& sources) const;

    FixedState state_;
    std::size_t unit_ = 0;
    bool depthTestChosen_ = false;
    bool changed_ = false;
    FixedStateSources sources_; ///< of block_
    FixedStatePtr block_;       ///< handed out last
    std::array<FixedStatePtr, kRemembered> remembered_;
    std::size_t nextRemembered_ = 0;
};

/// What rtMaterial never changed.
const std::shared_ptr<const FixedMaterials>& initialMaterials();

/// The materials as colour material makes them of a vertex's colour; as they are without it.
FixedMaterials withColor(FixedMaterials materials, const FixedLighting& lighting,
                         const glm::vec4& color);

} // namespace smart::compat
