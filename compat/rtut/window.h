// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "compat/rtut/picture.h"
#include "compat/rtut/screen.h"
#include "openrt/types.h"

namespace rtut {

/// The application's functions of a window.
struct WindowCallbacks {
    void (*display)() = nullptr;
    void (*reshape)(int, int) = nullptr;
    void (*keyboard)(unsigned char, int, int) = nullptr;
    void (*keyboardUp)(unsigned char, int, int) = nullptr;
    void (*special)(int, int, int) = nullptr;
    void (*specialUp)(int, int, int) = nullptr;
    void (*mouse)(int, int, int, int) = nullptr;
    void (*motion)(int, int) = nullptr;
    void (*passiveMotion)(int, int) = nullptr;
    void (*entry)(int) = nullptr;
    void (*visibility)(int) = nullptr;
    void (*windowStatus)(int) = nullptr;
};

/// Who gets finished pictures, in order.
class Audience {
public:
    virtual void take(const Picture& picture) = 0;

protected:
    ~Audience() = default;
};

/// What the frames of a context are rendered to. Lives as long as the context, which keeps its
/// address: the application may start frames of its own, also after the window's end.
struct FrameMemory {
    Picture pictures[2];
    std::vector<Picture> former; ///< of other sizes; frames in flight may be rendered to them
};

/// The frames of a window: one is rendered while the next is described. Acts on the current
/// context.
class FrameChain {
public:
    FrameChain(Audience& audience, FrameMemory& memory) : audience_(audience), memory_(memory) {}

    /// Delivers what is under way; later frames have the new size.
    void resize(Size size);
    /// Queues the frame and delivers the one before; false: it could not be queued.
    bool queue();
    /// Waits for the frame under way, if there is one, and delivers it.
    void finish();
    /// The same, unless that would mean to wait.
    void finishIfDone();
    bool isUnderWay() const { return underWay_ != RT_INVALID; }

private:
    /// Lets the next frame be rendered to the picture described.
    void usePicture();

    Audience& audience_;
    FrameMemory& memory_;
    int described_ = 0; ///< which of them the next frame is rendered to
    RTuint underWay_ = RT_INVALID;
};

class Window final : public SurfaceEvents, public Audience {
public:
    Window(int id, RTcontext context, bool ownsContext, unsigned displayMode, Size size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    void open(const char* title, const Place* place);
    /// Makes it and its context current.
    void select();
    void swap();
    void reshapeIfNeeded();
    void display();
    /// Shows or writes the frame under way.
    void finish();
    void finishIfDone();
    bool hasFrameUnderWay() const { return frames_.isUnderWay(); }
    void setSize(Size size);

    int id() const { return id_; }
    bool isDoubleBuffered() const;
    bool isAlive() const { return alive_; }
    void close() { alive_ = false; }
    Surface* surface() const { return surface_.get(); }

    // SurfaceEvents
    void resized(Size pixels) override;
    void moved(Place place) override { place_ = place; }
    void exposed() override { redisplay = true; }
    void closed() override { alive_ = false; }
    void shown(bool visible) override;
    void character(unsigned char key, bool down, int modifiers) override;
    void special(int key, bool down, int modifiers) override;
    void button(int button, bool down, int modifiers) override;
    void pointer(Place place, bool pressed) override;
    void entered(bool inside) override;
    bool wantsRepeat() const override;

    // Audience
    void take(const Picture& picture) override;

    WindowCallbacks callbacks;
    bool redisplay = true;
    bool ignoresRepeat = false;
    int cursor = 0;
    unsigned displayMode;
    Size size;
    Place place() const { return place_; }

private:
    /// Calls an event's function with the window current, unless there is none.
    template <class... Parameters, class... Arguments>
    void call(void (*function)(Parameters...), int modifiers, Arguments... arguments);

    int id_;
    RTcontext context_;
    bool ownsContext_;
    bool alive_ = true, reshape_ = true, isShown_ = false;
    Place place_{0, 0}, pointer_{0, 0};
    std::unique_ptr<Surface> surface_; ///< none off-screen
    FrameChain frames_;
};

} // namespace rtut
