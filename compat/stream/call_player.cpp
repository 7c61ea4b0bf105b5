// SPDX-License-Identifier: MIT
#include "compat/stream/call_player.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "compat/stream/call_reader.h"
#include "compat/stream/played_arguments.h"
#include "compat/stream/played_arrays.h"
#include "compat/stream/played_frames.h"
#include "compat/stream/played_memory.h"
#include "compat/stream/player_threads.h"
#include "compat/stream/utility_objects.h"
#include "openrt/rt.h"
#include "openrt/rts.h"
#include "openrt/rtu.h"

namespace smart::compat {

namespace {

/// A call that was made, until it is known what came of it when it was recorded.
struct Pending {
    const CallSignature* call;
    uint64_t number;
    uint32_t context;
    RTenum error;
    bool isMade; ///< and not left out
    CallValue result;
    uint64_t hash; ///< of pixels that were read
    std::vector<RTuint> names;
};

bool isCall(const CallSignature& call, const char* name) {
    return std::strcmp(call.name, name) == 0;
}

std::string errorName(RTenum error) {
    const RTubyte* const text = rtuErrorString(error);
    return text ? reinterpret_cast<const char*>(text) : "error " + std::to_string(error);
}

void RTAPIENTRY ignoreFrame(RTuint, RTenum, RTint, RTint, RTsizei, RTsizei, void*) {}
void RTAPIENTRY ignore() {}
void RTAPIENTRY ignoreToken(RTenum) {}
void RTAPIENTRY ignoreTokenOf(RTenum, void*) {}
void RTAPIENTRY ignoreFlag(RTboolean) {}
void RTAPIENTRY ignoreFlagOf(RTboolean, void*) {}
void RTAPIENTRY ignoreVertex(void*) {}
void RTAPIENTRY ignoreVertexOf(void*, void*) {}
void RTAPIENTRY combine(RTdouble*, void**, RTfloat*, void** out) {
    *out = nullptr;
}
void RTAPIENTRY combineOf(RTdouble*, void**, RTfloat*, void** out, void*) {
    *out = nullptr;
}

/// The players that errors may be told to: contexts may live longer.
struct Listeners {
    std::mutex mutex;
    std::set<void*> players;
};
Listeners& listeners() {
    static Listeners instance;
    return instance;
}

/// A function that does nothing for what the recorded program's function heard of: the calls that
/// that made are recorded.
RTUfuncptr functionFor(RTenum which) {
    const auto as = [](auto* function) { return reinterpret_cast<RTUfuncptr>(function); };
    switch (which) {
        case RTU_TESS_BEGIN:
        case RTU_TESS_ERROR:
            return as(&ignoreToken);
        case RTU_TESS_BEGIN_DATA:
        case RTU_TESS_ERROR_DATA:
            return as(&ignoreTokenOf);
        case RTU_TESS_EDGE_FLAG:
            return as(&ignoreFlag);
        case RTU_TESS_EDGE_FLAG_DATA:
            return as(&ignoreFlagOf);
        case RTU_TESS_VERTEX:
        case RTU_TESS_END_DATA:
            return as(&ignoreVertex);
        case RTU_TESS_VERTEX_DATA:
            return as(&ignoreVertexOf);
        case RTU_TESS_COMBINE:
            return as(&combine);
        case RTU_TESS_COMBINE_DATA:
            return as(&combineOf);
        default:
            return &ignore;
    }
}

} // namespace

class CallPlayer::Implementation {
public:
    Implementation(PlayPolicy* policy, const PlayLimits& limits)
        : policy_(policy ? *policy : everything_),
          limits_(limits),
          budget_(limits.memory),
          buffers_(budget_),
          threads_(std::make_unique<PlayerThreads>(limits.threads)) {
        const std::lock_guard lock(listeners().mutex);
        listeners().players.insert(this);
    }
    ~Implementation() {
        threads_.reset(); // and what was current there
        // Frames in flight go to memory of the player's.
        for (const RTcontext context : heard_) rtDestroyContext(context);
        const std::lock_guard lock(listeners().mutex);
        listeners().players.erase(this);
    }
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;

    void play(std::span<const std::byte> records) {
        if (hasFailed_) throw StreamError("nothing can be played after an error");
        hasFailed_ = true; // unless this gets to its end
        while (!records.empty()) {
            RecordHead head;
            const std::span<const std::byte> record = takeRecord(records, head);
            playRecord(head, record);
        }
        hasFailed_ = false;
    }

    void finish() {
        for (auto& [thread, pending] : pending_) settle(thread, 0);
    }

    uint64_t calls = 0, frames = 0, unequalFrames = 0, divergences = 0;
    bool hasRendered = false;

private:
    void playRecord(const RecordHead& head, std::span<const std::byte> record) {
        if (head.kind == RecordKind::Start) {
            if (reader_.isStarted()) throw StreamError("the recording begins a second time");
            return reader_.readStart(record);
        }
        if (!reader_.isStarted()) throw StreamError("the recording does not begin at its start");
        switch (head.kind) {
            case RecordKind::Call:
                reader_.readCall(record, record_);
                settle(head.thread, head.depth);
                threads_->run(head.thread, [&] { playCall(head); });
                break;
            case RecordKind::Outcome:
                compare(head, reader_.readOutcome(record));
                break;
            case RecordKind::Picture:
                comparePicture(CallReader::readPicture(record));
                break;
            default:
                throw StreamError("a record of a kind that there is not");
        }
    }

    void playCall(const RecordHead& head) {
        const CallSignature& call = *record_.call;
        ++calls;
        Pending pending{&call, calls, head.context, RT_NO_ERROR, false, {}, 0, {}};
        meetContext(head.context);
        if (policy_.plays(call)) make(head.context, pending);
        pending_[head.thread].push_back(std::move(pending));
    }

    /// The context of this name is the one that is current here now.
    void meetContext(uint32_t recorded) {
        const RTcontext now = rtGetCurrentContext();
        if (recorded == 0 || !now) return;
        names_.add(Meaning::Context, 0, recorded, reinterpret_cast<uintptr_t>(now));
        listen();
    }

    /// Hears of the errors of the current context.
    void listen() {
        const RTcontext now = rtGetCurrentContext();
        if (!now || !heard_.insert(now).second) return;
        rtErrorCallback(&Implementation::hear, this);
    }
    static void RTAPIENTRY hear(RTenum code, const char*, const char*, void* user) {
        const std::lock_guard lock(listeners().mutex);
        if (!listeners().players.contains(user)) return;
        auto& player = *static_cast<Implementation*>(user);
        if (player.isMade_ && player.error_ == RT_NO_ERROR) player.error_ = code;
    }

    void make(uint32_t context, Pending& pending) {
        const CallSignature& call = *record_.call;
        CallArena arena(budget_);
        PlayedArguments arguments;
        makeArguments(record_, context, names_, arena, arguments);
        if (arguments.lacksMemory) return;
        PictureTargets& targets = targets_[rtGetCurrentContext()];
        prepare(call, arguments, targets);
        if (record_.hasMapped) writeMapped(arguments);
        error_ = RT_NO_ERROR;
        isMade_ = true;
        makeCall(call, arguments, arena, pending.result);
        isMade_ = false;
        if (isCall(call, "rtuNewQuadric")) utilityObjects_.made(pending.result.as<RTUquadric*>());
        if (isCall(call, "rtuNewTess")) utilityObjects_.made(pending.result.as<RTUtesselator*>());
        pending.isMade = true;
        pending.error = error_;
        follow(call, arguments, targets, pending);
        if (error_ == RT_NO_ERROR) afterwards(call, arguments, targets, pending);
        listen();
    }

    /// Which frames are in flight now.
    void follow(const CallSignature& call, const PlayedArguments& arguments,
                const PictureTargets& targets, const Pending& pending) {
        const RTcontext now = rtGetCurrentContext();
        hasRendered |= pending.error == RT_NO_ERROR &&
                       (call.resultMeaning == Meaning::Frame || isCall(call, "rtRender") ||
                        isCall(call, "rtStartRendering"));
        if (call.resultMeaning == Meaning::Frame)
            frames_.queued(pending.result.as<RTuint>(), targets.keys());
        else if (isCall(call, "rtStartRendering") && pending.error == RT_NO_ERROR)
            frames_.started(now, targets.keys());
        else if (isCall(call, "rtDestroyContext"))
            frames_.ended(arguments.values[0].as<RTcontext>());
        else if (isCall(call, "rtEndRendering") || isCall(call, "rtRender") ||
                 isCall(call, "rtFinish") || call.kind == CallKind::Read)
            frames_.ended(now);
    }

    void makeCall(const CallSignature& call, PlayedArguments& arguments, CallArena& arena,
                  CallValue& result) {
        if (isCall(call, "rtErrorCallback")) return rtErrorCallback(&Implementation::hear, this);
        if (isCall(call, "rtArrayElement") && !record_.arrays.empty())
            return playElement(record_, arena);
        if (!record_.arrays.empty()) return playDrawing(record_, arguments.values, arena);
        invokeCall(call, arguments.values, result);
    }

    void prepare(const CallSignature& call, PlayedArguments& a, const PictureTargets& targets) {
        CallValue* const v = a.values;
        const auto has = [&](std::size_t i) {
            return record_.arguments[i].tag != PointerTag::Null;
        };
        const auto key = [&](std::size_t i) { return record_.arguments[i].value.as<uint64_t>(); };
        if (isCall(call, "rtSetFrameBuffer")) {
            PictureTargets::checkSize(v[1].as<RTuint>(), v[2].as<RTuint>(), limits_.pixels);
            if (has(0))
                v[0] = CallValue(
                    targets.frameBuffer(buffers_, key(0), v[1].as<RTuint>(), v[2].as<RTuint>()));
        } else if (isCall(call, "rtSetAuxBuffer")) {
            if (has(1)) v[1] = CallValue(targets.auxBuffer(buffers_, key(1), v[0].as<RTenum>()));
        } else if (isCall(call, "rtViewport")) {
            const auto side = [&](std::size_t i) {
                return uint64_t(std::max(v[i].as<RTint>(), 0));
            };
            PictureTargets::checkSize(side(0) + side(2), side(1) + side(3), limits_.pixels);
        } else if (isCall(call, "rtSamples")) {
            if (v[0].as<RTuint>() > limits_.samples && v[0].as<RTuint>() <= 4096)
                throw StreamError("more samples of a pixel than the player allows");
        } else if (isCall(call, "rtBufferData")) {
            const auto size = v[1].as<RTsizeiptr>();
            if (size > 0 && uint64_t(size) > limits_.memory)
                throw StreamError("a buffer is larger than the player allows");
        } else if (isCall(call, "rtTexImage2D") &&
                   v[0].as<RTenum>() != RT_PROXY_TEXTURE_2D) {
            const auto side = [&](std::size_t i) {
                return uint64_t(std::max(v[i].as<RTint>(), 0));
            };
            PictureTargets::checkSize(side(3), side(4), limits_.pixels);
        } else if (isCall(call, "rtRegisterShaderClass")) {
            prepareClass(v[0]);
        } else if (isCall(call, "rtSetFrameCallback")) {
            if (has(0)) v[0] = CallValue(&ignoreFrame);
        } else if (isCall(call, "rtuTessCallback") || isCall(call, "rtuQuadricCallback")) {
            if (has(2)) v[2] = CallValue(functionFor(v[1].as<RTenum>()));
        } else if (isCall(call, "rtuDeleteQuadric")) {
            names_.remove(Meaning::Quadric, key(0));
            utilityObjects_.deleted(v[0].as<RTUquadric*>());
        } else if (isCall(call, "rtuDeleteTess")) {
            names_.remove(Meaning::Tessellator, key(0));
            utilityObjects_.deleted(v[0].as<RTUtesselator*>());
        }
    }

    void prepareClass(CallValue& descriptor) {
        static const RTshaderclass kWrong{};
        const RecordedArgument& argument = record_.arguments[0];
        if (argument.tag == PointerTag::Null) return;
        descriptor = CallValue(&kWrong);
        if (argument.tag != PointerTag::Bytes) return;
        const auto* const text = reinterpret_cast<const char*>(argument.bytes.data());
        const std::string name(text, strnlen(text, argument.bytes.size()));
        const RTshaderclass* const known = policy_.shaderClass(name);
        if (!known)
            throw StreamError("the recorded program registered the shader class '" + name +
                              "', which is not known here");
        descriptor = CallValue(known);
    }

    void writeMapped(const PlayedArguments& arguments) const {
        const auto target = arguments.values[0].as<RTenum>();
        void* memory = nullptr;
        RTint size = 0;
        rtGetBufferPointerv(target, RT_BUFFER_MAP_POINTER, &memory);
        rtGetBufferParameteriv(target, RT_BUFFER_SIZE, &size);
        if (memory && size < 0x7FFFFFFF && record_.mapped.size() <= std::size_t(size))
            std::memcpy(memory, record_.mapped.data(), record_.mapped.size());
    }

    void afterwards(const CallSignature& call, const PlayedArguments& a, PictureTargets& targets,
                    Pending& pending) {
        const CallValue* const v = a.values;
        const auto key = [&](std::size_t i) { return record_.arguments[i].value.as<uint64_t>(); };
        if (isCall(call, "rtSetFrameBuffer")) {
            targets.setFrameBuffer(buffers_, key(0), v[1].as<RTuint>(), v[2].as<RTuint>(),
                                   v[3].as<RTenum>());
        } else if (isCall(call, "rtFrameBufferStride")) {
            targets.setStride(buffers_, v[0].as<RTsizei>());
        } else if (isCall(call, "rtSetAuxBuffer")) {
            targets.setAuxBuffer(v[0].as<RTenum>(), v[1].as<void*>() ? key(1) : 0,
                                 v[2].as<RTuint>());
        } else if (isCall(call, "rtViewport")) {
            const auto side = [&](std::size_t i) {
                return uint64_t(std::max(v[i].as<RTint>(), 0));
            };
            targets.setLargest(buffers_, (side(0) + side(2)) * (side(1) + side(3)));
        } else if (isCall(call, "rtInterleavedArrays")) {
            forgetInterleaved();
        } else if (isCall(call, "rtExit")) {
            names_.forgetProcess();
            frames_ = {};
            heard_.clear();
        } else if (call.yield == Yield::Names) {
            const auto n = v[0].as<RTsizei>();
            const auto* const names = v[1].as<const RTuint*>();
            if (n > 0 && names) pending.names.assign(names, names + n);
        } else if (call.yield == Yield::Pixels && v[6].as<void*>()) {
            const ImageRows rows = rowsOfReadPixels(call, v, imageStores());
            pending.hash =
                hashOfRows(v[6].as<const std::byte*>() + rows.offset, std::size_t(rows.rowBytes),
                           std::size_t(rows.stride), rows.rows);
        }
    }

    /// rtInterleavedArrays made offsets of NULL: pointers that are none of ours.
    static void forgetInterleaved() {
        const auto value = [](RTenum name) {
            RTint number = 0;
            rtGetIntegerv(name, &number);
            return number;
        };
        if (value(RT_ARRAY_BUFFER_BINDING) != 0) return;
        rtVertexPointer(value(RT_VERTEX_ARRAY_SIZE), RTenum(value(RT_VERTEX_ARRAY_TYPE)),
                        value(RT_VERTEX_ARRAY_STRIDE), nullptr);
        rtTexCoordPointer(value(RT_TEXTURE_COORD_ARRAY_SIZE),
                          RTenum(value(RT_TEXTURE_COORD_ARRAY_TYPE)),
                          value(RT_TEXTURE_COORD_ARRAY_STRIDE), nullptr);
        rtColorPointer(value(RT_COLOR_ARRAY_SIZE), RTenum(value(RT_COLOR_ARRAY_TYPE)),
                       value(RT_COLOR_ARRAY_STRIDE), nullptr);
        rtNormalPointer(RTenum(value(RT_NORMAL_ARRAY_TYPE)), value(RT_NORMAL_ARRAY_STRIDE),
                        nullptr);
    }

    /// A thread's calls from this depth on have no outcome: they had no error.
    void settle(uint16_t thread, std::size_t depth) {
        std::vector<Pending>& calls_ = pending_[thread];
        while (calls_.size() > depth) {
            const Pending& pending = calls_.back();
            if (pending.isMade && pending.error != RT_NO_ERROR)
                diverge(pending, "fails now: " + errorName(pending.error));
            calls_.pop_back();
        }
    }

    void compare(const RecordHead& head, const OutcomeRecord& outcome) {
        settle(head.thread, std::size_t(head.depth) + 1);
        std::vector<Pending>& calls_ = pending_[head.thread];
        if (calls_.size() != std::size_t(head.depth) + 1 || calls_.back().call != outcome.call)
            throw StreamError("an outcome without its call");
        const Pending pending = std::move(calls_.back());
        calls_.pop_back();
        if (!pending.isMade) return;
        if (outcome.error != pending.error)
            return diverge(pending, "was recorded with " + errorName(outcome.error) + ", now " +
                                        errorName(pending.error));
        const CallSignature& call = *pending.call;
        if (call.resultMeaning == Meaning::Name || call.comparesResult) {
            if (integerOf(call.result, outcome.result) != integerOf(call.result, pending.result))
                diverge(pending, "has another result than recorded");
        } else if (call.resultMeaning != Meaning::Plain && outcome.error == RT_NO_ERROR) {
            names_.add(call.resultMeaning, pending.context, outcome.result.as<uint64_t>(),
                       pending.result.as<uint64_t>());
        }
        if (outcome.hash != 0 && outcome.hash != pending.hash)
            diverge(pending, "reads other pixels than recorded");
        if (outcome.names != pending.names) diverge(pending, "makes other names than recorded");
    }

    void comparePicture(const PictureRecord& picture) {
        const std::size_t pixel = bytesOfFrameBufferPixel(picture.format);
        const uint64_t row = uint64_t(picture.width) * pixel;
        PictureTargets::checkSize(std::max<uint64_t>(picture.width, picture.stride / 16),
                                  picture.height, limits_.pixels);
        if (pixel == 0 || picture.height == 0 || picture.stride < row)
            throw StreamError("a picture of no format or size");
        const uint64_t bytes = picture.stride * (picture.height - 1) + row;
        const std::byte* const pixels = buffers_.find(picture.key, bytes);
        if (!pixels) return;
        frames_.await(picture.key);
        PlayedFrame frame{++frames,
                          picture.width,
                          picture.height,
                          picture.format,
                          std::size_t(picture.stride),
                          pixels,
                          hashOfRows(pixels, std::size_t(row), std::size_t(picture.stride),
                                     picture.height) == picture.hash};
        unequalFrames += !frame.isEqual;
        policy_.frame(frame);
    }

    void diverge(const Pending& pending, std::string text) {
        ++divergences;
        policy_.diverged({pending.number, pending.call->name, std::move(text)});
    }

    PlayPolicy everything_;
    PlayPolicy& policy_;
    PlayLimits limits_;
    MemoryBudget budget_;
    FrameBuffers buffers_;
    PlayedFrames frames_;
    CallReader reader_;
    CallRecord record_;
    PlayedNames names_;
    std::map<RTcontext, PictureTargets> targets_;
    std::map<uint16_t, std::vector<Pending>> pending_; ///< by thread; each during the one before
    std::set<RTcontext> heard_;
    UtilityObjects utilityObjects_;
    RTenum error_ = RT_NO_ERROR; ///< the first of the call under way
    bool isMade_ = false;
    bool hasFailed_ = false;
    std::unique_ptr<PlayerThreads> threads_;
};

CallPlayer::CallPlayer(PlayPolicy* policy, const PlayLimits& limits)
    : implementation_(std::make_unique<Implementation>(policy, limits)) {}
CallPlayer::~CallPlayer() = default;

void CallPlayer::play(std::span<const std::byte> wholeRecords) {
    implementation_->play(wholeRecords);
}
void CallPlayer::finish() {
    implementation_->finish();
}
uint64_t CallPlayer::calls() const {
    return implementation_->calls;
}
uint64_t CallPlayer::frames() const {
    return implementation_->frames;
}
bool CallPlayer::hasRendered() const {
    return implementation_->hasRendered;
}
uint64_t CallPlayer::unequalFrames() const {
    return implementation_->unequalFrames;
}
uint64_t CallPlayer::divergences() const {
    return implementation_->divergences;
}

} // namespace smart::compat
