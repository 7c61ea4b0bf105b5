// SPDX-License-Identifier: MIT
// The few names that the kernels need, over Highway: one group of rays as a value, 16 for packets
// and 1 for single rays, with the same arithmetic in each lane. A group of 16 takes as many
// registers as the instruction set needs; what a lane computes does not depend on it. Where there
// may be less than 16 of something, groups of kRegisterLanes take one register each.
#pragma once

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "libsmart/kernel/packet.h"

#ifndef SMART_ISA
#error "compiled once for each instruction set, with its name in SMART_ISA"
#endif
#ifdef __FAST_MATH__
#error "the kernels rely on IEEE arithmetic"
#endif

namespace smart::SMART_ISA {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<float, kPacketSize>;
using WordTag = hn::RebindToUnsigned<Tag>;
inline constexpr int kRegisterLanes = int(hn::MaxLanes(Tag()));
template <int N>
inline constexpr int kRegisters = N / kRegisterLanes; ///< of a group of N, whole registers

// Groups are copied register by register: left to itself, a compiler may copy one in portions that
// are smaller than a register, and then loads of whole registers wait until all are written.

/// Which lanes; bit i of bits() is lane i.
template <int N>
struct Mask {
    hn::Mask<Tag> m[kRegisters<N>];

    Mask() = default;
    Mask(const Mask& a) { *this = a; }
    Mask& operator=(const Mask& a) {
        for (int i = 0; i < kRegisters<N>; ++i) m[i] = a.m[i];
        return *this;
    }
    uint32_t bits() const {
        uint64_t all = 0;
        for (int i = 0; i < kRegisters<N>; ++i) {
            uint64_t lanes = 0;
            hn::StoreMaskBits(Tag(), m[i], reinterpret_cast<uint8_t*>(&lanes));
            all |= lanes << (i * kRegisterLanes);
        }
        return uint32_t(all);
    }
    bool any() const {
        hn::Mask<Tag> some = m[0];
        for (int i = 1; i < kRegisters<N>; ++i) some = hn::Or(some, m[i]);
        return !hn::AllFalse(Tag(), some);
    }
    static Mask fromBits(uint32_t bits) {
        Mask r;
        for (int i = 0; i < kRegisters<N>; ++i) {
            const uint64_t lanes = bits >> (i * kRegisterLanes);
            r.m[i] = hn::LoadMaskBits(Tag(), reinterpret_cast<const uint8_t*>(&lanes));
        }
        return r;
    }
};

/// One float a lane.
template <int N>
struct Real {
    hn::Vec<Tag> v[kRegisters<N>];

    Real() = default;
    Real(const Real& a) { *this = a; }
    Real& operator=(const Real& a) {
        for (int i = 0; i < kRegisters<N>; ++i) v[i] = a.v[i];
        return *this;
    }
    explicit Real(float x) {
        for (int i = 0; i < kRegisters<N>; ++i) v[i] = hn::Set(Tag(), x);
    }
    static Real load(const float* aligned) {
        Real r;
        for (int i = 0; i < kRegisters<N>; ++i)
            r.v[i] = hn::Load(Tag(), aligned + i * kRegisterLanes);
        return r;
    }
    static Real loadUnaligned(const float* p) {
        Real r;
        for (int i = 0; i < kRegisters<N>; ++i)
            r.v[i] = hn::LoadU(Tag(), p + i * kRegisterLanes);
        return r;
    }
    void store(float* aligned) const {
        for (int i = 0; i < kRegisters<N>; ++i)
            hn::Store(v[i], Tag(), aligned + i * kRegisterLanes);
    }
    void storeUnaligned(float* p) const {
        for (int i = 0; i < kRegisters<N>; ++i) hn::StoreU(v[i], Tag(), p + i * kRegisterLanes);
    }
};

/// One unsigned word a lane; kept, not computed with.
template <int N>
struct Word {
    hn::Vec<WordTag> v[kRegisters<N>];

    Word() = default;
    Word(const Word& a) { *this = a; }
    Word& operator=(const Word& a) {
        for (int i = 0; i < kRegisters<N>; ++i) v[i] = a.v[i];
        return *this;
    }
    explicit Word(uint32_t x) {
        for (int i = 0; i < kRegisters<N>; ++i) v[i] = hn::Set(WordTag(), x);
    }
    static Word load(const uint32_t* aligned) {
        Word r;
        for (int i = 0; i < kRegisters<N>; ++i)
            r.v[i] = hn::Load(WordTag(), aligned + i * kRegisterLanes);
        return r;
    }
    static Word loadUnaligned(const uint32_t* p) {
        Word r;
        for (int i = 0; i < kRegisters<N>; ++i)
            r.v[i] = hn::LoadU(WordTag(), p + i * kRegisterLanes);
        return r;
    }
    void store(uint32_t* aligned) const {
        for (int i = 0; i < kRegisters<N>; ++i)
            hn::Store(v[i], WordTag(), aligned + i * kRegisterLanes);
    }
};

#define SMART_LANEWISE(Result, name, field, expression)                                  \
    template <int N>                                                                     \
    inline Result<N> name(const Real<N>& a, const Real<N>& b) {                          \
        Result<N> r;                                                                     \
        for (int i = 0; i < kRegisters<N>; ++i) r.field[i] = expression(a.v[i], b.v[i]); \
        return r;                                                                        \
    }
SMART_LANEWISE(Real, operator+, v, hn::Add)
SMART_LANEWISE(Real, operator-, v, hn::Sub)
SMART_LANEWISE(Real, operator*, v, hn::Mul)
SMART_LANEWISE(Real, operator/, v, hn::Div)
SMART_LANEWISE(Real, min, v, hn::Min)
SMART_LANEWISE(Real, max, v, hn::Max)
SMART_LANEWISE(Mask, operator<, m, hn::Lt)
SMART_LANEWISE(Mask, operator<=, m, hn::Le)
SMART_LANEWISE(Mask, operator>, m, hn::Gt)
SMART_LANEWISE(Mask, operator>=, m, hn::Ge)
SMART_LANEWISE(Mask, operator==, m, hn::Eq)
SMART_LANEWISE(Mask, operator!=, m, hn::Ne)
#undef SMART_LANEWISE

template <int N>
inline Mask<N> operator&(const Mask<N>& a, const Mask<N>& b) {
    Mask<N> r;
    for (int i = 0; i < kRegisters<N>; ++i) r.m[i] = hn::And(a.m[i], b.m[i]);
    return r;
}
template <int N>
inline Mask<N> operator|(const Mask<N>& a, const Mask<N>& b) {
    Mask<N> r;
    for (int i = 0; i < kRegisters<N>; ++i) r.m[i] = hn::Or(a.m[i], b.m[i]);
    return r;
}
/// a without b
template <int N>
inline Mask<N> andNot(const Mask<N>& a, const Mask<N>& b) {
    Mask<N> r;
    for (int i = 0; i < kRegisters<N>; ++i) r.m[i] = hn::AndNot(b.m[i], a.m[i]);
    return r;
}
template <int N>
inline Real<N> select(const Mask<N>& m, const Real<N>& a, const Real<N>& b) {
    Real<N> r;
    for (int i = 0; i < kRegisters<N>; ++i) r.v[i] = hn::IfThenElse(m.m[i], a.v[i], b.v[i]);
    return r;
}
template <int N>
inline Word<N> select(const Mask<N>& m, const Word<N>& a, const Word<N>& b) {
    Word<N> r;
    for (int i = 0; i < kRegisters<N>; ++i)
        r.v[i] = hn::IfThenElse(hn::RebindMask(WordTag(), m.m[i]), a.v[i], b.v[i]);
    return r;
}
template <int N>
inline Real<N> magnitude(const Real<N>& a) {
    Real<N> r;
    for (int i = 0; i < kRegisters<N>; ++i) r.v[i] = hn::Abs(a.v[i]);
    return r;
}

inline float smallestLane(const Real<kPacketSize>& a) {
    hn::Vec<Tag> m = a.v[0];
    for (int i = 1; i < kRegisters<kPacketSize>; ++i) m = hn::Min(m, a.v[i]);
    return hn::GetLane(hn::MinOfLanes(Tag(), m));
}
inline float largestLane(const Real<kPacketSize>& a) {
    hn::Vec<Tag> m = a.v[0];
    for (int i = 1; i < kRegisters<kPacketSize>; ++i) m = hn::Max(m, a.v[i]);
    return hn::GetLane(hn::MaxOfLanes(Tag(), m));
}
inline Mask<kPacketSize> operator!=(const Word<kPacketSize>& a, const Word<kPacketSize>& b) {
    Mask<kPacketSize> r;
    for (int i = 0; i < kRegisters<kPacketSize>; ++i)
        r.m[i] = hn::RebindMask(Tag(), hn::Ne(a.v[i], b.v[i]));
    return r;
}
/// Lanes that have one of the bits given.
inline Mask<kPacketSize> withBit(const Word<kPacketSize>& a, uint32_t bit) {
    Mask<kPacketSize> r;
    for (int i = 0; i < kRegisters<kPacketSize>; ++i)
        r.m[i] = hn::RebindMask(Tag(), hn::TestBit(a.v[i], hn::Set(WordTag(), bit)));
    return r;
}
/// The smallest lanes of four: together, as neighbours are halved in all of them at once.
inline void smallestLanes(const Real<kPacketSize> (&a)[4], float* smallest) {
#if HWY_TARGET == HWY_SCALAR
    for (int i = 0; i < 4; ++i) smallest[i] = smallestLane(a[i]);
#else
    const Tag tag;
    hn::Vec<Tag> m[4];
    for (int i = 0; i < 4; ++i) {
        m[i] = a[i].v[0];
        for (int j = 1; j < kRegisters<kPacketSize>; ++j) m[i] = hn::Min(m[i], a[i].v[j]);
    }
    const auto halve = [tag](hn::Vec<Tag> low, hn::Vec<Tag> high) HWY_ATTR {
        return hn::Min(hn::ConcatEven(tag, high, low), hn::ConcatOdd(tag, high, low));
    };
    hn::Vec<Tag> all = halve(halve(m[0], m[1]), halve(m[2], m[3]));
    for (int lanes = kRegisterLanes; lanes > 4; lanes /= 2) all = halve(all, all);
    alignas(64) float lanes[kRegisterLanes];
    hn::Store(all, tag, lanes);
    for (int i = 0; i < 4; ++i) smallest[i] = lanes[i];
#endif
}

/// Values not below 0 with the lane's number for their lowest four bits: no two are equal.
inline Real<kPacketSize> numbered(const Real<kPacketSize>& a) {
    Real<kPacketSize> r;
    for (int i = 0; i < kRegisters<kPacketSize>; ++i) {
        const auto bits = hn::AndNot(hn::Set(WordTag(), 15u), hn::BitCast(WordTag(), a.v[i]));
        const auto number = hn::Iota(WordTag(), uint32_t(i * kRegisterLanes));
        r.v[i] = hn::BitCast(Tag(), hn::Or(bits, number));
    }
    return r;
}
/// 1/a for positive normal a, off by less than 2^-14 of it; how much depends on the machine.
inline Real<kPacketSize> roughReciprocal(const Real<kPacketSize>& a) {
    Real<kPacketSize> r;
    for (int i = 0; i < kRegisters<kPacketSize>; ++i) {
        const hn::Vec<Tag> x = hn::ApproximateReciprocal(a.v[i]);
        r.v[i] = hn::Mul(x, hn::Sub(hn::Set(Tag(), 2.0f), hn::Mul(a.v[i], x)));
    }
    return r;
}

/// The same, off by less than 2.1 * 2^-24 of it.
inline Real<kPacketSize> reciprocal(const Real<kPacketSize>& a) {
    const Real<kPacketSize> x = roughReciprocal(a);
    return x * (Real<kPacketSize>(2.0f) - a * x);
}

template <>
struct Mask<1> {
    bool m;

    uint32_t bits() const { return m ? 1u : 0u; }
    bool any() const { return m; }
    static Mask fromBits(uint32_t bits) { return {(bits & 1) != 0}; }
};

template <>
struct Real<1> {
    float v;

    Real() = default;
    explicit Real(float x) : v(x) {}
    static Real load(const float* p) { return Real(*p); }
    static Real loadUnaligned(const float* p) { return Real(*p); }
    void store(float* p) const { *p = v; }
};

template <>
struct Word<1> {
    uint32_t v;

    Word() = default;
    explicit Word(uint32_t x) : v(x) {}
    static Word load(const uint32_t* p) { return Word(*p); }
    void store(uint32_t* p) const { *p = v; }
};

inline Real<1> operator+(Real<1> a, Real<1> b) { return Real<1>(a.v + b.v); }
inline Real<1> operator-(Real<1> a, Real<1> b) { return Real<1>(a.v - b.v); }
inline Real<1> operator*(Real<1> a, Real<1> b) { return Real<1>(a.v * b.v); }
inline Real<1> operator/(Real<1> a, Real<1> b) { return Real<1>(a.v / b.v); }
inline Real<1> min(Real<1> a, Real<1> b) { return Real<1>(a.v < b.v ? a.v : b.v); }
inline Real<1> max(Real<1> a, Real<1> b) { return Real<1>(a.v > b.v ? a.v : b.v); }
inline Mask<1> operator<(Real<1> a, Real<1> b) { return {a.v < b.v}; }
inline Mask<1> operator<=(Real<1> a, Real<1> b) { return {a.v <= b.v}; }
inline Mask<1> operator>(Real<1> a, Real<1> b) { return {a.v > b.v}; }
inline Mask<1> operator>=(Real<1> a, Real<1> b) { return {a.v >= b.v}; }
inline Mask<1> operator==(Real<1> a, Real<1> b) { return {a.v == b.v}; }
inline Mask<1> operator!=(Real<1> a, Real<1> b) { return {a.v != b.v}; }
inline Mask<1> operator!=(Word<1> a, Word<1> b) { return {a.v != b.v}; }
inline Mask<1> operator&(Mask<1> a, Mask<1> b) { return {a.m && b.m}; }
inline Mask<1> operator|(Mask<1> a, Mask<1> b) { return {a.m || b.m}; }
inline Mask<1> andNot(Mask<1> a, Mask<1> b) { return {a.m && !b.m}; }
inline Real<1> select(Mask<1> m, Real<1> a, Real<1> b) { return m.m ? a : b; }
inline Word<1> select(Mask<1> m, Word<1> a, Word<1> b) { return m.m ? a : b; }
inline Real<1> magnitude(Real<1> a) { return Real<1>(__builtin_fabsf(a.v)); }

template <int N>
bool any(const Mask<N>& m) {
    return m.any();
}

inline int lowestBit(uint32_t bits) { return __builtin_ctz(bits); }

} // namespace smart::SMART_ISA
