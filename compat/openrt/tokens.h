// SPDX-License-Identifier: MIT
// RT_ tokens and what they name inside. Functions that take a token throw Error for others.
#pragma once

#include "compat/recorder/matrix_stack.h"
#include "compat/recorder/primitive_assembler.h"
#include "libsmart/render/framebuffer.h"
#include "libsmart/render/queued_frame.h"
#include "libsmart/scene/query.h"
#include "openrt/types.h"

namespace smart::compat {

Primitive primitiveOf(RTenum mode);
MatrixMode matrixModeOf(RTenum mode);
RTenum tokenOf(MatrixMode mode);
RTenum tokenOf(FrameStatus status);
PixelFormat pixelFormatOf(RTenum format);
Coherence coherenceOf(RTenum coherence);

/// Whether OpenGL 1.5 has the capability, the value of state, or the hint, or ours adds it.
bool isCapability(RTenum token);
bool isStateVariable(RTenum token);
bool isHintTarget(RTenum token);

} // namespace smart::compat
