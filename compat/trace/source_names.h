// SPDX-License-Identifier: MIT
// What a program written from a recording has to declare first.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "compat/trace/trace_input.h"

namespace smart::compat {

/// The variables of the written program: a name for whatever the library returned, memory for
/// pictures; and what each call was told to have returned.
class SourceNames final : public TraceVisitor {
public:
    void call(const RecordHead& head, const CallRecord& record) override;
    void outcome(const RecordHead& head, const OutcomeRecord& record) override;
    void picture(const RecordHead&, const PictureRecord&) override {}

    /// Of a name that the library returned before; "" for others.
    std::string variable(Meaning meaning, uint32_t context, uint64_t name) const;
    /// Of what the call with this number, from 1, returned; "": nothing that is named.
    std::string resultOf(uint64_t call) const;
    std::string frameBuffer(uint64_t key) const;
    /// Declarations of all.
    std::string declarations() const;
    /// Statements that reserve the pictures' memory.
    std::string reservations() const;

private:
    struct Targets {
        uint64_t key = 0, width = 0, height = 0, pixel = 0, stride = 0;
        std::set<uint64_t> aux;
    };
    void follow(const RecordHead& head, const CallRecord& record);

    uint64_t calls_ = 0;
    std::vector<uint64_t> open_; ///< by depth, the number of the call under way
    std::map<uint64_t, std::string> results_;
    std::set<std::string> variables_, contexts_, quadrics_;
    std::map<uint32_t, Targets> targets_;
    std::map<uint64_t, uint64_t> bytes_; ///< of frame buffers, by key
};

} // namespace smart::compat
