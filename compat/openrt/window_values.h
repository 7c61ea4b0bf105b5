// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "compat/openrt/state_values.h"

namespace smart::compat {

/// What rtGet finds of the window's buffers and of how pixels lie in memory; empty: another name.
std::optional<StateValue> windowValue(Recorder& recorder, RTenum name);

} // namespace smart::compat
