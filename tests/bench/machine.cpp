// SPDX-License-Identifier: MIT
#include "tests/bench/machine.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

namespace smart::bench {
namespace {

/// What follows the colon in the first line of /proc/cpuinfo that starts with `key`.
std::string cpuinfo(const std::string& key) {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.rfind(key, 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

} // namespace

nlohmann::json machine() {
    nlohmann::json result = {{"processor", cpuinfo("model name")},
                             {"family", cpuinfo("cpu family")},
                             {"model", cpuinfo("model\t")},
                             {"cores", std::thread::hardware_concurrency()},
                             {"compiler", __VERSION__}};
    double load[3] = {0, 0, 0};
    if (getloadavg(load, 3) == 3) result["load"] = load;
#ifdef _SC_LEVEL1_DCACHE_SIZE
    result["cacheBytes"] = {sysconf(_SC_LEVEL1_DCACHE_SIZE), sysconf(_SC_LEVEL2_CACHE_SIZE),
                            sysconf(_SC_LEVEL3_CACHE_SIZE)};
#endif
    return result;
}

} // namespace smart::bench
