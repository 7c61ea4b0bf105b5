// SPDX-License-Identifier: MIT
// Options that openrt-accuracy and several subcommands of openrt-bench share, so that they are
// called and checked alike.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "libsmart/kernel/kernels.h"
#include "tests/bench/json_file.h"
#include "tests/bench/workload.h"

namespace smart::bench {

/// Where pictures are taken from.
struct ViewOptions {
    std::string cameras, name;
    std::vector<double> camera, light;

    void add(CLI::App& app);
    /// Of --cameras the line that --name says, or the one named like the scene's file.
    View view(const std::string& scene) const;
};

/// One, and `most` where that is more.
std::vector<unsigned> threadCounts(unsigned most);

void addScene(CLI::App& app, std::string& scene);
void addSize(CLI::App& app, uint32_t& size);
/// All cores unless something else is given. `what`: the threads do.
void addThreads(CLI::App& app, unsigned& threads, const std::string& what);
void addRepeat(CLI::App& app, unsigned& repeat);
void addIsa(CLI::App& app, std::string& isa);
void addPrecision(CLI::App& app, std::string& precision);
void addPeers(CLI::App& app, std::vector<std::string>& peers);

/// Makes the kernels of that name the ones in use; "" keeps the machine's. Throws UsageError.
void selectIsa(const std::string& isa);
Precision precisionOf(const std::string& name);
bool wantsEmbree(const std::vector<std::string>& peers);

/// One line on the terminal that is written over, where a person watches.
void showProgress(const std::string& text);

} // namespace smart::bench
