// SPDX-License-Identifier: MIT
// What stands between the functions that programs call and their definitions.
#pragma once

#include <atomic>
#include <cstdint>
#include <type_traits>

#include "compat/stream/call_table.h"

namespace smart::compat {

/// 0: no sink. All that a call costs where nothing is recorded is a look at this.
extern std::atomic<int> recordingState;

inline bool isRecording() noexcept {
    return recordingState.load(std::memory_order_relaxed) != 0;
}

/// A call that programs make: recorded here, and what came of it by end().
class CallRecording {
public:
    CallRecording(uint16_t number, const CallValue* arguments) noexcept;
    CallRecording(const CallRecording&) = delete;
    CallRecording& operator=(const CallRecording&) = delete;
    ~CallRecording();
    void end(CallValue result) noexcept;

private:
    uint64_t hashOfPixels() const;
    void recordOutcome(CallValue result) const;
    void recordPictures() const;

    const CallSignature& call_;
    const CallValue* arguments_;
    bool isActive_ = false;
    uint8_t level_ = 0;
    uint64_t errorsBefore_ = 0;
    uint32_t latestBefore_ = 0; ///< FrameDriver::latestFrame()
};

template <auto function, class... Arguments>
[[gnu::noinline]] auto recordedCall(uint16_t number, Arguments... arguments) {
    const CallValue values[sizeof...(Arguments) + 1] = {CallValue(arguments)..., CallValue()};
    CallRecording call(number, values);
    if constexpr (std::is_void_v<decltype(function(arguments...))>) {
        function(arguments...);
        call.end(CallValue());
    } else {
        const auto result = function(arguments...);
        call.end(CallValue(result));
        return result;
    }
}

} // namespace smart::compat
