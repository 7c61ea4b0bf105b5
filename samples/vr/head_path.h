// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <istream>
#include <string>
#include <vector>

namespace samples {

/// A tracked head: between the eyes, in metres from the middle of the room's floor, y up, -z to
/// the front wall.
struct HeadPose {
    double seconds = 0;
    glm::dvec3 position{0.0, 1.7, 0.0};
    glm::dvec3 angles{0.0}; ///< degrees: yaw to the left, pitch up, roll to the left

    glm::dmat3 orientation() const; ///< columns: right, up, back
    /// -1: the left eye, 1: the right one, 0: between; distance between the eyes in metres.
    glm::dvec3 eye(int side, double distance) const;
};

/// What a tracker recorded: lines of `seconds x y z yaw pitch roll`, in order of time; # begins a
/// comment.
class HeadPath {
public:
    /// Throws std::runtime_error with the file and line of what is wrong.
    explicit HeadPath(const std::filesystem::path& file);
    /// `name`: of what the stream reads, for people.
    HeadPath(std::istream& stream, const std::string& name);

    /// Between two samples: on the way from one to the next; before the first and after the last:
    /// these.
    HeadPose at(double seconds) const;
    double end() const { return samples_.back().seconds; }

private:
    void read(std::istream& stream, const std::string& name);

    std::vector<HeadPose> samples_;
};

} // namespace samples
