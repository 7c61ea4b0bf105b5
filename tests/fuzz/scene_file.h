// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace openrt::test {

/// Loads the bytes as a scene file of this ending, in a folder of its own with a texture `t.png`
/// and materials `a.mtl` beside it. A description that comes of it has to be sound.
void loadSceneFile(const std::string& ending, const uint8_t* data, std::size_t size);

} // namespace openrt::test
