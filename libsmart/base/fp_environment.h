// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>

#if defined(__SSE2__)
#include <xmmintrin.h>
#elif !defined(__aarch64__)
#include <cfenv>
#endif

namespace smart {

/// While it lives, this thread computes as IEEE 754 has it by default: rounding to nearest,
/// subnormal numbers kept, no exception trapped. Afterwards everything is as found, sticky flags
/// included. Wherever the application's own thread runs code whose results must not depend on
/// what the application did to its floating-point environment.
class FpEnvironment {
public:
    FpEnvironment() noexcept {
        save();
        std::atomic_signal_fence(std::memory_order_seq_cst);
    }
    ~FpEnvironment() {
        std::atomic_signal_fence(std::memory_order_seq_cst);
        restore();
    }
    FpEnvironment(const FpEnvironment&) = delete;
    FpEnvironment& operator=(const FpEnvironment&) = delete;

private:
#if defined(__SSE2__)
    void save() noexcept {
        saved_ = _mm_getcsr();
        _mm_setcsr(0x1F80); // all masked, nearest, neither FTZ nor DAZ, no flag raised
    }
    void restore() noexcept {
        _mm_setcsr(saved_);
    }
    uint32_t saved_;
#elif defined(__aarch64__)
    void save() noexcept {
        const uint64_t standard = 0;
        asm volatile("mrs %0, fpcr" : "=r"(control_));
        asm volatile("mrs %0, fpsr" : "=r"(status_));
        asm volatile("msr fpcr, %0" : : "r"(standard));
    }
    void restore() noexcept {
        asm volatile("msr fpcr, %0" : : "r"(control_));
        asm volatile("msr fpsr, %0" : : "r"(status_));
    }
    uint64_t control_, status_;
#else
    void save() noexcept {
        std::fegetenv(&saved_);
        std::fesetenv(FE_DFL_ENV);
    }
    void restore() noexcept {
        std::fesetenv(&saved_);
    }
    std::fenv_t saved_;
#endif
};

} // namespace smart
