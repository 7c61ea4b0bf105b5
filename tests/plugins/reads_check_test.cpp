// SPDX-License-Identifier: MIT
// The check of openrt-info --check-reads: which classes pass it, and which must not.
#include "samples/tools/reads_check.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/plugins/picture.h"

using namespace plugin_test;
using samples::undeclaredReads;
using Names = std::vector<std::string>;

namespace {

Names foundIn(const char* className) {
    return undeclaredReads(loaded(className, "reads.so"));
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
    int checked = 0;
    for (const RTshaderclass* const c : builtinClasses()) {
        if (!c->reads) continue;
        EXPECT_EQ(undeclaredReads(*c), Names()) << c->name;
        ++checked;
    }
    EXPECT_GT(checked, 5);
}

} // namespace
