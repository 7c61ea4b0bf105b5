// SPDX-License-Identifier: MIT
// The check of openrt-info --check-reads: which classes pass it, and which must not.
#include "samples/tools/reads_check.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/plugins/picture.h"

using namespace plugin_test;
using samples::undeclaredReads;
using Names = std::vector<std::string>;

namespace {

Names foundIn(const char* className) {
    const RTuint id = load(className, "reads.so");
    EXPECT_NE(id, RTuint(RT_INVALID)) << rtGetErrorText();
    return undeclaredReads(*rtGetShaderClassDescriptor(id));
}

TEST(ReadsCheck, WhatIsLeftOutIsFound) {
    const Picture context;
    EXPECT_EQ(foundIn("Truthful"), Names());
    EXPECT_EQ(foundIn("Forgetful"), Names({"shading normal", "texture coordinates"}));
    EXPECT_EQ(foundIn("Unplaced"), Names({"position"}));
    EXPECT_EQ(foundIn("Blurred"), Names({"footprint"})); // the texture's level is of it
}

TEST(ReadsCheck, AllBuiltInClassesTellTheTruth) {
    const Picture context;
    std::istringstream names(rtGetShaderClassNames(nullptr));
    int checked = 0;
    for (std::string name; std::getline(names, name);) {
        const RTuint id = rtGenNewShaderClass(name.c_str(), nullptr);
        ASSERT_NE(id, RTuint(RT_INVALID)) << name;
        const RTshaderclass& c = *rtGetShaderClassDescriptor(id);
        if (!c.reads) continue;
        EXPECT_EQ(undeclaredReads(c), Names()) << name;
        ++checked;
    }
    EXPECT_GT(checked, 5);
}

} // namespace
