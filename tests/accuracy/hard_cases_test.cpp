// SPDX-License-Identifier: MIT
// The library keeps its promises in every hard case, and the suite finds planted defects.
#include <gtest/gtest.h>

#include "libsmart/kernel/kernels.h"
#include "tests/accuracy/case_run.h"
#include "tests/libsmart/kernel/test_size.h"

namespace smart::test {

/// For GoogleTest, which prints parameters.
void PrintTo(const NamedCase& named, std::ostream* out) {
    *out << named.name;
}

namespace {

RunSize small(std::size_t rays) {
    RunSize size;
    size.rays = rayCount(rays);
    size.identityRays = rayCount(160);
    return size;
}

class HardCases : public testing::TestWithParam<NamedCase> {};

TEST_P(HardCases, KeepPromises) {
    const CaseResult result = runCase(GetParam(), openrtKinds(), small(2500));
    EXPECT_EQ(broken(result), "");
    for (const EngineTally& entry : result.engines) {
        std::cout << "    " << entry.engine << ": " << entry.tally.counts << '\n';
    }
    std::cout << "    " << result.seconds << " s\n";
}

INSTANTIATE_TEST_SUITE_P(All, HardCases, testing::ValuesIn(hardCases(2000)), [](const auto& each) {
    std::string name = each.param.name;
    for (char& c : name) {
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    }
    return name;
});

/// Controls: what is known to lose rays must be caught.
TEST(PlantedDefects, AreFound) {
    std::vector<EngineKind> kinds;
    for (EngineKind& kind : engineKinds()) {
        if (kind.name.rfind("defect-", 0) == 0 || kind.name == "woop") kinds.push_back(kind);
    }
    ASSERT_EQ(kinds.size(), 3u);
    for (const NamedCase& named : hardCases()) {
        if (named.name != "H1-exact-edge" && named.name != "H1-round-ico3") continue;
        for (const EngineTally& entry : runCase(named, kinds, small(3000)).engines) {
            std::cout << "    " << named.name << ' ' << entry.engine << ": " << entry.tally.counts
                      << '\n';
            if (entry.engine == "woop") {
                EXPECT_EQ(entry.tally.counts.lost(), 0u);
            } else {
                EXPECT_GT(entry.tally.counts.lost(), 0u) << entry.engine << named.name;
            }
        }
    }
}

/// The verdict about a run must accuse each kind of broken promise, and nothing else.
TEST(PlantedDefects, AreAccused) {
    CaseResult kept;
    kept.name = "kept";
    kept.promise = Promise::Right;
    for (int mode = 0; mode < kPrecisionCount; ++mode) {
        kept.engines.push_back({"openrt", mode, {}});
        Tally& tally = kept.engines.back().tally;
        tally.counts.rays = tally.counts.hits = 10;
        tally.counts.of[std::size_t(Verdict::Right)] = 10;
        kept.identities.push_back({modeName(mode), 3, 10, 0});
    }
    EXPECT_EQ(broken(kept), "");
    const auto accused = [&](int mode, const auto& change) {
        CaseResult wrong = kept;
        change(wrong, wrong.engines[std::size_t(mode)].tally);
        return broken(wrong) != "";
    };
    const auto turned = [](Verdict verdict) {
        return [verdict](CaseResult&, Tally& tally) {
            --tally.counts.of[std::size_t(Verdict::Right)];
            ++tally.counts.of[std::size_t(verdict)];
        };
    };
    const auto differs = [](int mode) {
        return [mode](CaseResult& result, Tally&) {
            result.identities[std::size_t(mode)].differing = 1;
        };
    };
    const auto rounded = [](CaseResult&, Tally& tally) { tally.beyondHalfT = 1; };
    EXPECT_FALSE(accused(0, turned(Verdict::Miss)));
    EXPECT_TRUE(accused(1, turned(Verdict::Miss)));
    EXPECT_TRUE(accused(1, turned(Verdict::Through)));
    EXPECT_TRUE(accused(1, turned(Verdict::Gross)));
    EXPECT_FALSE(accused(1, turned(Verdict::WrongPrim)));
    EXPECT_TRUE(accused(1, rounded));
    EXPECT_TRUE(accused(2, turned(Verdict::WrongPrim)));
    EXPECT_TRUE(accused(2, turned(Verdict::Order)));
    EXPECT_TRUE(accused(2, rounded));
    EXPECT_FALSE(accused(0, differs(0)));
    EXPECT_TRUE(accused(1, differs(1)));
    EXPECT_TRUE(accused(2, differs(2)));
    kept.promise = Promise::NothingLost;
    EXPECT_FALSE(accused(1, turned(Verdict::Slide)));
    EXPECT_TRUE(accused(1, turned(Verdict::Miss)));
    kept.promise = Promise::None;
    EXPECT_FALSE(accused(1, turned(Verdict::Miss)));
    EXPECT_TRUE(accused(2, turned(Verdict::Miss)));
}

} // namespace
} // namespace smart::test
