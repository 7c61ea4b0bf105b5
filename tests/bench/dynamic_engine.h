// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "tests/bench/dynamic_scene.h"

namespace smart::bench {

/// What the engines say about a packet of a RaySet.
struct DynamicFound {
    float t[kPacketSize];
    uint32_t instance[kPacketSize]; ///< kNoHit: nothing
    uint32_t triangle[kPacketSize];
};

/// One way to keep a changing scene ready for rays. trace() may be called by several threads at
/// once, each after enterThread().
class DynamicEngine {
public:
    virtual ~DynamicEngine() = default;
    virtual std::string name() const = 0;
    virtual bool peer() const = 0;
    /// Tells the library what is where.
    virtual void update(const DynamicStep& step) = 0;
    /// Makes it ready for rays.
    virtual void build() = 0;
    virtual void enterThread() const {}
    virtual void trace(const RaySet& rays, std::size_t first, std::size_t count,
                       DynamicFound* found) const = 0;
    /// Held for what was built last.
    virtual std::size_t bytes() const = 0;
};

using DynamicEnginePtr = std::unique_ptr<DynamicEngine>;

enum class SheetWay {
    Update,
    Redefine, ///< the same object
    New,      ///< another one instead
};

/// By the C interface. `quality`: a value of RT_BUILD_QUALITY. `way` matters to sheets only.
DynamicEnginePtr dynamicOpenrt(const DynamicScene& scene, unsigned threads, SheetWay way,
                               uint32_t quality, const std::string& name);

#ifdef OPENRT_BENCH_EMBREE
enum class EmbreeWay {
    Refit,  ///< the sheet's tree keeps its shape; built at LOW quality
    Low,    ///< built anew at LOW quality, scene flag DYNAMIC
    Medium, ///< built anew at MEDIUM quality
};
DynamicEnginePtr dynamicEmbree(const DynamicScene& scene, unsigned threads, EmbreeWay way);
#endif

} // namespace smart::bench
