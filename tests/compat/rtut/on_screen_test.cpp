// SPDX-License-Identifier: MIT
// Windows on a screen: what events call, what acts on the screen, when frames are shown, how long
// the main loop waits. The sources of rtut but for its screen are compiled into this program, which
// plays the screen.
#include <gtest/gtest.h>
#include <openrt/rt.h>
#include <openrt/rtut.h>

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "compat/rtut/screen.h"

namespace {

using namespace rtut;
using Log = std::vector<std::string>;

Log log_;
SurfaceEvents* events;                   ///< of the newest window
std::deque<std::function<void()>> steps; ///< each is what one wait for events brings
std::vector<double> waits;               ///< in seconds
Picture shown;
int pictures = 0;

template <class... Values>
void note(const std::string& what, Values... values) {
    std::string line = what;
    ((line += ' ' + std::to_string(values)), ...);
    log_.push_back(line);
}

class PlayedSurface final : public Surface {
public:
    explicit PlayedSurface(Size size) : size_(size) {}
    void show(const Picture& picture) override {
        shown = picture;
        ++pictures;
    }
    Size pixels() const override { return size_; }
    void setTitle(const char* title) override { note(std::string("title ") + title); }
    void setSize(Size size) override { note("size", size.width, size.height); }
    void setPlace(Place place) override { note("place", place.x, place.y); }
    void setVisible(bool visible) override { note("visible", int(visible)); }
    void iconify() override { note("iconify"); }
    void raise() override { note("raise"); }
    void fullScreen() override { note("full screen"); }
    void warpPointer(Place place) override { note("warp", place.x, place.y); }
    void setCursor(int cursor) override { note("cursor", cursor); }

private:
    Size size_;
};

} // namespace

namespace rtut {

std::unique_ptr<Surface> openSurface(const char* title, Size size, const Place* place,
                                     SurfaceEvents& of) {
    events = &of;
    note(std::string("open ") + title, size.width, size.height, place ? place->x : -1);
    return std::make_unique<PlayedSurface>(size);
}
void waitForEvents(double seconds) {
    waits.push_back(seconds);
    if (steps.empty()) return rtutLeaveMainLoop();
    const std::function<void()> step = steps.front();
    steps.pop_front();
    step();
}
ScreenSize screenSize() {
    return {{800, 600}, {200, 150}};
}

} // namespace rtut

namespace {

class OnScreen : public testing::Test {
protected:
    OnScreen() {
        rtutInitDisplayMode(RTUT_DOUBLE);
        rtutInitWindowSize(40, 30);
        rtutInitWindowPosition(7, 9);
        window_ = rtutCreateWindow("a window");
        rtutDisplayFunc([] {
            note("display");
            rtutSwapBuffers();
        });
        waits.clear();
        pictures = 0;
    }
    ~OnScreen() override {
        rtutIdleFunc(nullptr);
        steps = {[] {
            events->closed();
            rtutLeaveMainLoop();
        }};
        rtutMainLoop();
        log_.clear();
    }
    /// What is noted while the main loop has so many rounds.
    Log played(std::deque<std::function<void()>> rounds) {
        steps = std::move(rounds);
        log_.clear();
        rtutMainLoop();
        return log_;
    }
    int window_;
};

TEST_F(OnScreen, aWindowOpensWhereAndAsLargeAsAskedFor) {
    EXPECT_EQ(log_, Log{"open a window 40 30 7"});
    EXPECT_EQ(rtutGetWindow(), window_);
    EXPECT_EQ(rtutGet(RTUT_WINDOW_X), 7);
    EXPECT_EQ(rtutGet(RTUT_WINDOW_Y), 9);
    EXPECT_EQ(rtutGet(RTUT_WINDOW_WIDTH), 40);
    EXPECT_EQ(rtutGet(RTUT_WINDOW_HEIGHT), 30);
}

TEST_F(OnScreen, theScreenAndItsDevicesAreAnswered) {
    EXPECT_EQ(rtutGet(RTUT_SCREEN_WIDTH), 800);
    EXPECT_EQ(rtutGet(RTUT_SCREEN_HEIGHT), 600);
    EXPECT_EQ(rtutGet(RTUT_SCREEN_WIDTH_MM), 200);
    EXPECT_EQ(rtutGet(RTUT_SCREEN_HEIGHT_MM), 150);
    EXPECT_EQ(rtutDeviceGet(RTUT_HAS_KEYBOARD), 1);
    EXPECT_EQ(rtutDeviceGet(RTUT_HAS_MOUSE), 1);
    EXPECT_EQ(rtutDeviceGet(RTUT_NUM_MOUSE_BUTTONS), 3);
}

TEST_F(OnScreen, keysCallWithThePointersPlaceAndTheModifiersOfTheEvent) {
    rtutKeyboardFunc(
        [](unsigned char key, int x, int y) { note("key", int(key), x, y, rtutGetModifiers()); });
    rtutKeyboardUpFunc([](unsigned char key, int, int) { note("key up", int(key)); });
    rtutSpecialFunc([](int key, int, int) { note("special", key, rtutGetModifiers()); });
    rtutSpecialUpFunc([](int key, int, int) { note("special up", key); });
    const Log log = played({[] {},
                            [] {
                                log_.clear();
                                events->pointer({3, 4}, false);
                                events->character('a', true, RTUT_ACTIVE_SHIFT);
                                events->character('a', false, 0);
                                events->special(RTUT_KEY_F2, true, RTUT_ACTIVE_ALT);
                                events->special(RTUT_KEY_F2, false, RTUT_ACTIVE_ALT);
                                note("modifiers", rtutGetModifiers());
                            }});
    EXPECT_EQ(log,
              (Log{"key 97 3 4 1", "key up 97", "special 2 4", "special up 2", "modifiers 0"}));
}

TEST_F(OnScreen, thePointerCallsByItsButtonsAndEntry) {
    rtutMouseFunc([](int button, int state, int x, int y) { note("button", button, state, x, y); });
    rtutMotionFunc([](int x, int y) { note("drag", x, y); });
    rtutPassiveMotionFunc([](int x, int y) { note("move", x, y); });
    rtutEntryFunc([](int state) { note("entry", state); });
    const Log log = played({[] {},
                            [] {
                                log_.clear();
                                events->entered(true);
                                events->pointer({1, 2}, false);
                                events->button(RTUT_LEFT_BUTTON, true, 0);
                                events->pointer({5, 6}, true);
                                events->button(RTUT_LEFT_BUTTON, false, 0);
                                events->entered(false);
                            }});
    EXPECT_EQ(log, (Log{"entry 1", "move 1 2", "button 0 0 1 2", "drag 5 6", "button 0 1 5 6",
                        "entry 0"}));
}

TEST_F(OnScreen, eventsWithoutACallbackAndOfAClosedWindowCallNothing) {
    const Log none = played({[] {},
                             [] {
                                 log_.clear();
                                 events->character('a', true, 0);
                                 events->entered(true);
                             }});
    EXPECT_EQ(none, Log{});
    rtutEntryFunc([](int state) { note("entry", state); });
    rtutDestroyWindow(window_);
    log_.clear();
    events->entered(true);
    EXPECT_EQ(log_, Log{});
}

TEST_F(OnScreen, visibilityIsToldAtTheStartAndWhenItChanges) {
    rtutVisibilityFunc([](int state) { note("visibility", state); });
    rtutWindowStatusFunc([](int state) { note("status", state); });
    const Log log = played({[] { events->shown(false); }});
    EXPECT_EQ(log, (Log{"visibility 1", "status 1", "visibility 0", "status 0", "display"}));
}

TEST_F(OnScreen, theSystemSaysWhenAWindowHasAnotherSizeOrPlace) {
    rtutReshapeFunc([](int width, int height) { note("reshape", width, height); });
    rtutReshapeWindow(64, 48);
    EXPECT_EQ(log_.back(), "size 64 48");
    EXPECT_EQ(rtutGet(RTUT_WINDOW_WIDTH), 40) << "it has not said so yet";
    const Log log = played({[] {},
                            [] {
                                log_.clear();
                                events->moved({70, 90});
                                events->resized({64, 48});
                            },
                            [] {
                                events->resized({64, 48});
                            }});
    EXPECT_EQ(log, (Log{"reshape 64 48", "display"}));
    EXPECT_EQ(rtutGet(RTUT_WINDOW_WIDTH), 64);
    EXPECT_EQ(rtutGet(RTUT_WINDOW_X), 70);
    EXPECT_EQ(shown.size.width, 64);
}

TEST_F(OnScreen, callsActOnTheScreen) {
    log_.clear();
    rtutSetWindowTitle("title");
    rtutSetWindowTitle(nullptr);
    rtutPositionWindow(5, 6);
    rtutHideWindow();
    rtutShowWindow();
    rtutIconifyWindow();
    rtutPopWindow();
    rtutFullScreen();
    rtutWarpPointer(8, 9);
    rtutSetCursor(RTUT_CURSOR_WAIT);
    rtutSetCursor(55);
    EXPECT_EQ(log_, (Log{"title title", "title ", "place 5 6", "visible 0", "visible 1", "iconify",
                         "raise", "full screen", "warp 8 9", "cursor 7"}));
    EXPECT_STREQ(rtutGetErrorText(), "rtutSetCursor: not a cursor");
    EXPECT_EQ(rtutGet(RTUT_WINDOW_CURSOR), RTUT_CURSOR_WAIT);
}

TEST_F(OnScreen, framesAreShownOnceTheyAreDone) {
    rtClearColor(0, 1, 0, 1);
    played({[] {}, [] { events->exposed(); }, [] {}});
    EXPECT_EQ(pictures, 2);
    EXPECT_EQ(shown.size.height, 30);
    ASSERT_EQ(shown.rgba.size(), 40u * 30 * 4);
    EXPECT_EQ(std::vector<uint8_t>(shown.rgba.begin(), shown.rgba.begin() + 4),
              (std::vector<uint8_t>{0, 255, 0, 255}));
}

TEST_F(OnScreen, aWindowOfOneBufferShowsAFrameWhenItsCallbackEnds) {
    rtutInitDisplayMode(RTUT_SINGLE);
    const int single = rtutCreateWindow("single");
    rtutDisplayFunc([] { rtutSwapBuffers(); });
    pictures = 0;
    EXPECT_EQ(rtutGet(RTUT_WINDOW_DOUBLEBUFFER), 0);
    rtutSetWindow(window_);
    rtutDisplayFunc([] {});
    played({[] {}});
    EXPECT_EQ(pictures, 1);
    rtutDestroyWindow(window_);
    rtutSetWindow(single);
}

TEST_F(OnScreen, theLoopWaitsNoLongerThanThereIsNothingToDo) {
    played({[] {}});
    ASSERT_EQ(waits.size(), 2u);
    EXPECT_EQ(waits[0], 0) << "a window has to be displayed";
    EXPECT_EQ(waits[1], 0.005) << "a frame is under way";
    waits.clear();
    played({});
    EXPECT_EQ(waits, std::vector<double>{1});
    rtutTimerFunc(
        100, [](int value) { note("timer", value); }, 5);
    waits.clear();
    played({});
    EXPECT_GT(waits[0], 0);
    EXPECT_LE(waits[0], 0.1);
    rtutIdleFunc([] { note("idle"); });
    waits.clear();
    EXPECT_EQ(played({[] {}}), Log{"idle"});
    EXPECT_EQ(waits, (std::vector<double>{0, 0}));
}

TEST_F(OnScreen, keysRepeatUnlessTheWindowOrTheProgramSaysNo) {
    EXPECT_TRUE(events->wantsRepeat());
    rtutIgnoreKeyRepeat(1);
    EXPECT_FALSE(events->wantsRepeat());
    rtutIgnoreKeyRepeat(0);
    rtutSetKeyRepeat(RTUT_KEY_REPEAT_OFF);
    EXPECT_FALSE(events->wantsRepeat());
    rtutSetKeyRepeat(77);
    EXPECT_STREQ(rtutGetErrorText(), "rtutSetKeyRepeat: not a mode of repeating keys");
    EXPECT_FALSE(events->wantsRepeat());
    rtutSetKeyRepeat(RTUT_KEY_REPEAT_DEFAULT);
    EXPECT_TRUE(events->wantsRepeat());
}

TEST_F(OnScreen, aMainLoopInACallbackIsAMessage) {
    rtutKeyboardFunc([](unsigned char, int, int) { rtutMainLoop(); });
    EXPECT_EQ(played({[] { events->character('a', true, 0); }}), Log{"display"});
    EXPECT_STREQ(rtutGetErrorText(), "rtutMainLoop: the main loop is running");
}

TEST_F(OnScreen, theProgramEndsWithItsLastWindow) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(played({[] { events->closed(); }}), testing::ExitedWithCode(0), "");
    const auto withoutDisplay = [this] {
        rtutDisplayFunc(nullptr);
        played({[] {}});
    };
    EXPECT_EXIT(withoutDisplay(), testing::ExitedWithCode(1), "a window has no display callback");
}

} // namespace
