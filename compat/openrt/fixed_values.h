// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "compat/openrt/state_values.h"

namespace smart::compat {

/// A value of OpenGL's fixed-function state or of its limits, switches left out; empty: the name
/// is none.
std::optional<StateValue> fixedStateValue(Context& context, RTenum name);

} // namespace smart::compat
