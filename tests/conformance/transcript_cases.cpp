// SPDX-License-Identifier: MIT
#include <memory>

#include "tests/conformance/child_process.h"
#include "tests/conformance/conformance_case.h"
#include "tests/conformance/tested_library.h"
#include "tests/conformance/transcript.h"

namespace conformance {
namespace {

constexpr const char* kPrograms[] = {
    "attributes", "errors",  "feedback", "fragments", "images",        "levels",     "multitexture",
    "primitives", "queries", "sampling", "state",     "texture_units", "wrong_calls"};

struct Answers {
    Transcript openGl, openRt;
    std::string failure; // of one of the programs
};

Answers ask(const Settings& settings, const std::string& program) {
    Answers answers;
    const std::string first = settings.openGlPrograms / program;
    const std::string second = settings.openRtPrograms / program;
    const Outcome openGl =
        runProgram({first, "--rt-offscreen", "1"},
                   {"LP_NUM_THREADS=0", "ASAN_OPTIONS=detect_leaks=0"}, settings.seconds);
    const Outcome openRt =
        runProgram({second, "--rt-offscreen", "1"}, withLibrary(settings), settings.seconds);
    answers.openGl = parseTranscript(openGl.output);
    answers.openRt = parseTranscript(openRt.output);
    answers.failure = openGl.failure(first) + openRt.failure(second);
    return answers;
}

Result compareAnswers(const Answers& answers, const std::string& name, const std::string& section) {
    Result result{name, {}, {}, {}};
    const auto found = answers.openRt.find(section);
    if (found == answers.openRt.end()) {
        result.failures.push_back("not answered. " + answers.failure);
        return result;
    }
    const std::string difference = firstDifference(answers.openGl.at(section), found->second);
    if (!difference.empty()) result.failures.push_back(difference);
    return result;
}

} // namespace

// The sections are known once the programs ran; their cases only look up what was said.
std::vector<Case> transcriptCases(const Settings& settings) {
    std::vector<Case> cases;
    for (const std::string program : kPrograms) {
        const auto answers = std::make_shared<Answers>(ask(settings, program));
        if (!answers->failure.empty())
            cases.push_back({program + "/ends", [=] {
                                 return Result{program + "/ends", {answers->failure}, {}, {}};
                             }});
        for (const auto& section : answers->openGl) {
            const std::string name = program + "/" + section.first;
            cases.push_back(
                {name, [=, key = section.first] { return compareAnswers(*answers, name, key); }});
        }
    }
    return cases;
}

} // namespace conformance
