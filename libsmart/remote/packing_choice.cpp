// SPDX-License-Identifier: MIT
#include "libsmart/remote/packing_choice.h"

#include <algorithm>

namespace smart {
namespace {

using namespace std::chrono_literals;

// Long enough not to be misled by what arrives together.
constexpr unsigned kSpanTiles = 16;
constexpr auto kSpanTime = 2ms;
constexpr unsigned kSpans = 8; ///< until the fastest ones are forgotten, twice

void average(double& mean, double value) {
    mean = mean == 0 ? value : mean + (value - mean) / 32;
}

} // namespace

void PackingChoice::worked(double seconds) {
    average(workSeconds_, seconds);
}

// The work is the same for each tile: what takes longer was interrupted.
void PackingChoice::packed(double seconds, std::size_t before, std::size_t after) {
    packSeconds_ = packSeconds_ == 0 ? seconds : std::min(packSeconds_ * 1.02, seconds);
    average(before_, double(before));
    average(after_, double(after));
}

void PackingChoice::arrived(uint64_t bytes, Clock::time_point now) {
    if (bytes <= arrived_) return;
    arrived_ = bytes;
    if (spanTiles_++ == 0) {
        spanBegin_ = bytes;
        spanStart_ = now;
        return;
    }
    if (spanTiles_ <= kSpanTiles || now - spanStart_ < kSpanTime) return;
    const double seconds = std::chrono::duration<double>(now - spanStart_).count();
    fastest_ = std::max(fastest_, double(bytes - spanBegin_) / seconds);
    if (++spans_ == kSpans) {
        fastestBefore_ = fastest_;
        fastest_ = 0;
        spans_ = 0;
    }
    spanBegin_ = bytes;
    spanStart_ = now;
    spanTiles_ = 1;
}

double PackingChoice::bytesPerSecond() const {
    return std::max(fastest_, fastestBefore_);
}

double PackingChoice::gain() const {
    const double line = bytesPerSecond();
    if (line == 0 || workSeconds_ == 0 || packSeconds_ == 0) return 0;
    const double plain = std::min(threads_ / workSeconds_, line / before_);
    const double packed = std::min(threads_ / (workSeconds_ + packSeconds_), line / after_);
    return packed / plain;
}

} // namespace smart
