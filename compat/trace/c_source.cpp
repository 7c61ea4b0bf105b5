// SPDX-License-Identifier: MIT
#include "compat/trace/c_source.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <ostream>

#include "compat/stream/call_memory.h"
#include "compat/stream/call_player.h"
#include "compat/trace/call_text.h"
#include "compat/trace/source_names.h"

namespace smart::compat {

namespace {

constexpr unsigned kCallsOfAPart = 400; ///< compilers are slow with longer functions

constexpr const char* kHead = R"(/* Written by openrt-trace from recorded calls. To be compiled with
 *     cc -std=c99 program.c -lOpenRT
 * Exit status: 0 if each frame is the recorded one, else 1. */
#include <math.h>
#include <openrt/rt.h>
#include <openrt/rtu.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int frames, unequal;

/* FNV-1a of the rows without what lies between them. */
static void check(const void *pixels, size_t row, size_t height, size_t stride, uint64_t recorded)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    const unsigned char *first = pixels;
    for (size_t y = 0; y < height; ++y)
        for (size_t i = 0; i < row; ++i)
            hash = (hash ^ first[y * stride + i]) * UINT64_C(0x100000001b3);
    ++frames;
    unequal += hash != recorded;
    printf("frame %d: %016llx, %s\n", frames, (unsigned long long)hash,
           hash == recorded ? "as recorded" : "another one than recorded");
}

static size_t pack(RTenum name)
{
    RTint value = 0;
    rtGetIntegerv(name, &value);
    return (size_t)value;
}

static void read_pixels(RTint x, RTint y, RTsizei width, RTsizei height, RTenum format, RTenum type)
{
    size_t w = width > 0 ? (size_t)width : 0, h = height > 0 ? (size_t)height : 0;
    size_t row = (w > pack(RT_PACK_ROW_LENGTH) ? w : pack(RT_PACK_ROW_LENGTH)) + 8;
    void *to = malloc((row * (h + pack(RT_PACK_SKIP_ROWS)) + pack(RT_PACK_SKIP_PIXELS) + 8) * 16);
    if (to) rtReadPixels(x, y, width, height, format, type, to);
    free(to);
}

static void write_mapped(RTenum target, const void *bytes, size_t size)
{
    void *to = NULL;
    rtGetBufferPointerv(target, RT_BUFFER_MAP_POINTER, &to);
    if (to) memcpy(to, bytes, size);
}

static void unbind(void) { rtBindBuffer(RT_ARRAY_BUFFER, 0); }

)";

class SourceWriter final : public TraceVisitor {
public:
    SourceWriter(const SourceNames& names, std::ostream& out) : names_(names), out_(out) {}

    void call(const RecordHead& head, const CallRecord& record) override {
        ++number_;
        context_ = head.context;
        const CallSignature& call = *record.call;
        if (is(call, "rtRegisterShaderClass"))
            throw StreamError(
                "the recorded program has a shader class of its own: no source is "
                "written");
        const bool isTessellation = std::strncmp(call.name, "rtuTess", 7) == 0 ||
                                    std::strstr(call.name, "Tess") || is(call, "rtuBeginPolygon") ||
                                    is(call, "rtuNextContour") || is(call, "rtuEndPolygon");
        const bool isSeen = call.kind == CallKind::Query && names_.resultOf(number_).empty();
        if (isTessellation || isSeen) return;
        startPart();
        out_ << "    {\n";
        write(record);
        out_ << "    }\n";
    }
    void outcome(const RecordHead&, const OutcomeRecord&) override {}
    void picture(const RecordHead&, const PictureRecord& record) override {
        startPart();
        out_ << "    check(" << names_.frameBuffer(record.key) << ", "
             << uint64_t(record.width) * bytesOfFrameBufferPixel(record.format) << ", "
             << record.height << ", " << record.stride << ", UINT64_C(0x" << std::hex << record.hash
             << std::dec << "));\n";
    }
    void end() {
        if (part_ > 0) out_ << "}\n\n";
        out_ << "int main(void)\n{\n" << names_.reservations();
        for (unsigned i = 1; i <= part_; ++i) out_ << "    part_" << i << "();\n";
        out_ << "    printf(\"%d frames, %d of them not as recorded\\n\", frames, unequal);\n"
                "    return unequal ? 1 : 0;\n}\n";
    }

private:
    static bool is(const CallSignature& call, const char* name) {
        return std::strcmp(call.name, name) == 0;
    }

    void startPart() {
        if (inPart_ == kCallsOfAPart || part_ == 0) {
            if (part_ > 0) out_ << "}\n\n";
            out_ << "static void part_" << ++part_ << "(void)\n{\n";
            inPart_ = 0;
        }
        ++inPart_;
    }

    std::string nextName() { return std::string("d").append(std::to_string(block_++)); }

    /// Declares an array of the block; its name.
    std::string data(ValueKind element, std::span<const std::byte> bytes) {
        const std::string name = nextName();
        if (isExact(element, bytes)) {
            out_ << "        static const " << typeName(element) << ' ' << name << "[] = {"
                 << textOfElements(element, bytes, SIZE_MAX) << "};\n";
            return name;
        }
        // Of doubles' alignment.
        out_ << "        static const union { unsigned char bytes["
             << std::max<std::size_t>(bytes.size(), 1) << "]; double align; } " << name << " = {{"
             << (bytes.empty() ? "0" : textOfElements(ValueKind::UInt8, bytes, SIZE_MAX))
             << "}};\n";
        return name + ".bytes";
    }

    std::string number(const CallParameter& parameter, CallValue value) const {
        if (parameter.meaning >= Meaning::Object) {
            const uint64_t name =
                parameter.kind == ValueKind::UInt32 ? value.as<uint32_t>() : value.as<uint64_t>();
            const std::string variable = names_.variable(parameter.meaning, context_, name);
            if (!variable.empty()) return variable;
            if (parameter.meaning == Meaning::Context)
                return name ? "(RTcontext)(uintptr_t)-2" : "NULL";
        }
        return textOf(parameter, value);
    }

    std::string pieces(const CallParameter& parameter, const RecordedArgument& argument) {
        std::string list;
        for (const RecordedArgument& piece : argument.pieces)
            list += (list.empty() ? "" : ", ") + pointer(parameter, piece, nullptr);
        const std::string name = nextName();
        if (parameter.memory == Memory::Arguments)
            out_ << "        char *" << name << "[] = {" << list << (list.empty() ? "" : ", ")
                 << "NULL};\n        int count = " << argument.pieces.size() << ";\n";
        else
            out_ << "        const void *" << name << "[] = {" << (list.empty() ? "NULL" : list)
                 << "};\n";
        return name;
    }

    std::string pointer(const CallParameter& parameter, const RecordedArgument& argument,
                        const CallRecord* record) {
        const std::string offset = std::string("(const void *)(uintptr_t)")
                                       .append(std::to_string(argument.value.as<uint64_t>()))
                                       .append("u");
        switch (argument.tag) {
            case PointerTag::Null:
                return "NULL";
            case PointerTag::Unread:
                return parameter.memory == Memory::Array || parameter.memory == Memory::Callback
                           ? "NULL"
                           : data(ValueKind::Void, std::vector<std::byte>(64));
            case PointerTag::Number:
                if (parameter.memory == Memory::FrameBuffer ||
                    parameter.memory == Memory::AuxBuffer)
                    return names_.frameBuffer(argument.value.as<uint64_t>());
                if (parameter.memory == Memory::None) {
                    const std::string name =
                        names_.variable(parameter.meaning, context_, argument.value.as<uint64_t>());
                    return name.empty() ? "NULL" : name;
                }
                return offset;
            case PointerTag::Bytes: {
                if (parameter.memory == Memory::String || parameter.memory == Memory::Arguments) {
                    const std::string text = literalOf(argument.bytes);
                    return std::string(parameter.element == ValueKind::UInt8 ? "(const RTubyte *)"
                                                                             : "")
                        .append(text);
                }
                if (parameter.meaning >= Meaning::Object) return ids(parameter, argument.bytes);
                return data(parameter.element, argument.bytes);
            }
            case PointerTag::Output:
                return record ? output(parameter, *record) : "NULL";
            case PointerTag::Pieces:
                return pieces(parameter, argument);
        }
        return "NULL";
    }

    std::string ids(const CallParameter& parameter, std::span<const std::byte> bytes) {
        const std::string name = nextName();
        out_ << "        RTuint " << name << "[" << bytes.size() / 4 + 1 << "];\n";
        for (std::size_t i = 0; i + 4 <= bytes.size(); i += 4) {
            uint32_t id;
            std::memcpy(&id, bytes.data() + i, sizeof id);
            const std::string variable = names_.variable(parameter.meaning, context_, id);
            lines_.append("        ").append(name).append("[").append(std::to_string(i / 4));
            lines_.append("] = ").append(variable.empty() ? std::to_string(id) : variable);
            lines_.append(";\n");
        }
        return name;
    }

    std::string output(const CallParameter& parameter, const CallRecord& record) {
        if (parameter.memory == Memory::Scratch && is(*record.call, "rtInit")) return "&count";
        std::vector<CallValue> values;
        for (const RecordedArgument& argument : record.arguments) values.push_back(argument.value);
        const uint64_t bytes = memoryBytes(*record.call, parameter, values.data(), {});
        const std::string name = nextName();
        out_ << "        static double " << name << "[" << bytes / 8 + 64 << "];\n";
        return std::string("(void *)") + name;
    }

    void write(const CallRecord& record) {
        block_ = 0;
        lines_.clear();
        const CallSignature& call = *record.call;
        if (is(call, "rtArrayElement") && !record.arrays.empty()) return writeElement(record);
        std::string text;
        const std::span<const CallParameter> parameters = parametersOf(call);
        // argc of rtInit is declared with argv.
        for (std::size_t k = parameters.size(); k-- > 0;) {
            const RecordedArgument& argument = record.arguments[k];
            const bool isPointer = parameters[k].kind == ValueKind::Pointer;
            const bool isRead = is(call, "rtReadPixels") && isPointer;
            std::string value = isRead      ? ""
                                : isPointer ? pointer(parameters[k], argument, &record)
                                            : number(parameters[k], argument.value);
            if (is(call, "rtInit") && record.arguments[1].tag != PointerTag::Pieces) value = "NULL";
            text = value + (text.empty() || value.empty() ? "" : ", ") + text;
        }
        std::vector<std::string> arrays;
        for (const RecordedArray& array : record.arrays)
            arrays.push_back(data(kindOf(array), array.bytes));
        if (record.hasMapped) {
            const std::string mapped = data(ValueKind::Void, record.mapped);
            lines_.append("        write_mapped(")
                .append(number(parameters[0], record.arguments[0].value))
                .append(", ")
                .append(mapped)
                .append(", ")
                .append(std::to_string(record.mapped.size()))
                .append("u);\n");
        }
        if (!arrays.empty()) {
            out_ << "        RTint bound = 0;\n";
            lines_ +=
                "        rtGetIntegerv(RT_ARRAY_BUFFER_BINDING, &bound);\n"
                "        unbind();\n";
        }
        const bool hasUnits =
            std::any_of(record.arrays.begin(), record.arrays.end(), isTexCoord) && !arrays.empty();
        if (hasUnits) {
            out_ << "        RTint unit = 0;\n";
            lines_ += "        rtGetIntegerv(RT_CLIENT_ACTIVE_TEXTURE, &unit);\n";
        }
        out_ << lines_;
        for (std::size_t i = 0; i < arrays.size(); ++i)
            out_ << setArray(record.arrays[i], std::string("(const void *)((uintptr_t)")
                                                   .append(arrays[i])
                                                   .append(" - ")
                                                   .append(std::to_string(record.arrays[i].first *
                                                                          record.arrays[i].step()))
                                                   .append("u)"));
        if (!arrays.empty()) out_ << "        rtBindBuffer(RT_ARRAY_BUFFER, (RTuint)bound);\n";
        if (hasUnits) out_ << "        rtClientActiveTexture((RTenum)unit);\n";
        writeCall(record, text);
    }

    void writeCall(const CallRecord& record, const std::string& arguments) {
        const CallSignature& call = *record.call;
        const std::string result = names_.resultOf(number_);
        out_ << "        ";
        if (!result.empty()) out_ << result << " = ";
        if (is(call, "rtReadPixels") && record.arguments.back().tag == PointerTag::Output)
            out_ << "read_pixels(" << arguments << ");\n";
        else if (is(call, "rtReadPixels"))
            out_ << "rtReadPixels(" << arguments << ", NULL);\n";
        else
            out_ << call.name << '(' << arguments << ");\n";
    }

    static ValueKind kindOf(const RecordedArray& array) {
        const bool isPacked = array.step() == array.elementBytes();
        if (isPacked && array.type == RT_FLOAT) return ValueKind::Float;
        if (isPacked && array.type == RT_DOUBLE) return ValueKind::Double;
        return ValueKind::Void;
    }

    static bool isTexCoord(const RecordedArray& array) {
        return std::strcmp(arrayNames(array.kind)->pointer, "rtTexCoordPointer") == 0;
    }

    static std::string setArray(const RecordedArray& array, const std::string& from) {
        const ArrayNames& names = *arrayNames(array.kind);
        std::string text;
        if (isTexCoord(array))
            text += "        rtClientActiveTexture(" + tokenText(RT_TEXTURE0 + names.unit) + ");\n";
        text += std::string("        ") + names.pointer + "(";
        if (names.hasSize) text += std::to_string(array.size) + ", ";
        if (std::strcmp(names.pointer, "rtEdgeFlagPointer") != 0)
            text += tokenText(array.type) + ", ";
        return text + std::to_string(array.stride) + ", " + from + ");\n";
    }

    void writeElement(const CallRecord& record) {
        for (const RecordedArray& array : record.arrays) {
            const CallSignature* const call = immediateCall(array);
            if (!call) throw StreamError("a vertex array of a size or type that there is not");
            const std::span<const CallParameter> parameters = parametersOf(*call);
            const std::string name = data(parameters.back().element, array.bytes);
            const std::string unit =
                parameters.size() == 2
                    ? tokenText(RT_TEXTURE0 + arrayNames(array.kind)->unit) + ", "
                    : "";
            lines_ += std::string("        ") + call->name + "(" + unit + name + ");\n";
        }
        out_ << lines_;
    }

    const SourceNames& names_;
    std::ostream& out_;
    std::string lines_; ///< after the declarations of the block
    uint64_t number_ = 0;
    uint32_t context_ = 0;
    unsigned part_ = 0, inPart_ = 0, block_ = 0;
};

} // namespace

void writeSource(const TraceInput& input, std::ostream& out) {
    SourceNames names;
    visit(input, names);
    out << kHead << names.declarations() << '\n';
    SourceWriter writer(names, out);
    visit(input, writer);
    writer.end();
}

} // namespace smart::compat
