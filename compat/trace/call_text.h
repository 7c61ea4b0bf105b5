// SPDX-License-Identifier: MIT
// Values of calls as C has them.
#pragma once

#include <span>
#include <string>

#include "compat/stream/call_table.h"
#include "openrt/types.h"

namespace smart::compat {

/// A number that reads back as the same bits.
std::string textOf(ValueKind kind, CallValue value);
/// The same; a token by its name, where it has one.
std::string textOf(const CallParameter& parameter, CallValue value);
std::string tokenText(RTenum token);
std::string errorText(RTenum error);
/// A string literal of text that ends at a zero or with the bytes.
std::string literalOf(std::span<const std::byte> bytes);
/// The numbers of memory, with commas between; no more than `most`, and then "...".
std::string textOfElements(ValueKind element, std::span<const std::byte> bytes, std::size_t most);
/// Whether textOfElements() reads back as the same bits in C.
bool isExact(ValueKind element, std::span<const std::byte> bytes);
/// "RTfloat" and so on.
const char* typeName(ValueKind kind);

} // namespace smart::compat
