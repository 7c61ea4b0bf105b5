// SPDX-License-Identifier: MIT
// A window on GLFW: what its events become, what calls on it do, how a picture is shown.
#include "compat/rtut/screen.h"

#include <gtest/gtest.h>
#include <openrt/rtut_enums.h>

#include "tests/compat/rtut/played_glfw.h"

namespace {

using namespace rtut;
using namespace rtut::test;
using Log = std::vector<std::string>;

class Heard final : public SurfaceEvents {
public:
    void resized(Size pixels) override { note("resized", pixels.width, pixels.height); }
    void moved(Place place) override { note("moved", place.x, place.y); }
    void exposed() override { note("exposed"); }
    void closed() override { note("closed"); }
    void shown(bool visible) override { note("shown", visible); }
    void character(unsigned char key, bool down, int modifiers) override {
        note("character", key, down, modifiers);
    }
    void special(int key, bool down, int modifiers) override {
        note("special", key, down, modifiers);
    }
    void button(int button, bool down, int modifiers) override {
        note("button", button, down, modifiers);
    }
    void pointer(Place place, bool pressed) override { note("pointer", place.x, place.y, pressed); }
    void entered(bool inside) override { note("entered", inside); }
    bool wantsRepeat() const override { return repeats; }

    Log log;
    bool repeats = true;

private:
    template <class... Numbers>
    void note(const char* what, Numbers... numbers) {
        std::string line = what;
        ((line += ' ' + std::to_string(int(numbers))), ...);
        log.push_back(line);
    }
};

class ScreenTest : public testing::Test {
protected:
    Heard heard;
    std::unique_ptr<Surface> surface = openSurface("window", {40, 30}, nullptr, heard);

    void key(int code, int action, int modifiers = 0) {
        playedWindow.key(handle(), code, 0, action, modifiers);
    }
};

TEST_F(ScreenTest, windowEventsAreHeard) {
    playedWindow.resized(handle(), 50, 60);
    playedWindow.resized(handle(), 0, 0); // iconified
    playedWindow.moved(handle(), 3, 4);
    playedWindow.exposed(handle());
    playedWindow.iconified(handle(), GLFW_TRUE);
    playedWindow.iconified(handle(), GLFW_FALSE);
    playedWindow.closed(handle());
    EXPECT_EQ(heard.log,
              (Log{"resized 50 60", "moved 3 4", "exposed", "shown 0", "shown 1", "closed"}));
}

TEST_F(ScreenTest, thePointersEventsAreGluts) {
    playedWindow.entered(handle(), GLFW_TRUE);
    playedWindow.pointer(handle(), 5.5, 6.5);
    playedWindow.button(handle(), GLFW_MOUSE_BUTTON_RIGHT, GLFW_PRESS, GLFW_MOD_CONTROL);
    playedWindow.pressedButton = GLFW_MOUSE_BUTTON_RIGHT;
    playedWindow.pointer(handle(), 7, 8);
    playedWindow.button(handle(), GLFW_MOUSE_BUTTON_MIDDLE, GLFW_RELEASE, 0);
    playedWindow.button(handle(), GLFW_MOUSE_BUTTON_4, GLFW_PRESS, 0);
    playedWindow.wheel(handle(), 0, -1);
    playedWindow.wheel(handle(), 0, 1);
    EXPECT_EQ(heard.log,
              (Log{"entered 1", "pointer 5 6 0", "button 2 1 2", "pointer 7 8 1", "button 1 0 0",
                   "button 4 1 0", "button 4 0 0", "button 3 1 0", "button 3 0 0"}));
}

TEST_F(ScreenTest, aCharacterIsTheKeysUntilItIsReleased) {
    key(GLFW_KEY_A, GLFW_PRESS, GLFW_MOD_SHIFT);
    playedWindow.character(handle(), 'A');
    key(GLFW_KEY_A, GLFW_RELEASE);
    key(GLFW_KEY_A, GLFW_RELEASE); // is not held
    key(GLFW_KEY_B, GLFW_PRESS);
    playedWindow.character(handle(), 0x20AC); // not Latin-1
    EXPECT_EQ(heard.log, (Log{"character 65 1 1", "character 65 0 0"}));
}

TEST_F(ScreenTest, keysWithoutACharacterOfTheSystemHaveAsciis) {
    const std::pair<int, int> keys[] = {{GLFW_KEY_ESCAPE, 27},   {GLFW_KEY_ENTER, 13},
                                        {GLFW_KEY_KP_ENTER, 13}, {GLFW_KEY_TAB, 9},
                                        {GLFW_KEY_BACKSPACE, 8}, {GLFW_KEY_DELETE, 127}};
    for (const auto& [code, character] : keys) {
        heard.log.clear();
        key(code, GLFW_PRESS);
        EXPECT_EQ(heard.log, Log{"character " + std::to_string(character) + " 1 0"});
    }
    heard.log.clear();
    key(GLFW_KEY_C, GLFW_PRESS, GLFW_MOD_CONTROL | GLFW_MOD_ALT);
    EXPECT_EQ(heard.log, Log{"character 3 1 6"});
}

TEST_F(ScreenTest, specialKeysHaveGlutsNumbers) {
    const std::pair<int, int> keys[] = {
        {GLFW_KEY_F1, RTUT_KEY_F1},           {GLFW_KEY_F12, RTUT_KEY_F12},
        {GLFW_KEY_LEFT, RTUT_KEY_LEFT},       {GLFW_KEY_UP, RTUT_KEY_UP},
        {GLFW_KEY_RIGHT, RTUT_KEY_RIGHT},     {GLFW_KEY_DOWN, RTUT_KEY_DOWN},
        {GLFW_KEY_PAGE_UP, RTUT_KEY_PAGE_UP}, {GLFW_KEY_PAGE_DOWN, RTUT_KEY_PAGE_DOWN},
        {GLFW_KEY_HOME, RTUT_KEY_HOME},       {GLFW_KEY_END, RTUT_KEY_END},
        {GLFW_KEY_INSERT, RTUT_KEY_INSERT}};
    for (const auto& [code, number] : keys) {
        heard.log.clear();
        key(code, GLFW_PRESS);
        key(code, GLFW_RELEASE);
        const std::string name = "special " + std::to_string(number);
        EXPECT_EQ(heard.log, (Log{name + " 1 0", name + " 0 0"}));
    }
}

TEST_F(ScreenTest, heldKeysRepeatWhereThatIsWanted) {
    for (const bool repeats : {true, false}) {
        heard.repeats = repeats;
        key(GLFW_KEY_A, GLFW_PRESS);
        heard.log.clear();
        key(GLFW_KEY_A, GLFW_REPEAT);
        playedWindow.character(handle(), 'a');
        key(GLFW_KEY_UP, GLFW_REPEAT);
        EXPECT_EQ(heard.log.size(), repeats ? 2u : 0u);
    }
}

TEST_F(ScreenTest, callsReachTheWindow) {
    surface->setTitle("title");
    surface->setSize({50, 60});
    surface->setPlace({1, 2});
    surface->setVisible(false);
    surface->setVisible(true);
    surface->iconify();
    surface->raise();
    surface->warpPointer({3, 4});
    EXPECT_TRUE(endWith({"title title", "size 50 60", "place 1 2", "hide", "restore", "show",
                         "iconify", "focus", "warp 3 4"}));
    surface->fullScreen();
    surface->setSize({70, 80});
    surface->setSize({50, 60});
    EXPECT_TRUE(endWith({"full screen 1280 1024", "no full screen 70 80", "size 50 60"}));
    surface.reset();
    EXPECT_TRUE(endWith({"destroy"}));
}

TEST_F(ScreenTest, cursorsAreTheNearestOfTheSystemAndMadeOnce) {
    const std::pair<int, int> shapes[] = {
        {RTUT_CURSOR_HELP, GLFW_HAND_CURSOR},           {RTUT_CURSOR_TEXT, GLFW_IBEAM_CURSOR},
        {RTUT_CURSOR_CROSSHAIR, GLFW_CROSSHAIR_CURSOR}, {RTUT_CURSOR_TOP_SIDE, GLFW_VRESIZE_CURSOR},
        {RTUT_CURSOR_LEFT_SIDE, GLFW_HRESIZE_CURSOR},   {RTUT_CURSOR_SPRAY, GLFW_ARROW_CURSOR}};
    for (const auto& [cursor, shape] : shapes) {
        surface->setCursor(cursor);
        EXPECT_TRUE(endWith({"pointer shown 1", "make cursor " + std::to_string(shape), "cursor"}));
        surface->setCursor(cursor);
        EXPECT_TRUE(endWith({"cursor", "pointer shown 1", "cursor"})) << cursor;
    }
    surface->setCursor(RTUT_CURSOR_NONE);
    EXPECT_TRUE(endWith({"pointer shown 0", "cursor"}));
}

TEST_F(ScreenTest, aPictureFillsTheWindowItsFirstRowBelow) {
    const Picture picture{{2, 1}, std::vector<uint8_t>(8, 99), {}};
    surface->show(picture);
    EXPECT_TRUE(
        endWith({"viewport 40 30", "picture 2 1 99", "texel 0 0", "corner -1 -1", "texel 1 0",
                 "corner 1 -1", "texel 0 1", "corner -1 1", "texel 1 1", "corner 1 1", "swap"}));
    playedWindow.width = playedWindow.height = 0; // iconified
    EXPECT_EQ(surface->pixels(), (Size{1, 1}));
}

TEST_F(ScreenTest, aPlaceIsTakenAndEventsAreWaitedForOrNot) {
    const Place place{11, 12};
    surface = openSurface("placed", {40, 30}, &place, heard);
    EXPECT_EQ(playedCalls[1], "place 11 12");
    waitForEvents(0.25);
    waitForEvents(0);
    EXPECT_TRUE(endWith({"wait 250", "poll"}));
}

TEST_F(ScreenTest, theScreensSizeIsItsMonitors) {
    EXPECT_EQ(screenSize().pixels, (Size{1280, 1024}));
    EXPECT_EQ(screenSize().millimetres, (Size{340, 270}));
    hasMonitor = false;
    EXPECT_EQ(screenSize().pixels, (Size{0, 0}));
    surface->fullScreen();
    EXPECT_NE(playedCalls.back(), "full screen 1280 1024");
    hasMonitor = true;
}

TEST_F(ScreenTest, aWindowThatDoesNotOpenEndsTheProgram) {
    opensWindows = false;
    EXPECT_EXIT(openSurface("window", {40, 30}, nullptr, heard), testing::ExitedWithCode(1),
                "rtut: no window can be opened: there is no room");
    opensWindows = true;
}

TEST(Screen, withoutADisplayHasNoSizeAndNoWindows) {
    testing::FLAGS_gtest_death_test_style = "threadsafe"; // GLFW is started once
    const auto withoutDisplay = [] {
        hasDisplay = false;
        if (screenSize().pixels != Size{0, 0}) std::exit(7);
        Heard heard;
        openSurface("window", {40, 30}, nullptr, heard);
    };
    EXPECT_EXIT(withoutDisplay(), testing::ExitedWithCode(1),
                "rtut: there is no display: it is played");
}

} // namespace
