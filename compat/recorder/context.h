// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>

#include "compat/recorder/attrib_stack.h"
#include "compat/recorder/buffer_store.h"
#include "compat/recorder/display_lists.h"
#include "compat/recorder/error_state.h"
#include "compat/recorder/frame_driver.h"
#include "compat/recorder/recorder.h"
#include "compat/recorder/vertex_arrays.h"

namespace smart::compat {

/// Everything that the calls of one thread act on.
class Context {
public:
    explicit Context(unsigned threads) : frames_(recorder_, threads) {}

    Recorder& recorder() { return recorder_; }
    FrameDriver& frames() { return frames_; }
    ErrorState& errors() { return errors_; }
    DisplayLists& lists() { return lists_; }
    AttribStack& attribStack() { return attribStack_; }
    ClientAttribStack& clientAttribStack() { return clientAttribStack_; }
    VertexArrays& arrays() { return arrays_; }
    BufferStore& buffers() { return buffers_; }
    /// Whether something is refused for the first time here. Throws std::bad_alloc.
    bool isFirstRefusal(const std::string& what) { return refused_.insert(what).second; }

private:
    ErrorState errors_;
    std::set<std::string> refused_;
    AttribStack attribStack_;
    ClientAttribStack clientAttribStack_;
    DisplayLists lists_;
    VertexArrays arrays_;
    BufferStore buffers_;
    Recorder recorder_;
    FrameDriver frames_; // last: its end waits for frames that show what the recorder made
};

using ContextId = uint64_t; ///< from 1, never used again; 0: none

/// Why no thread has a context any more, nor may ask for anything; nullptr: the library may be used.
/// The process ends, or it is a child, by fork, of one that had contexts: their threads and locks
/// are not the child's.
const char* whyUnusable() noexcept;

/// The context current on the calling thread; nullptr: none.
Context* currentContext() noexcept;
ContextId currentContextId() noexcept;
/// False: it was destroyed, or never made.
bool isContext(ContextId id) noexcept;
/// The same, kept alive by the result.
std::shared_ptr<Context> currentContextShared() noexcept;

/// Makes a context that is current nowhere; threads as Renderer has them.
ContextId createContext(unsigned threads);
/// Makes a context, or none (0), current on the calling thread. Throws Error for an unknown one
/// and for one that is current on another thread.
void makeContextCurrent(ContextId id);
/// Forgets a context; it ends when it is current nowhere. Throws Error for an unknown one.
void destroyContext(ContextId id);
/// Destroys the default context, if there is one, makes another, and makes that current.
void resetDefaultContext(unsigned threads);
/// Destroys all contexts; no thread has one afterwards.
void destroyAllContexts() noexcept;

} // namespace smart::compat
