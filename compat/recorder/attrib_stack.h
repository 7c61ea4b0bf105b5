// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "compat/recorder/attributes.h"
#include "compat/recorder/frame_settings.h"
#include "compat/recorder/idle_state.h"
#include "compat/recorder/matrix_stack.h"
#include "compat/recorder/pixel_drawing.h"
#include "compat/recorder/pixel_unpack.h"
#include "compat/recorder/texture_store.h"
#include "compat/recorder/vertex_arrays.h"
#include "libsmart/base/error.h"
#include "libsmart/shading/fixed_state.h"

namespace smart::compat {

class Context;

/// Which state is saved and restored: OpenGL's attribute groups, with its bits.
enum AttributeGroup : uint32_t {
    kCurrentGroup = 0x1,
    kPointGroup = 0x2,
    kLineGroup = 0x4,
    kPolygonGroup = 0x8,
    kPolygonStippleGroup = 0x10,
    kPixelModeGroup = 0x20,
    kLightingGroup = 0x40,
    kFogGroup = 0x80,
    kDepthBufferGroup = 0x100,
    kAccumBufferGroup = 0x200,
    kStencilBufferGroup = 0x400,
    kViewportGroup = 0x800,
    kTransformGroup = 0x1000,
    kEnableGroup = 0x2000,
    kColorBufferGroup = 0x4000,
    kHintGroup = 0x8000,
    kListGroup = 0x20000,
    kTextureGroup = 0x40000,
    kScissorGroup = 0x80000,
    kMultisampleGroup = 0x20000000
};

/// State as it was at a push; all of it is kept, and `groups` of it restored.
struct SavedState {
    uint32_t groups = 0;
    FixedState fixed;
    bool depthTestChosen = false;
    IdleState idle;
    Attributes attributes;
    FixedMaterials materials; ///< what followed the colour included
    FrameSettings frame;
    PixelDrawing pixels;
    MatrixMode matrixMode = MatrixMode::ModelView;
    std::size_t textureUnit = 0;
    struct Texture {
        uint32_t id = 0;
        TextureParameters parameters;
    };
    Texture textures[kTextureUnits][2]; ///< bound, by unit and target
    uint32_t listBase = 0;
};

struct SavedClientState {
    bool pixelStore = false, vertexArrays = false; ///< which of them to restore
    PixelStore unpack, pack;
    VertexArrays arrays;
};

/// OpenGL's stacks of attributes and of client attributes.
template <class Saved>
class SavedStack {
public:
    static constexpr std::size_t kDepth = 16;

    std::size_t depth() const { return saved_.size(); }
    void push(Saved saved) {
        if (saved_.size() == kDepth)
            throw Error(ErrorCode::StackOverflow, "the attribute stack is full");
        saved_.push_back(std::move(saved));
    }
    Saved& top() {
        if (saved_.empty())
            throw Error(ErrorCode::StackUnderflow, "no attributes were pushed");
        return saved_.back();
    }
    void pop() noexcept { saved_.pop_back(); }

private:
    std::vector<Saved> saved_;
};
using AttribStack = SavedStack<SavedState>;
using ClientAttribStack = SavedStack<SavedClientState>;

// Between neither begin and end nor newObject and endObject; each throws Error else.
void pushAttributes(Context& context, uint32_t groups);
void popAttributes(Context& context);
void pushClientAttributes(Context& context, bool pixelStore, bool vertexArrays);
void popClientAttributes(Context& context);

} // namespace smart::compat
