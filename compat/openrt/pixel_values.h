// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "compat/openrt/state_values.h"

namespace smart::compat {

/// Values of the raster position, of pixel zoom and of pixel transfer; nothing for other names.
std::optional<StateValue> pixelValue(const Recorder& recorder, RTenum name);

} // namespace smart::compat
