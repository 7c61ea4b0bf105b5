// SPDX-License-Identifier: MIT
// Recordings of whole programs: complete, played with the same outcome, and harmless when damaged.
#include <gtest/gtest.h>

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "compat/stream/call_memory.h"
#include "compat/stream/call_player.h"
#include "compat/stream/call_reader.h"
#include "compat/stream/played_frames.h"
#include "compat/stream/played_memory.h"
#include "openrt/rt.h"
#include "tests/stream/every_call.h"
#include "tests/stream/recorded_file.h"

using namespace smart::compat;

namespace {

constexpr PlayLimits kSmall{uint64_t(64) << 20, 1 << 16, 4, 8};

class Told final : public PlayPolicy {
public:
    void diverged(const Divergence& d) override {
        texts.push_back(std::to_string(d.call) + " " + d.function + ": " + d.text);
    }
    void frame(const PlayedFrame& frame) override { sizes.push_back(frame.width); }
    std::vector<std::string> texts;
    std::vector<uint32_t> sizes;
};

/// Plays with small limits, and leaves nothing behind. False: the stream was refused.
bool plays(std::span<const std::byte> stream) {
    bool isPlayed = false;
    {
        CallPlayer player(nullptr, kSmall);
        try {
            player.play(stream);
            player.finish();
            isPlayed = true;
        } catch (const StreamError&) {
        }
    }
    rtExit();
    return isPlayed;
}

/// Where each record begins.
std::vector<std::size_t> startsOf(std::span<const std::byte> stream) {
    std::vector<std::size_t> starts;
    for (std::span<const std::byte> rest = stream; !rest.empty();) {
        starts.push_back(stream.size() - rest.size());
        RecordHead head;
        takeRecord(rest, head);
    }
    return starts;
}

void repairChecksum(std::vector<std::byte>& stream, std::size_t start) {
    RecordHead head;
    std::memcpy(&head, stream.data() + start, sizeof head);
    constexpr std::size_t kChecked = offsetof(RecordHead, kind);
    head.checksum = checksumOf(std::span(stream).subspan(start + kChecked, head.bytes - kChecked));
    std::memcpy(stream.data() + start, &head, sizeof head);
}

/// In the calls of this name that have the old value; how many there are.
template <class T>
unsigned replaceFirstArgument(std::vector<std::byte>& stream, const char* name, T old, T value) {
    unsigned replaced = 0;
    CallReader reader;
    for (const std::size_t start : startsOf(stream)) {
        std::span<const std::byte> rest = std::span(stream).subspan(start);
        RecordHead head;
        const std::span<const std::byte> record = takeRecord(rest, head);
        if (head.kind == RecordKind::Start) reader.readStart(record);
        if (head.kind != RecordKind::Call) continue;
        CallRecord call;
        reader.readCall(record, call);
        if (std::strcmp(call.call->name, name) != 0 || call.arguments[0].value.as<T>() != old)
            continue;
        std::memcpy(stream.data() + start + sizeof head + 2, &value, sizeof value);
        repairChecksum(stream, start);
        ++replaced;
    }
    return replaced;
}

const std::vector<std::byte>& recordedProgram() {
    static const std::vector<std::byte> stream = recordingOf(RECORDED_PROGRAM);
    return stream;
}

std::string joined(const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& text : texts) all += text + "\n";
    return all;
}

} // namespace

TEST(CallTable, HasEveryExportedFunction) {
    std::ifstream file(VERSION_SCRIPT);
    std::set<std::string> exported;
    for (std::string word; file >> word;)
        if (word.starts_with("rt") && word.ends_with(';'))
            exported.insert(word.substr(0, word.size() - 1));
    ASSERT_GT(exported.size(), 600u);
    EXPECT_EQ(callTable().size(), exported.size());
    for (const std::string& function : exported)
        EXPECT_NE(findCall(function.c_str()), nullptr) << function;
    EXPECT_EQ(findCall("rtNothing"), nullptr);
}

TEST(CallStream, HoldsTheArgumentsOfEveryFunction) {
    const std::vector<std::byte> stream = recordingOf(EVERY_CALL_PROGRAM);
    ASSERT_FALSE(stream.empty());
    CallReader reader;
    std::map<std::string, unsigned> seen;
    static EveryCallMemory memory;
    for (std::span<const std::byte> rest = stream; !rest.empty();) {
        RecordHead head;
        const std::span<const std::byte> record = takeRecord(rest, head);
        if (head.kind == RecordKind::Start) reader.readStart(record);
        if (head.kind != RecordKind::Call) continue;
        CallRecord call;
        reader.readCall(record, call);
        CallValue expected[kMaxParameters + 1];
        fillArguments(*call.call, memory, expected);
        const bool isOwn = std::strcmp(call.call->name, "rtInit") == 0 ||
                           std::strcmp(call.call->name, "rtMakeCurrent") == 0;
        ++seen[call.call->name];
        const std::span<const CallParameter> parameters = parametersOf(*call.call);
        ASSERT_EQ(call.arguments.size(), parameters.size());
        for (std::size_t i = 0; i < parameters.size() && !isOwn; ++i) {
            const CallParameter& p = parameters[i];
            SCOPED_TRACE(std::string(call.call->name) + " " + p.name);
            if (p.kind != ValueKind::Pointer) {
                const auto all = expected[i].as<uint64_t>(),
                           got = call.arguments[i].value.as<uint64_t>();
                EXPECT_EQ(std::memcmp(&all, &got, bytesOf(p.kind)), 0);
                continue;
            }
            const uint64_t bytes = memoryBytes(*call.call, p, expected, {});
            const bool isGiven = expected[i].as<void*>() != nullptr;
            EXPECT_EQ(call.arguments[i].tag != PointerTag::Null,
                      isGiven || p.memory == Memory::None);
            if (call.arguments[i].tag != PointerTag::Bytes || p.memory == Memory::String) continue;
            ASSERT_EQ(call.arguments[i].bytes.size(), bytes);
            EXPECT_EQ(std::memcmp(call.arguments[i].bytes.data(), expected[i].as<void*>(), bytes),
                      0);
        }
    }
    for (const CallSignature& call : callTable()) EXPECT_GE(seen[call.name], 1u) << call.name;
    EXPECT_TRUE(plays(stream));
}

TEST(CallStream, ScaledImagesLieAsThePackStateSays) {
    const CallSignature& call = *findCall("rtuScaleImage");
    const std::span<const CallParameter> parameters = parametersOf(call);
    CallValue arguments[kMaxParameters + 1] = {};
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const std::string name = parameters[i].name;
        if (name == "wOut") arguments[i] = CallValue(RTsizei(3));
        if (name == "hOut") arguments[i] = CallValue(RTsizei(2));
        if (name == "format") arguments[i] = CallValue(RTenum(RT_RGB));
        if (name == "typeOut") arguments[i] = CallValue(RTenum(RT_UNSIGNED_BYTE));
    }
    const CallParameter& out = parameters.back();
    ASSERT_STREQ(out.name, "dataOut");
    ImageStores stores;
    EXPECT_EQ(memoryBytes(call, out, arguments, stores), 12u + 9);
    stores.pack.alignment = 1;
    EXPECT_EQ(memoryBytes(call, out, arguments, stores), 9u + 9);
    stores.pack = {8, 10, 2, 1}; // rows of 30 bytes are 32
    EXPECT_EQ(memoryBytes(call, out, arguments, stores), 2 * 32u + 6 + 9);
}

TEST(CallStream, EveryFunctionIsPlayedWithTheSameErrors) {
    const std::vector<std::byte> stream = recordingOf(EVERY_CALL_PROGRAM);
    Told told;
    {
        CallPlayer player(&told);
        player.play(stream);
        player.finish();
        EXPECT_GE(player.calls(), callTable().size());
    }
    EXPECT_EQ(joined(told.texts), "");
    rtExit();
}

TEST(CallStream, IsPlayedWithTheSameFramesAndErrors) {
    for (const char* argument : {(const char*)nullptr, "threads"}) {
        const std::vector<std::byte> stream = recordingOf(RECORDED_PROGRAM, argument);
        ASSERT_FALSE(stream.empty());
        Told told;
        CallPlayer player(&told);
        player.play(stream);
        player.finish();
        EXPECT_EQ(joined(told.texts), "");
        EXPECT_EQ(player.frames(), argument ? 6u : 5u);
        EXPECT_EQ(player.unequalFrames(), 0u);
        rtExit();
    }
}

TEST(CallStream, FramesInOneMemoryAreComparedHoweverTheyAreWaitedFor) {
    const std::pair<const char*, unsigned> ways[] = {
        {"finished", 6},  {"read", 6},      {"forwards", 6},        {"backwards", 6},
        {"elsewhere", 6}, {"not at all", 5}, {"another context", 5}, {"never", 0}};
    for (const auto& [way, frames] : ways) {
        SCOPED_TRACE(way);
        const std::vector<std::byte> stream = recordingOf(RECORDED_PROGRAM, way);
        ASSERT_FALSE(stream.empty());
        Told told;
        CallPlayer player(&told);
        player.play(stream);
        player.finish();
        EXPECT_EQ(joined(told.texts), "");
        EXPECT_EQ(player.frames(), frames);
        EXPECT_EQ(player.unequalFrames(), 0u);
        EXPECT_TRUE(player.hasRendered());
        rtExit();
    }
}

TEST(CallStream, AnotherColourIsAnotherFrame) {
    std::vector<std::byte> stream = recordedProgram();
    ASSERT_GT(replaceFirstArgument<RTubyte>(stream, "rtColor3ub", 255, 17), 0u);
    CallPlayer player;
    player.play(stream);
    player.finish();
    EXPECT_GT(player.unequalFrames(), 0u);
    rtExit();
}

TEST(CallStream, AnErrorThatDoesNotComeIsTold) {
    std::vector<std::byte> stream = recordedProgram();
    ASSERT_EQ(replaceFirstArgument<RTenum>(stream, "rtEnable", 0x7777, RT_LIGHTING), 1u);
    Told told;
    CallPlayer player(&told);
    player.play(stream);
    player.finish();
    EXPECT_NE(joined(told.texts).find("rtEnable: was recorded with"), std::string::npos);
    rtExit();
}

TEST(CallStream, ADamagedByteIsAlwaysFound) {
    const std::vector<std::byte>& stream = recordedProgram();
    ASSERT_FALSE(stream.empty());
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        std::vector<std::byte> damaged = stream;
        damaged[random() % damaged.size()] ^= std::byte(1u << random() % 8);
        EXPECT_FALSE(plays(damaged));
    }
}

TEST(CallStream, ACutOneIsPlayedToItsEndOrRefused) {
    const std::vector<std::byte>& stream = recordedProgram();
    const std::vector<std::size_t> starts = startsOf(stream);
    const std::set<std::size_t> whole(starts.begin(), starts.end());
    std::mt19937 random(2);
    for (int i = 0; i < 300; ++i) {
        const std::size_t cut = random() % stream.size();
        EXPECT_EQ(plays(std::span(stream).first(cut)), whole.contains(cut)) << cut;
        EXPECT_LE(bytesOfWholeRecords(std::span(stream).first(cut)), cut);
    }
}

TEST(CallStream, FramesThatAreNeverComparedTakeNoMemory) {
    constexpr uint64_t kKey = 1;
    static RTubyte pixels[4 * 16 * 16];
    rtInit(nullptr, nullptr);
    rtSetFrameBuffer(pixels, 16, 16, RT_RGBA_8);
    rtClear(RT_COLOR_BUFFER_BIT);
    PlayedFrames frames;
    const RTuint ended = rtQueueFrame();
    rtWaitFrame(ended);
    const std::size_t before = mallinfo2().uordblks;
    for (int i = 0; i < 100000; ++i) frames.queued(ended, {kKey});
    EXPECT_LT(mallinfo2().uordblks, before + 10000);

    rtSetFrameCallback([](RTuint, RTenum, RTint, RTint, RTsizei, RTsizei, void*) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }, nullptr);
    const RTuint slow = rtQueueFrame();
    frames.queued(slow, {kKey});
    frames.queued(ended, {kKey});
    frames.await(kKey);
    EXPECT_EQ(rtFrameStatus(slow), RTenum(RT_DONE));
    rtExit();
}

// Text ends where its copy does, and what was not recorded reads as zeros, whatever lay there.
TEST(CallStream, MemoryOfPlayedCallsIsZero) {
    constexpr std::size_t kBytes = 1000;
    const auto litter = [] {
        std::vector<std::vector<std::byte>> blocks;
        for (std::size_t bytes = CallArena::kLeast; bytes < kBytes + 100; bytes += 16)
            for (int i = 0; i < 12; ++i) blocks.emplace_back(bytes, std::byte(0xFF));
    };
    const auto isZero = [](const std::byte* memory, std::size_t bytes) {
        return std::all_of(memory, memory + bytes, [](std::byte b) { return b == std::byte(0); });
    };
    MemoryBudget budget(1 << 20);
    for (std::size_t length = 1; length < 40; ++length) {
        litter();
        CallArena arena(budget);
        EXPECT_TRUE(isZero(arena.allocate(kBytes), kBytes));
        const std::string text(length, 'x');
        const std::byte* const copy = arena.copy(std::as_bytes(std::span(text)));
        EXPECT_TRUE(isZero(copy + length, CallArena::kLeast - length)) << length;
        FrameBuffers buffers(budget);
        EXPECT_TRUE(isZero(buffers.memory(1, kBytes), kBytes));
    }
}

// Damage that a checksum hides: whatever the calls are then, nothing else happens.
TEST(CallStream, ForgedRecordsDoNoHarm) {
    const std::vector<std::byte>& stream = recordedProgram();
    const std::vector<std::size_t> starts = startsOf(stream);
    std::mt19937 random(3);
    unsigned refused = 0;
    for (int i = 0; i < 3000; ++i) {
        std::vector<std::byte> forged = stream;
        const std::size_t k = 1 + random() % (starts.size() - 1);
        const std::size_t end = k + 1 < starts.size() ? starts[k + 1] : stream.size();
        const std::size_t kind = starts[k] + offsetof(RecordHead, kind);
        for (unsigned n = 1 + random() % 3; n > 0; --n) {
            std::byte& byte = forged[kind + random() % (end - kind)];
            byte = random() % 2 ? std::byte(random()) : byte ^ std::byte(1u << random() % 8);
        }
        repairChecksum(forged, starts[k]);
        refused += !plays(forged);
    }
    EXPECT_GT(refused, 0u);
}
