// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace smart {

/// Threads that do the parts of one build together, among them the caller's. Helpers start when
/// there is something to share, and end with the crew.
class BuildCrew {
public:
    explicit BuildCrew(unsigned threads) : threads_(threads ? threads : 1) {}
    ~BuildCrew();
    BuildCrew(const BuildCrew&) = delete;
    BuildCrew& operator=(const BuildCrew&) = delete;

    unsigned threads() const { return threads_; }

    /// work(i) for each i below `count`, in any order and at the same time. Rethrows what a part
    /// throws; the parts that had not begun are left out then. Not to be called by a part.
    template <class Work>
    void forEach(std::size_t count, const Work& work) {
        run(count, [](const void* w, std::size_t i) { (*static_cast<const Work*>(w))(i); }, &work);
    }

private:
    using Part = void (*)(const void* work, std::size_t number);

    void run(std::size_t count, Part part, const void* work);
    void startHelpers(std::size_t useful);
    void help(uint64_t seen);
    void takeParts();

    const unsigned threads_;
    std::vector<std::thread> helpers_;
    std::mutex mutex_;
    std::condition_variable begun_, ended_;
    uint64_t round_ = 0;
    std::size_t working_ = 0; ///< helpers in this round
    /// Helpers may join this round. Those that the system let run too late are not waited for.
    bool open_ = false;
    bool closing_ = false;
    std::exception_ptr failure_;
    std::atomic<std::size_t> next_{0};
    std::size_t count_ = 0;
    Part part_ = nullptr;
    const void* work_ = nullptr;
};

} // namespace smart
