// SPDX-License-Identifier: MIT
#include "compat/rtut/window.h"

#include <utility>

#include "compat/rtut/app.h"
#include "openrt/rt.h"
#include "openrt/rtut_enums.h"

namespace rtut {

void FrameChain::resize(Size size) {
    finish();
    const std::size_t pixels = std::size_t(size.width) * std::size_t(size.height);
    for (Picture& picture : memory_.pictures) {
        const bool hadDepth = !picture.depth.empty(); // then the context has its address
        const bool hasDepth = hadDepth || !app().options().depth.empty();
        if (picture.size == size && hasDepth == hadDepth) continue;
        Picture sized{size, std::vector<uint8_t>(pixels * 4),
                      std::vector<float>(hasDepth ? pixels : 0, 1.0f)};
        memory_.former.push_back(std::move(picture));
        picture = std::move(sized);
    }
    usePicture();
}

bool FrameChain::queue() {
    const RTuint frame = rtQueueFrame();
    if (frame == RT_INVALID) return false;
    finish();
    underWay_ = frame;
    described_ = 1 - described_;
    usePicture();
    return true;
}

void FrameChain::usePicture() {
    Picture& next = memory_.pictures[described_];
    rtSetFrameBuffer(next.rgba.data(), RTuint(next.size.width), RTuint(next.size.height),
                     RT_RGBA_8);
    if (!next.depth.empty()) rtSetAuxBuffer(RT_DEPTH, next.depth.data(), RT_FLOAT);
}

void FrameChain::finish() {
    if (!isUnderWay()) return;
    // Frames end in order: when this one is done, none is rendered to former memory any more.
    if (rtWaitFrame(underWay_)) memory_.former.clear();
    underWay_ = RT_INVALID;
    audience_.take(memory_.pictures[1 - described_]);
}

void FrameChain::finishIfDone() {
    if (!isUnderWay()) return;
    const RTenum status = rtFrameStatus(underWay_);
    if (status != RT_QUEUED && status != RT_RENDERING) finish();
}

Window::Window(int id, RTcontext context, bool ownsContext, unsigned mode, Size firstSize)
    : displayMode(mode),
      size(firstSize),
      id_(id),
      context_(context),
      ownsContext_(ownsContext),
      frames_(*this, app().frameMemory(context)) {}

Window::~Window() {
    if (!ownsContext_) return;
    const RTcontext current = rtGetCurrentContext();
    rtDestroyContext(context_);
    app().forgetFrameMemory(context_);
    if (current != context_) rtMakeCurrent(current);
}

void Window::open(const char* title, const Place* place) {
    if (place) place_ = *place;
    if (!app().isOffscreen()) {
        surface_ = openSurface(title, size, place, *this);
        size = surface_->pixels();
    }
    select();
    frames_.resize(size);
    if (displayMode & RTUT_MULTISAMPLE) rtEnable(RT_MULTISAMPLE);
}

void Window::select() {
    app().setCurrent(this);
    if (rtGetCurrentContext() != context_) rtMakeCurrent(context_);
}

bool Window::isDoubleBuffered() const {
    return displayMode & RTUT_DOUBLE;
}

void Window::swap() {
    if (frames_.queue())
        app().countFrame();
    else
        tellOnce("rtutSwapBuffers", rtGetErrorText());
}

void Window::reshapeIfNeeded() {
    if (!reshape_) return;
    reshape_ = false;
    redisplay = true;
    select();
    frames_.resize(size);
    if (callbacks.reshape)
        callbacks.reshape(size.width, size.height);
    else
        rtViewport(0, 0, size.width, size.height);
    if (!isShown_) shown(true);
    isShown_ = true;
}

void Window::display() {
    redisplay = false;
    if (!callbacks.display) endProgram(1, "a window has no display callback");
    select();
    callbacks.display();
    if (isDoubleBuffered() || !alive_) return;
    select();
    swap();
    frames_.finish();
}

void Window::finish() {
    select();
    frames_.finish();
}

void Window::finishIfDone() {
    if (!frames_.isUnderWay()) return;
    select();
    frames_.finishIfDone();
}

void Window::setSize(Size wanted) {
    if (surface_) return surface_->setSize(wanted); // the system tells when it is so
    if (app().options().size) return;
    size = wanted;
    reshape_ = true;
}

void Window::take(const Picture& picture) {
    if (surface_)
        surface_->show(picture);
    else
        app().writeFrame(picture);
}

template <class... Parameters, class... Arguments>
void Window::call(void (*function)(Parameters...), int modifiers, Arguments... arguments) {
    if (!function || !alive_) return;
    select();
    app().setModifiers(modifiers);
    function(arguments...);
    app().setModifiers(0);
}

void Window::resized(Size pixels) {
    if (pixels == size) return;
    size = pixels;
    reshape_ = true;
}

void Window::shown(bool visible) {
    call(callbacks.visibility, 0, visible ? RTUT_VISIBLE : RTUT_NOT_VISIBLE);
    call(callbacks.windowStatus, 0, visible ? RTUT_FULLY_RETAINED : RTUT_HIDDEN);
}

void Window::character(unsigned char key, bool down, int modifiers) {
    call(down ? callbacks.keyboard : callbacks.keyboardUp, modifiers, key, pointer_.x, pointer_.y);
}

void Window::special(int key, bool down, int modifiers) {
    call(down ? callbacks.special : callbacks.specialUp, modifiers, key, pointer_.x, pointer_.y);
}

void Window::button(int button, bool down, int modifiers) {
    call(callbacks.mouse, modifiers, button, down ? RTUT_DOWN : RTUT_UP, pointer_.x, pointer_.y);
}

void Window::pointer(Place place, bool pressed) {
    pointer_ = place;
    call(pressed ? callbacks.motion : callbacks.passiveMotion, 0, place.x, place.y);
}

void Window::entered(bool inside) {
    call(callbacks.entry, 0, inside ? RTUT_ENTERED : RTUT_LEFT);
}

bool Window::wantsRepeat() const {
    return !ignoresRepeat && app().repeatsKeys;
}

} // namespace rtut
