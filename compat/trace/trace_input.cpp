// SPDX-License-Identifier: MIT
#include "compat/trace/trace_input.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "compat/stream/call_player.h"

namespace smart::compat {

TraceInput::TraceInput(const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code unknown;
    const fs::file_status status = fs::status(path, unknown);
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw StreamError(path + ": only a file can be read, not a folder or a device");
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const auto check = [&] {
        if (!file) throw StreamError(path + ": " + std::strerror(errno));
    };
    check();
    bytes_.resize(std::size_t(file.tellg()));
    file.seekg(0);
    file.read(reinterpret_cast<char*>(bytes_.data()), std::streamsize(bytes_.size()));
    check();
    whole_ = bytesOfWholeRecords(bytes_);
    constexpr std::size_t kMagicAt = sizeof(RecordHead);
    if (whole_ < kMagicAt + sizeof kStreamMagic ||
        std::memcmp(bytes_.data() + kMagicAt, kStreamMagic, sizeof kStreamMagic) != 0)
        throw StreamError(path + ": no recording of calls");
}

std::span<const std::byte> TraceInput::records() const {
    return std::span(bytes_).first(whole_);
}

std::string visit(const TraceInput& input, TraceVisitor& visitor) {
    std::span<const std::byte> rest = input.records();
    CallReader reader;
    CallRecord call;
    while (!rest.empty()) {
        RecordHead head;
        const std::span<const std::byte> record = takeRecord(rest, head);
        switch (head.kind) {
        case RecordKind::Start: reader.readStart(record); break;
        case RecordKind::Call:
            reader.readCall(record, call);
            visitor.call(head, call);
            break;
        case RecordKind::Outcome: visitor.outcome(head, reader.readOutcome(record)); break;
        case RecordKind::Picture:
            visitor.picture(head, CallReader::readPicture(record));
            break;
        default: throw StreamError("a record of a kind that there is not");
        }
    }
    return reader.libraryVersion();
}

} // namespace smart::compat
