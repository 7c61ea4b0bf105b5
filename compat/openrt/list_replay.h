// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "compat/recorder/context.h"

namespace smart::compat {

/// What rtCallList does. An unknown name is ignored, as is a call deeper than lists may nest.
/// Errors of the calls in the list are recorded as they happen; throws for those of its own.
void replayList(Context& context, uint32_t name);

} // namespace smart::compat
