// SPDX-License-Identifier: MIT
#include "compat/recorder/context.h"

#include <pthread.h>

#include <atomic>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "compat/recorder/frame_table.h"
#include "libsmart/base/error.h"
#include "libsmart/base/immortal.h"
#include "libsmart/kernel/kernels.h"
#include "libsmart/render/worker.h"

namespace smart::compat {

namespace {

struct Entry {
    std::shared_ptr<Context> context;
    std::shared_ptr<std::atomic<bool>> current; ///< on some thread
};

/// All contexts of the process.
struct ContextTable {
    std::mutex mutex;
    std::map<ContextId, Entry> entries;
    ContextId last = 0;
    ContextId defaultContext = 0;
};

std::atomic<const char*> unusable{nullptr};

/// Where what must never end is put; takes no memory from anywhere.
template <class T>
void bury(T& thing) noexcept {
    static Immortal<T> grave;
    std::swap(grave.get(), thing);
}

void abandonInChild() noexcept;

/// Ends the contexts with the process, or with the library where that is unloaded first; their
/// frames are waited for.
struct End {
    explicit End(ContextTable& table) : contexts(table) {
        kernels(); // what rendering needs has to end after this
        findBuiltinClass("");
        pthread_atfork(nullptr, nullptr, &abandonInChild);
    }
    ~End() {
        if (unusable) return;
        if (onWorkerThread()) bury(contexts.entries); // a shader or callback that called exit
        destroyAllContexts();
        frameTable().forgetAll();
        unusable = "the process is ending";
    }
    ContextTable& contexts;
};

/// For those that only take contexts away: needs no memory.
ContextTable& tableAsItIs() noexcept {
    static Immortal<ContextTable> contexts;
    return contexts.get();
}

ContextTable& table() {
    static const End end(tableAsItIs());
    return tableAsItIs();
}

/// Counts destroyAllContexts: what was current before no longer is.
std::atomic<uint64_t> endings{0};

/// Keeps the calling thread's context. The pointer that every call reads is apart, and in the
/// part of thread-local memory that is found without a call.
struct Holder {
    Entry entry;
    ContextId id = 0;
    ~Holder() { release(); }
    void release() noexcept;
};
thread_local Holder holder;
[[gnu::tls_model("initial-exec")]] thread_local Context* current = nullptr;
[[gnu::tls_model("initial-exec")]] thread_local uint64_t currentSince = 0;

void Holder::release() noexcept {
    current = nullptr;
    id = 0;
    const Entry old = std::exchange(entry, {});
    if (old.current) *old.current = false;
} // here the context ends, if it was destroyed before

/// Other threads may have been about to change anything when the process was forked: nothing is
/// looked at, only taken away.
void abandonInChild() noexcept {
    if (unusable.exchange("the child of a fork can not use the library")) return;
    bury(tableAsItIs().entries);
    bury(holder.entry);
    current = nullptr;
    holder.id = 0;
}

Entry& find(ContextTable& contexts, ContextId id) {
    const auto found = contexts.entries.find(id);
    if (found == contexts.entries.end())
        throw Error(ErrorCode::InvalidValue, "no such context");
    return found->second;
}

} // namespace

const char* whyUnusable() noexcept { return unusable; }

Context* currentContext() noexcept {
    if (!current) return nullptr;
    if (currentSince != endings.load(std::memory_order_relaxed)) {
        holder.release();
        return nullptr;
    }
    return current;
}

ContextId currentContextId() noexcept {
    return currentContext() ? holder.id : 0;
}

bool isContext(ContextId id) noexcept {
    ContextTable& contexts = tableAsItIs();
    const std::lock_guard lock(contexts.mutex);
    return contexts.entries.contains(id);
}

std::shared_ptr<Context> currentContextShared() noexcept {
    return currentContext() ? holder.entry.context : nullptr;
}

ContextId createContext(unsigned threads) {
    ContextTable& contexts = table();
    Entry entry{std::make_shared<Context>(threads), std::make_shared<std::atomic<bool>>(false)};
    const std::lock_guard lock(contexts.mutex);
    contexts.entries.emplace(contexts.last + 1, std::move(entry));
    return ++contexts.last;
}

void makeContextCurrent(ContextId id) {
    if (id == currentContextId()) return;
    Entry entry;
    if (id != 0) {
        ContextTable& contexts = table();
        const std::lock_guard lock(contexts.mutex);
        entry = find(contexts, id);
        if (entry.current->exchange(true))
            throw Error(ErrorCode::InvalidOperation, "the context is current on another thread");
    }
    holder.release();
    holder.entry = std::move(entry);
    holder.id = id;
    current = holder.entry.context.get();
    currentSince = endings;
}

void destroyContext(ContextId id) {
    Entry old;
    {
        ContextTable& contexts = table();
        const std::lock_guard lock(contexts.mutex);
        old = find(contexts, id);
        contexts.entries.erase(id);
        if (contexts.defaultContext == id) contexts.defaultContext = 0;
    }
    if (id == currentContextId()) holder.release();
}

void resetDefaultContext(unsigned threads) {
    const ContextId made = createContext(threads);
    ContextId old = 0;
    {
        ContextTable& contexts = table();
        const std::lock_guard lock(contexts.mutex);
        old = std::exchange(contexts.defaultContext, made);
    }
    makeContextCurrent(made);
    if (old != 0) destroyContext(old);
}

void destroyAllContexts() noexcept {
    std::map<ContextId, Entry> old;
    {
        ContextTable& contexts = tableAsItIs();
        const std::lock_guard lock(contexts.mutex);
        old.swap(contexts.entries);
        contexts.defaultContext = 0;
        ++endings;
    }
    currentContext(); // lets go of this thread's
}

} // namespace smart::compat
