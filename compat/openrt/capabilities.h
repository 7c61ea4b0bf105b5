// SPDX-License-Identifier: MIT
#pragma once

#include "compat/recorder/context.h"
#include "openrt/types.h"

namespace smart::compat {

// The switches of rtEnable, rtDisable and rtIsEnabled. Both throw Error (InvalidEnum) for a token
// that is none.

/// Switching on what there is not throws Error (InvalidOperation) the first time, and has no
/// effect; off it is already.
void setCapability(Context& context, RTenum cap, bool on);
bool isEnabled(Context& context, RTenum cap);

} // namespace smart::compat
