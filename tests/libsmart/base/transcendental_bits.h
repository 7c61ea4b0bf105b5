// SPDX-License-Identifier: MIT
// One digest of the bits of all functions over many arguments, compiled several times with other
// flags; see transcendental_test.cpp.
#pragma once

#include <cstdint>

uint64_t baselineBits();
uint64_t wideBits();
uint64_t contractedBits();
