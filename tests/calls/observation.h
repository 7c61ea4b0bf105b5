// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace openrt::test {

/// Everything that an application can see of the current context: values of all state that can be
/// asked for, names, contents of textures and buffers, what rays hit in the scene under way, and
/// the frame buffer.
class Observation {
public:
    static Observation now();
    /// Names of the first few things that differ; empty: nothing.
    std::string differences(const Observation& other) const;

private:
    struct Entry {
        std::string name;
        std::vector<double> values;
    };
    std::vector<Entry> entries_;

    void add(std::string name, const double* values, std::size_t count);
    void addState();
    void addFixedFunction();
    void addTextures();
    void addNames();
    void addScene();
};

} // namespace openrt::test
