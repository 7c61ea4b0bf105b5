// SPDX-License-Identifier: MIT
#include "compat/trace/call_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "compat/stream/call_memory.h"
#include "compat/trace/token_names.h"
#include "openrt/enums.h"

namespace smart::compat {

namespace {

std::string floating(double value, int digits, const char* suffix) {
    if (std::isnan(value)) return "NAN";
    if (std::isinf(value)) return value < 0 ? "-INFINITY" : "INFINITY";
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    std::string result = text;
    if (result.find_first_of(".e") == std::string::npos) result += ".0";
    return result + suffix;
}

bool isWhole(ValueKind kind) {
    return kind != ValueKind::Float && kind != ValueKind::Double;
}

} // namespace

std::string textOf(ValueKind kind, CallValue value) {
    switch (kind) {
        case ValueKind::Float:
            return floating(double(value.as<float>()), 9, "f");
        case ValueKind::Double:
            return floating(value.as<double>(), 17, "");
        case ValueKind::UInt64:
            return std::to_string(value.as<uint64_t>()) + "u";
        case ValueKind::UInt32:
            return std::to_string(value.as<uint32_t>()) + "u";
        case ValueKind::Int64:
            if (value.as<int64_t>() == INT64_MIN) return "INT64_MIN";
            break;
        case ValueKind::Int32:
            if (value.as<int32_t>() == INT32_MIN) return "INT32_MIN";
            break;
        default:
            break;
    }
    return std::to_string(integerOf(kind, value));
}

std::string tokenText(RTenum token) {
    if (const char* const name = tokenName(token)) return name;
    return std::to_string(token);
}

std::string errorText(RTenum error) {
    return error == RT_NO_ERROR ? "RT_NO_ERROR" : tokenText(error);
}

std::string textOf(const CallParameter& parameter, CallValue value) {
    if (parameter.meaning == Meaning::Token) return tokenText(value.as<RTenum>());
    return textOf(parameter.kind, value);
}

std::string literalOf(std::span<const std::byte> bytes) {
    std::string text = "\"";
    for (const std::byte b : bytes) {
        const auto c = char(b);
        if (c == '\0') break;
        if (c == '"' || c == '\\') {
            text += '\\';
            text += c;
        } else if (c < ' ' || c > '~' || c == '?') {
            char octal[8];
            std::snprintf(octal, sizeof octal, "\\%03o", unsigned(uint8_t(c)));
            text += octal;
        } else {
            text += c;
        }
    }
    return text + '"';
}

std::string textOfElements(ValueKind element, std::span<const std::byte> bytes, std::size_t most) {
    const ValueKind kind = element == ValueKind::Void ? ValueKind::UInt8 : element;
    const std::size_t size = bytesOf(kind), count = bytes.size() / size;
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) text += ", ";
        if (i == most) return text + "...";
        uint64_t bits = 0;
        std::memcpy(&bits, bytes.data() + i * size, size);
        text += textOf(kind, CallValue(bits));
    }
    return text;
}

bool isExact(ValueKind element, std::span<const std::byte> bytes) {
    const std::size_t size = bytesOf(element);
    if (size == 0 || bytes.size() % size != 0 || bytes.empty()) return false;
    for (std::size_t i = 0; !isWhole(element) && i < bytes.size(); i += size) {
        uint64_t bits = 0;
        std::memcpy(&bits, bytes.data() + i, size);
        const double value = element == ValueKind::Float ? double(CallValue(bits).as<float>())
                                                         : CallValue(bits).as<double>();
        if (!std::isfinite(value)) return false;
    }
    return true;
}

const char* typeName(ValueKind kind) {
    constexpr const char* kNames[] = {"void",     "RTbyte",  "RTubyte",  "RTshort",
                                      "RTushort", "RTint",   "RTuint",   "RTint64",
                                      "RTuint64", "RTfloat", "RTdouble", "void*"};
    return kNames[std::size_t(kind)];
}

} // namespace smart::compat
