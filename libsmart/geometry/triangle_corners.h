// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace smart {

/// The vertex numbers of each triangle of an object. Separate triangles, strips, fans and quads
/// number their vertices regularly: every other triangle has the corners of the one before the last,
/// each more by a fixed step. Such runs are stored, 56 bytes each, however long they are.
class TriangleCorners {
public:
    using Corners = std::array<uint32_t, 3>;

    TriangleCorners() = default;
    TriangleCorners(std::initializer_list<Corners> list) {
        for (const Corners& corners : list) push_back(corners);
    }

    bool empty() const { return size_ == 0; }
    std::size_t size() const { return size_; }
    Corners operator[](std::size_t triangle) const {
        std::size_t run = 0;
        if (runs_.size() > 1) {
            run = firstRuns_[triangle / kTrianglesOfEntry];
            while (run + 1 < runs_.size() && runs_[run + 1].first <= triangle) ++run;
        }
        return runs_[run].corners(uint32_t(triangle));
    }
    std::size_t bytes() const {
        return runs_.capacity() * sizeof(Run) + firstRuns_.capacity() * sizeof(uint32_t);
    }

    /// Room for n more triangles, so that appending them can not fail.
    void makeRoom(std::size_t n);
    void push_back(const Corners& corners);
    void clear() { *this = TriangleCorners(); }
    void shrink_to_fit();

    friend bool operator==(const TriangleCorners& a, const TriangleCorners& b);

private:
    /// Triangles first, first + 2, ... begin with start[0], those between with start[1].
    struct Run {
        uint32_t first = 0, count = 0;
        Corners start[2]{}, step[2]{}; ///< modulo 2^32

        Corners corners(uint32_t triangle) const {
            const uint32_t number = triangle - first, odd = number & 1, steps = number / 2;
            Corners result;
            for (std::size_t k = 0; k < 3; ++k)
                result[k] = start[odd][k] + steps * step[odd][k];
            return result;
        }
    };
    static constexpr std::size_t kTrianglesOfEntry = 64;

    std::vector<Run> runs_;
    /// Of every 64th triangle the number of its run.
    std::vector<uint32_t> firstRuns_;
    std::size_t size_ = 0;
};

} // namespace smart
