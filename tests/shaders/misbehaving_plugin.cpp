// SPDX-License-Identifier: MIT
#include "openrt/plugin.hpp"
#include "tests/shaders/misbehaving_surfaces.h"

using namespace misbehaving;

OPENRT_PLUGIN(ThrowsNumber, "ThrowsNumber")
OPENRT_PLUGIN(ThrowsException, "ThrowsException")
OPENRT_PLUGIN(ThrowsInPacket, "ThrowsInPacket")
OPENRT_PLUGIN(NanRadiance, "NanRadiance")
OPENRT_PLUGIN(InfiniteRadiance, "InfiniteRadiance")
OPENRT_PLUGIN(NanAlpha, "NanAlpha")
OPENRT_PLUGIN(NanInPacket, "NanInPacket")
OPENRT_PLUGIN(OverflowsInTrace, "OverflowsInTrace")
OPENRT_PLUGIN(NeverWrites, "NeverWrites")
OPENRT_PLUGIN(TracesForever, "TracesForever")
OPENRT_PLUGIN(TracesForeverInPackets, "TracesForeverInPackets")
OPENRT_PLUGIN(TracesNonsense, "TracesNonsense")
OPENRT_PLUGIN(StrangeWeights, "StrangeWeights")
OPENRT_PLUGIN(AsksAbsentLights, "AsksAbsentLights")
OPENRT_PLUGIN(UnknownTextures, "UnknownTextures")
OPENRT_PLUGIN(WritesForeignLanes, "WritesForeignLanes")
