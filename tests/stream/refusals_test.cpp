// SPDX-License-Identifier: MIT
// What a player says of each kind of recording that it does not play. All checksums are right.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "compat/stream/call_player.h"
#include "compat/stream/call_table.h"
#include "compat/stream/record_format.h"
#include "openrt/rt.h"

using namespace smart::compat;

namespace {

constexpr PlayLimits kSmall{uint64_t(1) << 20, 1 << 16, 4, 2};

/// Functions of a recording, by their numbers there.
enum : uint16_t { kFinish, kVertex, kUnknown };

void nothing(RecordWriter&) {}

class Recording {
public:
    using Content = std::function<void(RecordWriter&)>;

    Recording& record(RecordKind kind, const Content& content, uint16_t thread = 0) {
        RecordWriter writer;
        writer.begin(kind, 0, thread, 0);
        content(writer);
        const std::span<const std::byte> bytes = writer.end();
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
        return *this;
    }
    Recording& start(uint32_t byteOrder = kByteOrder, uint16_t version = kStreamVersion,
                     uint8_t pointer = sizeof(void*)) {
        return record(RecordKind::Start, [&](RecordWriter& w) {
            w.putBytes(kStreamMagic, sizeof kStreamMagic);
            w.put(byteOrder);
            w.put(version);
            w.put(pointer);
            w.putText("0.0.9");
            w.put(uint16_t(3));
            w.put(findCall("rtFinish")->fingerprint);
            w.put(findCall("rtVertex3fv")->fingerprint);
            w.put(uint32_t(0));
        });
    }
    /// A call, its arguments, and that there are no attachments.
    Recording& call(uint16_t function, const Content& arguments = nothing,
                    uint16_t thread = 0) {
        return record(
            RecordKind::Call,
            [&](RecordWriter& w) {
                w.put(function);
                arguments(w);
                w.put(AttachmentKind::None);
            },
            thread);
    }
    Recording& picture(uint64_t key, uint32_t width, uint32_t height, RTenum format,
                       uint64_t stride) {
        return record(RecordKind::Picture, [&](RecordWriter& w) {
            w.put(key);
            w.put(width);
            w.put(height);
            w.put(format);
            w.put(stride);
            w.put(uint64_t(0));
        });
    }
    /// What the player says of it; "" where it is played.
    std::string refusal() const {
        std::string text;
        {
            CallPlayer player(nullptr, kSmall);
            try {
                player.play(bytes_);
                player.finish();
            } catch (const StreamError& error) {
                text = error.what();
                EXPECT_THROW(player.play({}), StreamError) << "after an error";
            }
        }
        rtExit();
        return text;
    }

private:
    std::vector<std::byte> bytes_;
};

Recording started() {
    return Recording().start();
}

void putBytes(RecordWriter& w, uint64_t size) {
    w.put(PointerTag::Bytes);
    w.put(size);
    w.grow(size);
}

} // namespace

TEST(Refusals, NoneOfWhatIsInOrder) {
    EXPECT_EQ(started().refusal(), "");
    EXPECT_EQ(started().call(kFinish).refusal(), "");
    EXPECT_EQ(started().call(kVertex, [](RecordWriter& w) { putBytes(w, 12); }).refusal(), "");
    EXPECT_EQ(started().picture(1, 4, 4, RT_RGBA_8, 16).refusal(), "");
}

TEST(Refusals, OfTheStart) {
    EXPECT_EQ(Recording().record(RecordKind::Start,
                                 [](RecordWriter& w) { w.putBytes("a letter", 8); }).refusal(),
              "no recording of calls");
    EXPECT_EQ(Recording().start(0x04030201).refusal(),
              "recorded on a machine with another byte order");
    EXPECT_EQ(Recording().start(kByteOrder, kStreamVersion + 1).refusal(),
              "recorded in a format of another version");
    EXPECT_EQ(Recording().start(kByteOrder, kStreamVersion, 4).refusal(),
              "recorded on a machine with pointers of another size");
    EXPECT_EQ(started().start().refusal(), "the recording begins a second time");
    EXPECT_EQ(Recording().call(kFinish).refusal(), "the recording does not begin at its start");
}

TEST(Refusals, OfRecords) {
    EXPECT_EQ(started().record(RecordKind(9), [](RecordWriter&) {}).refusal(),
              "a record of a kind that there is not");
    EXPECT_EQ(started().record(RecordKind::Call, [](RecordWriter&) {}).refusal(),
              "a record ends before what it holds does");
    EXPECT_EQ(started().call(kFinish, [](RecordWriter& w) { w.put(AttachmentKind::None); }).refusal(),
              "a record is longer than its call");
    EXPECT_EQ(started().call(kFinish, [](RecordWriter& w) { w.put(AttachmentKind(7)); }).refusal(),
              "an attachment of a kind that there is not");
}

TEST(Refusals, OfFunctionsThatAreNotTheSame) {
    EXPECT_EQ(started().call(kUnknown).refusal(),
              "function 2 of OpenRT 0.0.9 is not the same in this library");
    EXPECT_EQ(started().call(3).refusal(),
              "function 3 of OpenRT 0.0.9 is not the same in this library");
}

TEST(Refusals, OfPointers) {
    EXPECT_EQ(started().call(kVertex, [](RecordWriter& w) { w.put(PointerTag(9)); }).refusal(),
              "a pointer of a kind that there is not");
    EXPECT_EQ(started().call(kVertex, [](RecordWriter& w) { putBytes(w, 8); }).refusal(),
              "rtVertex3fv reads more than was recorded");
    EXPECT_EQ(started().call(kVertex, [](RecordWriter& w) {
                  for (int nesting = 0; nesting < 2; ++nesting) {
                      w.put(PointerTag::Pieces);
                      w.put(uint32_t(1));
                  }
              }).refusal(),
              "pointers in pointers in pointers");
}

TEST(Refusals, OfVertexArrays) {
    const auto refusal = [](uint8_t kind, RTenum type, RTint size, uint64_t elements) {
        return started().call(kFinish, [&](RecordWriter& w) {
            w.put(AttachmentKind::VertexArray);
            w.put(kind);
            w.put(type);
            w.put(size);
            w.put(uint32_t(0));
            w.put(uint64_t(0));
            w.put(elements);
            w.put(uint64_t(24)); // bytes
            w.grow(24);
        }).refusal();
    };
    constexpr uint8_t kColors = 2, kNormals = 4;
    EXPECT_EQ(refusal(99, RT_FLOAT, 3, 2), "a vertex array of a kind that there is not");
    EXPECT_EQ(refusal(kColors, RT_ALL_ATTRIB_BITS, 3, 2), "a vertex array of a kind that there is not");
    EXPECT_EQ(refusal(kColors, RT_FLOAT, 5, 2), "a vertex array of a kind that there is not");
    EXPECT_EQ(refusal(kNormals, RT_FLOAT, 4, 2), "a vertex array of a size that there is not");
    EXPECT_EQ(refusal(kColors, RT_FLOAT, 3, 3),
              "a vertex array has another size than its elements");
    EXPECT_EQ(refusal(kColors, RT_FLOAT, 3, 2), "rtFinish draws no vertex arrays");
}

TEST(Refusals, OfOutcomes) {
    const Recording::Content outcome = [](RecordWriter& w) {
        w.put(uint16_t(kFinish));
        w.put(RTenum(RT_NO_ERROR));
        w.put(uint64_t(0)); // result
        w.put(uint64_t(0)); // hash
        w.put(uint32_t(0)); // names
    };
    EXPECT_EQ(started().record(RecordKind::Outcome, outcome).refusal(),
              "an outcome without its call");
    EXPECT_EQ(started().call(kVertex, [](RecordWriter& w) { putBytes(w, 12); })
                  .record(RecordKind::Outcome, outcome).refusal(),
              "an outcome without its call");
}

TEST(Refusals, OfPictures) {
    EXPECT_EQ(started().picture(1, 4, 4, RT_TRIANGLES, 16).refusal(),
              "a picture of no format or size");
    EXPECT_EQ(started().picture(1, 4, 0, RT_RGBA_8, 16).refusal(),
              "a picture of no format or size");
    EXPECT_EQ(started().picture(1, 4, 4, RT_RGBA_8, 15).refusal(),
              "a picture of no format or size");
    EXPECT_EQ(started().picture(1, 1 << 10, 1 << 10, RT_RGBA_8, 1 << 12).refusal(),
              "a picture has more pixels than the player allows");
}

TEST(Refusals, OfThreads) {
    Recording recording = started();
    for (uint16_t thread = 0; thread < 3; ++thread) recording.call(kFinish, nothing, thread);
    EXPECT_EQ(recording.refusal(), "");
    recording.call(kFinish, nothing, 3);
    EXPECT_EQ(recording.refusal(), "the recorded program has more than 2 threads");
}
