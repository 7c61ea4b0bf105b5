// SPDX-License-Identifier: MIT
// OpenGL's names of vertex arrays and of what is asked about them.
#pragma once

#include <optional>

#include "compat/openrt/state_values.h"
#include "compat/recorder/vertex_arrays.h"
#include "openrt/types.h"

namespace smart::compat {

/// Of RT_VERTEX_ARRAY and the like, of RT_VERTEX_ARRAY_POINTER and the like; empty: none of them.
std::optional<ArrayKind> arrayKindOf(RTenum cap);
std::optional<ArrayKind> arrayPointerOf(RTenum pname);

/// A value of state about arrays, indices or buffers; empty: the name is none.
std::optional<StateValue> arrayStateValue(const VertexArrays& arrays, RTenum name);

} // namespace smart::compat
