// SPDX-License-Identifier: MIT
#include "compat/trace/call_listing.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <map>
#include <ostream>
#include <set>
#include <utility>

#include "compat/stream/call_memory.h"
#include "compat/trace/call_text.h"

namespace smart::compat {

namespace {

constexpr std::size_t kShown = 16; ///< elements of an array

std::string textOfPointer(const CallParameter& parameter, const RecordedArgument& argument) {
    switch (argument.tag) {
        case PointerTag::Null:
            return "NULL";
        case PointerTag::Unread:
            return "pointer";
        case PointerTag::Output:
            return "result";
        case PointerTag::Number:
            return std::string("#").append(std::to_string(argument.value.as<uint64_t>()));
        case PointerTag::Bytes:
            if (parameter.element == ValueKind::Int8 || parameter.memory == Memory::String ||
                parameter.memory == Memory::ShaderDescriptor)
                return literalOf(argument.bytes);
            return std::string("{")
                .append(textOfElements(parameter.element, argument.bytes, kShown))
                .append("}");
        case PointerTag::Pieces: {
            std::string text = "{";
            for (const RecordedArgument& piece : argument.pieces) {
                if (text.size() > 1) text += ", ";
                text += textOfPointer(parameter, piece);
            }
            return text + "}";
        }
    }
    return "?";
}

std::string callText(const CallRecord& record) {
    std::string text = std::string(record.call->name) + "(";
    const std::span<const CallParameter> parameters = parametersOf(*record.call);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (i > 0) text += ", ";
        const RecordedArgument& argument = record.arguments[i];
        text += parameters[i].kind == ValueKind::Pointer ? textOfPointer(parameters[i], argument)
                                                         : textOf(parameters[i], argument.value);
    }
    text += ")";
    for (const RecordedArray& array : record.arrays)
        text.append(" ")
            .append(arrayNames(array.kind)->immediate)
            .append("[")
            .append(std::to_string(array.elements))
            .append("]");
    if (record.hasMapped)
        text.append(" ").append(std::to_string(record.mapped.size())).append(" bytes written");
    return text;
}

std::string hexadecimal(uint64_t number) {
    char text[20];
    std::snprintf(text, sizeof text, "%016" PRIx64, number);
    return text;
}

class Listing final : public TraceVisitor {
public:
    explicit Listing(std::ostream& out) : out_(out) {}
    void call(const RecordHead& head, const CallRecord& record) override {
        out_ << ++number_ << ' ' << head.thread << ':' << head.context << ' '
             << std::string(2u * head.depth, ' ') << callText(record) << '\n';
    }
    void outcome(const RecordHead& head, const OutcomeRecord& record) override {
        out_ << "    " << std::string(2u * head.depth, ' ') << record.call->name;
        if (record.call->result != ValueKind::Void)
            out_ << " = "
                 << textOf(record.call->result == ValueKind::Pointer ? ValueKind::UInt64
                                                                     : record.call->result,
                           record.result);
        for (const RTuint name : record.names) out_ << ' ' << name;
        if (record.error != RT_NO_ERROR) out_ << ", " << errorText(record.error);
        out_ << '\n';
    }
    void picture(const RecordHead&, const PictureRecord& record) override {
        out_ << "    frame " << ++frame_ << ": " << record.width << "x" << record.height << ' '
             << tokenText(record.format) << " #" << record.key << " hash "
             << hexadecimal(record.hash) << '\n';
    }

private:
    std::ostream& out_;
    uint64_t number_ = 0, frame_ = 0;
};

class Summary final : public TraceVisitor {
public:
    void call(const RecordHead& head, const CallRecord& record) override {
        ++calls_;
        Share& share = shares_[record.call->name];
        ++share.calls;
        share.bytes += head.bytes;
        threads_.insert(head.thread);
        if (head.context != 0) contexts_.insert(head.context);
    }
    void outcome(const RecordHead& head, const OutcomeRecord& record) override {
        shares_[record.call->name].bytes += head.bytes;
        errors_ += record.error != RT_NO_ERROR;
    }
    void picture(const RecordHead&, const PictureRecord&) override { ++frames_; }

    void print(const TraceInput& input, const std::string& version, std::ostream& out) const {
        out << "recorded by OpenRT " << version << '\n'
            << "calls: " << calls_ << "\nframes: " << frames_ << "\nerrors: " << errors_
            << "\nthreads: " << threads_.size() << "\ncontexts: " << contexts_.size()
            << "\nbytes: " << input.bytes() << '\n';
        if (input.isCutOff()) out << "the end is missing: the program did not end by itself\n";
        std::vector<std::pair<std::string, Share>> sorted(shares_.begin(), shares_.end());
        std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
            return a.second.bytes > b.second.bytes;
        });
        for (const auto& [name, share] : sorted)
            out << "  " << name << ": " << share.calls << ", " << share.bytes << " bytes\n";
    }

private:
    struct Share {
        uint64_t calls = 0, bytes = 0;
    };
    std::map<std::string, Share> shares_;
    std::set<uint16_t> threads_;
    std::set<uint32_t> contexts_;
    uint64_t calls_ = 0, frames_ = 0, errors_ = 0;
};

} // namespace

void listCalls(const TraceInput& input, std::ostream& out) {
    Listing listing(out);
    visit(input, listing);
}

void summarise(const TraceInput& input, std::ostream& out) {
    Summary summary;
    const std::string version = visit(input, summary);
    summary.print(input, version, out);
}

} // namespace smart::compat
