// SPDX-License-Identifier: MIT
// Runs a fuzz target over files and folders of files, without libFuzzer: what the ordinary tests do
// with the corpora. Without any file it fails.
//
//     fuzz_NAME [--random SECONDS SEED] FILE...   then inputs made of theirs by random changes
//
// The random input under way is in fuzz_NAME.input, for it may be the last.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<uint8_t>;

Bytes replay(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> text(std::istreambuf_iterator<char>(file), {});
    const Bytes bytes(text.begin(), text.end());
    std::printf("%s\n", path.c_str());
    std::fflush(stdout); // the last line names the input that crashes
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    return bytes;
}

/// Some bytes are changed, put in or left out, or come from another input.
Bytes changed(const std::vector<Bytes>& inputs, std::mt19937& random) {
    constexpr std::size_t kMost = 4096;
    Bytes bytes = inputs[random() % inputs.size()];
    for (auto changes = 1 + random() % 8; changes > 0; --changes) {
        if (bytes.empty()) bytes.push_back(0);
        const auto at = bytes.begin() + std::ptrdiff_t(random() % bytes.size());
        const Bytes& other = inputs[random() % inputs.size()];
        switch (random() % 5) {
            case 0:
                *at = uint8_t(random());
                break;
            case 1:
                *at ^= uint8_t(1u << random() % 8);
                break;
            case 2:
                bytes.insert(at, uint8_t(random()));
                break;
            case 3:
                bytes.erase(at);
                break;
            default:
                if (other.empty()) break;
                const auto from = other.begin() + std::ptrdiff_t(random() % other.size());
                bytes.insert(at, from, from + std::ptrdiff_t(random() % std::size_t(
                                                                  other.end() - from)));
                break;
        }
        bytes.resize(std::min(bytes.size(), kMost));
    }
    return bytes;
}

void runRandom(const std::vector<Bytes>& inputs, int seconds, unsigned seed,
               const std::string& program) {
    using Clock = std::chrono::steady_clock;
    std::mt19937 random(seed);
    const auto end = Clock::now() + std::chrono::seconds(seconds);
    unsigned long executions = 0;
    for (; Clock::now() < end; ++executions) {
        const Bytes bytes = changed(inputs, random);
        std::ofstream(program + ".input", std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    }
    std::printf("%lu random inputs\n", executions);
}

} // namespace

int main(int argc, char* argv[]) {
    const bool isRandom = argc > 3 && std::strcmp(argv[1], "--random") == 0;
    std::vector<Bytes> inputs;
    for (int i = isRandom ? 4 : 1; i < argc; ++i) {
        if (!std::filesystem::is_directory(argv[i])) {
            inputs.push_back(replay(argv[i]));
            continue;
        }
        for (const auto& entry : std::filesystem::directory_iterator(argv[i]))
            if (entry.is_regular_file()) inputs.push_back(replay(entry.path()));
    }
    std::printf("%zu inputs\n", inputs.size());
    if (isRandom && !inputs.empty())
        runRandom(inputs, std::atoi(argv[2]), unsigned(std::atoi(argv[3])),
                  std::filesystem::path(argv[0]).filename());
    return inputs.empty() ? 1 : 0;
}
