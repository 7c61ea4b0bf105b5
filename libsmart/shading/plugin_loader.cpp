// SPDX-License-Identifier: MIT
#include "libsmart/shading/plugin_loader.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <new>

#include "libsmart/base/error.h"
#include "libsmart/base/fp_environment.h"
#include "libsmart/shading/plugin_file.h"

namespace smart {

namespace {

constexpr std::size_t kMaxClasses = 4096;

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
    throw Error(ErrorCode::InvalidValue, path + ": " + reason);
}

/// A shader library while it is loaded. Its classes own it; the last of them unloads it.
class Plugin : public std::enable_shared_from_this<Plugin> {
public:
    explicit Plugin(const std::string& path) : path_(path) {
        examinePluginFile(path);
        // Libraries compiled with -ffast-math change the floating-point state when loaded.
        const FpEnvironment unchanged;
        handle_.reset(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL));
        if (!handle_) {
            const char* const reason = dlerror();
            refuse(path, std::string("can not be loaded: ") + (reason ? reason : "unknown reason"));
        }
        // The file may have been replaced since it was examined.
        const auto* const plugin =
            static_cast<const RTSplugin*>(dlsym(handle_.get(), RTS_PLUGIN_SYMBOL));
        if (!plugin) refuse(path, "has no symbol " RTS_PLUGIN_SYMBOL);
        checkPlugin(path, *plugin);
        readClasses(*plugin);
    }
    Plugin(const Plugin&) = delete;
    Plugin& operator=(const Plugin&) = delete;

    void* handle() const { return handle_.get(); }
    std::vector<std::string> classNames() const {
        std::vector<std::string> names;
        for (const Entry& entry : entries_) names.push_back(entry.name);
        return names;
    }

    ShaderClassPtr find(std::string_view name) {
        const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                        [&](const Entry& e) { return e.name == name; });
        if (entry == entries_.end()) {
            std::string all;
            for (const Entry& e : entries_) all += (all.empty() ? "" : ", ") + e.name;
            refuse(path_, "has no shader class '" + std::string(name) + "'; it has " + all);
        }
        {
            const std::lock_guard lock(mutex_);
            if (ShaderClassPtr living = entry->made.lock()) return living;
        }
        // Not under the lock: this runs code of the plug-in.
        ShaderClassPtr made = make(*entry);
        const std::lock_guard lock(mutex_);
        if (ShaderClassPtr living = entry->made.lock()) return living;
        entry->made = made;
        return made;
    }

private:
    struct Entry {
        const RTSpluginclass* listed;
        std::string name;
        std::weak_ptr<const ShaderClass> made;
    };
    struct Unload {
        void operator()(void* handle) const { dlclose(handle); }
    };

    void readClasses(const RTSplugin& plugin) {
        const std::less<const void*> before; // the pointers may be anything
        if (before(plugin.last, plugin.first) || (plugin.last && !plugin.first))
            refuse(path_, "its list of shader classes ends before it starts");
        const auto count = std::size_t(plugin.last - plugin.first);
        if (count == 0) refuse(path_, "has no shader class");
        if (count > kMaxClasses) refuse(path_, "lists more than 4096 shader classes");
        for (std::size_t i = 0; i < count; ++i) {
            const RTSpluginclass* const listed = plugin.first[i];
            const std::string which = "shader class " + std::to_string(i + 1) + " of its list ";
            if (!listed) refuse(path_, which + "is NULL");
            if (listed->structSize < sizeof(RTSpluginclass))
                refuse(path_, which + "has " + std::to_string(listed->structSize) +
                                  " bytes; at least " + std::to_string(sizeof(RTSpluginclass)) +
                                  " are needed");
            if (!listed->descriptor && !listed->describe)
                refuse(path_, which + "has neither a descriptor nor a function that makes it");
            const char* const name = listed->name         ? listed->name
                                     : listed->descriptor ? listed->descriptor->name
                                                          : nullptr;
            if (!name || !*name) refuse(path_, which + "has no name");
            for (const Entry& other : entries_)
                if (other.name == name)
                    refuse(path_, "has two shader classes named '" + other.name + "'");
            entries_.push_back({listed, name, {}});
        }
        // Compilers and linkers list them in any order.
        std::sort(entries_.begin(), entries_.end(),
                  [](const Entry& a, const Entry& b) { return a.name < b.name; });
    }

    /// What the plug-in throws ends here, before anything can unload the code that the exception
    /// needs.
    ShaderClassPtr make(const Entry& entry) {
        const std::string which = "shader class '" + entry.name + "' ";
        std::array<char, 512> reason = {};
        const RTshaderclass* descriptor = entry.listed->descriptor;
        try {
            if (!descriptor)
                descriptor = entry.listed->describe(entry.listed, reason.data(),
                                                    RTuint(reason.size()));
            reason.back() = '\0';
            if (!descriptor)
                throw Error(ErrorCode::InvalidValue,
                            which + "can not be made" + (reason[0] ? ": " : "") + reason.data());
            return std::make_shared<const ShaderClass>(*descriptor, shared_from_this());
        } catch (const Error& error) {
            throw Error(error.code(), path_ + ": " + error.what());
        } catch (const std::bad_alloc&) {
            throw Error(ErrorCode::OutOfMemory, path_ + ": " + which + "ran out of memory");
        } catch (const std::exception& error) {
            refuse(path_, which + "threw an exception: " + error.what());
        } catch (...) {
            refuse(path_, which + "threw an exception that says nothing");
        }
    }

    const std::string path_;
    std::unique_ptr<void, Unload> handle_;
    std::mutex mutex_; // of Entry::made
    std::vector<Entry> entries_;
};

/// The loaded plug-ins. Never destroyed: classes may be released while the program ends.
struct LoadedPlugins {
    std::mutex mutex;
    std::map<void*, std::weak_ptr<Plugin>> byHandle;
};

std::shared_ptr<Plugin> load(const std::string& path) {
    static LoadedPlugins& loaded = *new LoadedPlugins;
    // Loading again counts one more user of the same handle.
    auto plugin = std::make_shared<Plugin>(path);
    const std::lock_guard lock(loaded.mutex);
    std::erase_if(loaded.byHandle, [](const auto& entry) { return entry.second.expired(); });
    std::weak_ptr<Plugin>& known = loaded.byHandle[plugin->handle()];
    if (auto living = known.lock()) return living;
    known = plugin;
    return plugin;
}

} // namespace

ShaderClassPtr loadShaderClass(std::string_view className, const std::string& path) {
    return load(path)->find(className);
}

std::vector<std::string> shaderClassNames(const std::string& path) {
    return load(path)->classNames();
}

} // namespace smart
