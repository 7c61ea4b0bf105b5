// SPDX-License-Identifier: MIT
#include <fstream>
#include <memory>
#include <optional>
#include <set>

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

// A program of both, which runs when its first answer is wanted.
class Questions {
public:
    Questions(const Settings& settings, std::string program)
        : settings_(settings), program_(std::move(program)) {
        std::ifstream listed(settings.openGlPrograms / (program_ + ".cases"));
        for (std::string section; std::getline(listed, section);) sections_.insert(section);
    }

    // As the build listed them.
    const std::set<std::string>& sections() const { return sections_; }
    std::string nameOf(const std::string& section) const { return program_ + "/" + section; }

    Result compare(const std::string& section) {
        Result result{nameOf(section), {}, {}, {}};
        const auto expected = answers().openGl.find(section);
        const auto found = answers().openRt.find(section);
        if (expected == answers().openGl.end() || found == answers().openRt.end()) {
            result.failures.push_back("not answered. " + answers().failure);
            return result;
        }
        const std::string difference = firstDifference(expected->second, found->second);
        if (!difference.empty()) result.failures.push_back(difference);
        return result;
    }

    // Whether both ran to their ends, and had no section that the build did not list.
    Result compareEnds() {
        Result result{nameOf("ends"), {}, {}, {}};
        if (!answers().failure.empty()) result.failures.push_back(answers().failure);
        for (const Transcript* const transcript : {&answers().openGl, &answers().openRt})
            for (const auto& [section, lines] : *transcript)
                if (!sections_.contains(section))
                    result.failures.push_back("answers " + section + ", which was not listed");
        return result;
    }

private:
    const Answers& answers() {
        if (!answers_) answers_ = ask(settings_, program_);
        return *answers_;
    }

    const Settings& settings_;
    std::string program_;
    std::set<std::string> sections_;
    std::optional<Answers> answers_;
};

} // namespace

std::vector<Case> transcriptCases(const Settings& settings) {
    std::vector<Case> cases;
    for (const char* const program : kPrograms) {
        const auto questions = std::make_shared<Questions>(settings, program);
        for (const std::string& section : questions->sections())
            cases.push_back(
                {questions->nameOf(section), [=] { return questions->compare(section); }});
        cases.push_back({questions->nameOf("ends"), [=] { return questions->compareEnds(); }});
    }
    return cases;
}

} // namespace conformance
