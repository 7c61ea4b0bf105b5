// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "compat/rtut/options.h"
#include "compat/rtut/picture.h"

namespace rtut {

/// What happens to a window on the screen; called by Screen::wait. Positions from the upper left.
class SurfaceEvents {
public:
    virtual void resized(Size pixels) = 0;
    virtual void moved(Place place) = 0;
    virtual void exposed() = 0;
    virtual void closed() = 0;
    virtual void shown(bool visible) = 0;
    virtual void character(unsigned char key, bool down, int modifiers) = 0;
    virtual void special(int key, bool down, int modifiers) = 0;
    virtual void button(int button, bool down, int modifiers) = 0;
    virtual void pointer(Place place, bool pressed) = 0;
    virtual void entered(bool inside) = 0;
    virtual bool wantsRepeat() const = 0;

protected:
    ~SurfaceEvents() = default;
};

/// A window on the screen, which shows pictures.
class Surface {
public:
    virtual ~Surface() = default;
    virtual void show(const Picture& picture) = 0;
    virtual Size pixels() const = 0;
    virtual void setTitle(const char* title) = 0;
    virtual void setSize(Size size) = 0;
    virtual void setPlace(Place place) = 0;
    virtual void setVisible(bool visible) = 0;
    virtual void iconify() = 0;
    virtual void raise() = 0;
    virtual void fullScreen() = 0;
    virtual void warpPointer(Place place) = 0;
    virtual void setCursor(int cursor) = 0;
};

struct ScreenSize {
    Size pixels, millimetres;
};

// The window system, started by the first call.

/// Ends the program with a message where there is none, or no window can be opened.
std::unique_ptr<Surface> openSurface(const char* title, Size size, const Place* place,
                                     SurfaceEvents& events);
/// Waits so long for events at most (0: not at all) and calls the surfaces' events.
void waitForEvents(double seconds);
/// Zeros where there is no display.
ScreenSize screenSize();

} // namespace rtut
