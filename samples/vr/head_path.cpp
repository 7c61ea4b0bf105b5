// SPDX-License-Identifier: MIT
#include "samples/vr/head_path.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <sstream>
#include <stdexcept>

namespace samples {

glm::dmat3 HeadPose::orientation() const {
    const glm::dvec3 radians = angles * (3.14159265358979323846 / 180.0);
    const double cy = std::cos(radians.x), sy = std::sin(radians.x);
    const double cp = std::cos(radians.y), sp = std::sin(radians.y);
    const double cr = std::cos(radians.z), sr = std::sin(radians.z);
    const glm::dmat3 yaw({cy, 0, -sy}, {0, 1, 0}, {sy, 0, cy});
    const glm::dmat3 pitch({1, 0, 0}, {0, cp, sp}, {0, -sp, cp});
    const glm::dmat3 roll({cr, sr, 0}, {-sr, cr, 0}, {0, 0, 1});
    return yaw * pitch * roll;
}

glm::dvec3 HeadPose::eye(int side, double distance) const {
    return position + orientation()[0] * (0.5 * side * distance);
}

HeadPath::HeadPath(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error(file.string() + ": it can not be read");
    read(stream, file.string());
}

HeadPath::HeadPath(std::istream& stream, const std::string& name) { read(stream, name); }

void HeadPath::read(std::istream& stream, const std::string& name) {
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        line.resize(std::min(line.find('#'), line.size()));
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        std::istringstream words(line);
        HeadPose pose;
        std::string rest;
        words >> pose.seconds >> pose.position.x >> pose.position.y >> pose.position.z >>
            pose.angles.x >> pose.angles.y >> pose.angles.z;
        // Twice the time: between any two of them lies a time too.
        const bool finite = std::isfinite(2 * pose.seconds + glm::dot(pose.position, pose.position) +
                                          glm::dot(pose.angles, pose.angles));
        const bool later = samples_.empty() || pose.seconds > samples_.back().seconds;
        if (!words || words >> rest || !finite || !later)
            throw std::runtime_error(name + ", line " + std::to_string(number) +
                                     ": not seven numbers, or not later than the line before");
        samples_.push_back(pose);
    }
    if (samples_.empty()) throw std::runtime_error(name + ": there is no pose in it");
}

HeadPose HeadPath::at(double seconds) const {
    const auto after = std::upper_bound(
        samples_.begin(), samples_.end(), seconds,
        [](double time, const HeadPose& pose) { return time < pose.seconds; });
    if (after == samples_.begin()) return samples_.front();
    const HeadPose& from = *(after - 1);
    if (after == samples_.end()) return from;
    const double share = (seconds - from.seconds) / (after->seconds - from.seconds);
    HeadPose pose;
    pose.seconds = seconds;
    pose.position = from.position + (after->position - from.position) * share;
    for (int k = 0; k < 3; ++k) // the shorter way round
        pose.angles[k] = from.angles[k] +
                         std::remainder(after->angles[k] - from.angles[k], 360.0) * share;
    return pose;
}

} // namespace samples
