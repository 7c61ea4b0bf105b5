// SPDX-License-Identifier: MIT
#include "compat/trace/source_names.h"

#include <algorithm>
#include <cstring>

#include "compat/stream/call_memory.h"
#include "compat/stream/call_player.h"

namespace smart::compat {

namespace {

constexpr uint64_t kMostMemory = uint64_t(1) << 32;

std::string nameOf(Meaning meaning, uint32_t context, uint64_t name) {
    const char* kind = nullptr;
    switch (meaning) {
    case Meaning::Object: kind = "object"; break;
    case Meaning::Shader: kind = "shader"; break;
    case Meaning::ShaderClass: kind = "shader_class"; break;
    case Meaning::ParameterHandle: kind = "parameter"; break;
    case Meaning::Scene: kind = "scene"; break;
    case Meaning::Frame: return std::string("frame_").append(std::to_string(name));
    case Meaning::QueryScene: return std::string("compiled_scene_").append(std::to_string(name));
    case Meaning::Context: return std::string("context_").append(std::to_string(name));
    case Meaning::Quadric: return std::string("quadric_").append(std::to_string(name));
    default: return "";
    }
    return std::string(kind) + "_" + std::to_string(context) + "_" + std::to_string(name);
}

} // namespace

void SourceNames::call(const RecordHead& head, const CallRecord& record) {
    ++calls_;
    if (head.thread != 0)
        throw StreamError("the recorded program has several threads: no source is written");
    open_.resize(std::size_t(head.depth) + 1);
    open_.back() = calls_;
    follow(head, record);
}

void SourceNames::follow(const RecordHead& head, const CallRecord& record) {
    Targets& targets = targets_[head.context];
    const auto number = [&](std::size_t i) {
        return uint64_t(std::max<int64_t>(
            integerOf(parametersOf(*record.call)[i].kind, record.arguments[i].value), 0));
    };
    const char* const name = record.call->name;
    if (std::strcmp(name, "rtSetFrameBuffer") == 0 &&
        record.arguments[0].tag == PointerTag::Number) {
        targets.key = record.arguments[0].value.as<uint64_t>();
        targets.width = number(1);
        targets.height = number(2);
        targets.pixel = bytesOfFrameBufferPixel(RTenum(number(3)));
    } else if (std::strcmp(name, "rtFrameBufferStride") == 0) {
        targets.stride = number(0);
    } else if (std::strcmp(name, "rtSetAuxBuffer") == 0 &&
               record.arguments[1].tag == PointerTag::Number) {
        targets.aux.insert(record.arguments[1].value.as<uint64_t>());
    } else {
        return;
    }
    const auto reserve = [this](uint64_t key, uint64_t bytes) {
        if (key != 0) bytes_[key] = std::max(bytes_[key], std::min(bytes, kMostMemory));
    };
    constexpr uint64_t kMostSide = 1 << 24;
    const uint64_t width = std::min(targets.width, kMostSide),
                   height = std::min(targets.height, kMostSide);
    reserve(targets.key, std::max(width * targets.pixel, targets.stride) * height);
    for (const uint64_t key : targets.aux) reserve(key, width * height * 12);
}

void SourceNames::outcome(const RecordHead& head, const OutcomeRecord& record) {
    const Meaning meaning = record.call->resultMeaning;
    if (head.depth >= open_.size() || record.error != RT_NO_ERROR) return;
    const auto result = record.result.as<uint64_t>();
    const std::string name = result ? nameOf(meaning, head.context, result) : "";
    if (name.empty()) return;
    results_[open_[head.depth]] = name;
    if (meaning == Meaning::Context)
        contexts_.insert(name);
    else if (meaning == Meaning::Quadric)
        quadrics_.insert(name);
    else
        variables_.insert(name);
}

std::string SourceNames::variable(Meaning meaning, uint32_t context, uint64_t name) const {
    const std::string text = nameOf(meaning, context, name);
    const bool known =
        variables_.contains(text) || contexts_.contains(text) || quadrics_.contains(text);
    return known ? text : "";
}

std::string SourceNames::resultOf(uint64_t call) const {
    const auto found = results_.find(call);
    return found == results_.end() ? "" : found->second;
}

std::string SourceNames::frameBuffer(uint64_t key) const {
    return std::string("pixels_").append(std::to_string(key));
}

std::string SourceNames::declarations() const {
    std::string text;
    const auto declare = [&text](const char* type, const std::string& name) {
        text.append("static ").append(type).append(name).append(";\n");
    };
    for (const std::string& name : variables_) declare("RTuint ", name);
    for (const std::string& name : contexts_) declare("RTcontext ", name);
    for (const std::string& name : quadrics_) declare("RTUquadric *", name);
    for (const auto& [key, bytes] : bytes_) declare("void *", frameBuffer(key));
    return text;
}

std::string SourceNames::reservations() const {
    std::string text;
    for (const auto& [key, bytes] : bytes_)
        text.append("    ")
            .append(frameBuffer(key))
            .append(" = calloc(1, ")
            .append(std::to_string(std::max<uint64_t>(bytes, 64)))
            .append("u);\n");
    return text;
}

} // namespace smart::compat
