// SPDX-License-Identifier: MIT
#include "compat/recorder/error_log.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "compat/recorder/error_state.h"

namespace smart::compat {
namespace {

/// The variable is read once a process: each case is a child of its own.
template <class F>
void inChild(const F& body) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        body();
        std::fflush(nullptr);
        _exit(0);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

class ErrorLog : public testing::Test {
protected:
    std::string written() const {
        std::ifstream file(path_);
        std::ostringstream text;
        text << file.rdbuf();
        return text.str();
    }
    void TearDown() override { std::filesystem::remove(path_); }

    const std::filesystem::path path_ = std::filesystem::temp_directory_path() /
                                        ("openrt-log-" + std::to_string(getpid()));
};

TEST_F(ErrorLog, HearsOfEveryErrorAlsoThoseThatDoNotStick) {
    inChild([this] {
        setenv("OPENRT_LOG", path_.c_str(), 1);
        ErrorState errors;
        errors.raise(ErrorCode::InvalidValue, "rtFirst", "one");
        errors.raise(ErrorCode::OutOfMemory, "rtSecond", "two");
    });
    EXPECT_EQ(written(), "openrt: rtFirst: INVALID_VALUE: one\n"
                         "openrt: rtSecond: OUT_OF_MEMORY: two\n");
}

TEST_F(ErrorLog, AppendsToAFileThatIsThere) {
    std::ofstream(path_) << "before\n";
    inChild([this] {
        setenv("OPENRT_LOG", path_.c_str(), 1);
        logError(ErrorCode::StackUnderflow, "rtPopMatrix", "now");
    });
    EXPECT_EQ(written(), "before\nopenrt: rtPopMatrix: STACK_UNDERFLOW: now\n");
}

TEST_F(ErrorLog, IsSilentUnlessAsked) {
    inChild([] {
        unsetenv("OPENRT_LOG");
        logError(ErrorCode::InvalidEnum, "rtEnable", "text");
    });
    EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(ErrorLog, SurvivesAPathThatCanNotBeWritten) {
    inChild([] {
        setenv("OPENRT_LOG", "/nowhere/at/all", 1);
        logError(ErrorCode::InvalidEnum, "rtEnable", "text");
        logError(ErrorCode::InvalidEnum, "rtEnable", "text");
    });
}

} // namespace
} // namespace smart::compat
