// SPDX-License-Identifier: MIT
//
//   fuzz_replay TARGET INPUTS FILE FOLDER...
//
// Gives a fuzz target the files of some folders, in the order of their names, and then INPUTS
// spoilt ones of them, the same each time. No compiler has to know libFuzzer for that. FILE holds
// the input that is asked while it is asked, and is removed in the end: where the process dies, or
// is killed since it takes too long or too much memory, it is what did it.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "tests/fuzz/mutator.h"
#include "tests/fuzz/target.h"

// Each target's entry point, under the name that CMakeLists.txt gives it.
extern "C" {
int edgecase_fuzz_answer(const std::uint8_t* data, std::size_t size);
int edgecase_fuzz_case_file(const std::uint8_t* data, std::size_t size);
int edgecase_fuzz_compare(const std::uint8_t* data, std::size_t size);
int edgecase_fuzz_decisions(const std::uint8_t* data, std::size_t size);
int edgecase_fuzz_known_faults(const std::uint8_t* data, std::size_t size);
int edgecase_fuzz_image(const std::uint8_t* data, std::size_t size);
int edgecase_fuzz_mesh(const std::uint8_t* data, std::size_t size);
int edgecase_fuzz_policy(const std::uint8_t* data, std::size_t size);
int edgecase_fuzz_recording(const std::uint8_t* data, std::size_t size);
int edgecase_fuzz_results(const std::uint8_t* data, std::size_t size);
}

namespace {

using namespace edgecase;
namespace fs = std::filesystem;

using Target = int(const std::uint8_t* data, std::size_t size);

constexpr unsigned kSecondsOfAnInput = 60;
// Sanitizers take far more address space than memory.
#if !defined(__SANITIZE_ADDRESS__)
constexpr rlim_t kMostMemory = rlim_t{4} << 30;
#endif

// Keeps no promise about brackets: with it the replay shows that it finds what there is to find.
int balanced(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = text_of(data, size);
  promise(std::count(text.begin(), text.end(), '{') == std::count(text.begin(), text.end(), '}'),
          "as many brackets close as open");
  return 0;
}

const std::map<std::string, Target*> kTargets{
    {"answer", edgecase_fuzz_answer},       {"balanced", balanced},
    {"case_file", edgecase_fuzz_case_file}, {"compare", edgecase_fuzz_compare},
    {"decisions", edgecase_fuzz_decisions}, {"known_faults", edgecase_fuzz_known_faults},
    {"image", edgecase_fuzz_image},         {"mesh", edgecase_fuzz_mesh},
    {"policy", edgecase_fuzz_policy},       {"recording", edgecase_fuzz_recording},
    {"results", edgecase_fuzz_results}};

std::vector<std::string> contents_of(char** first, char** last) {
  std::vector<fs::path> paths;
  for (char** folder = first; folder != last; ++folder)
    for (const auto& entry : fs::directory_iterator(*folder)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> contents;
  for (const fs::path& path : paths) {
    std::ifstream stream(path, std::ios::binary);
    contents.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    if (contents.back().empty()) contents.pop_back();
  }
  return contents;
}

class Replay {
 public:
  Replay(Target* target, const char* file)
      : target_(target), file_(file), descriptor_(open(file, O_CREAT | O_RDWR, 0644)) {
    promise(descriptor_ >= 0, "the input's file can be written");
  }
  Replay(const Replay&) = delete;
  Replay& operator=(const Replay&) = delete;
  ~Replay() {
    close(descriptor_);
    unlink(file_);
  }

  void ask(const std::string& input) {
    const bool kept =
        ftruncate(descriptor_, 0) == 0 &&
        pwrite(descriptor_, input.data(), input.size(), 0) == static_cast<ssize_t>(input.size());
    promise(kept, "the input can be kept");
    alarm(kSecondsOfAnInput);  // the signal ends the process
    target_(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
  }

 private:
  Target* target_;
  const char* file_;
  int descriptor_;
};

}  // namespace

int main(int count, char** arguments) {
  if (count < 5) {
    fmt::print(stderr, "usage: fuzz_replay TARGET INPUTS FILE FOLDER...\n");
    return 2;
  }
  const auto target = kTargets.find(arguments[1]);
  std::size_t inputs = 0;
  const char* end = arguments[2] + std::strlen(arguments[2]);
  const bool numbered = std::from_chars(arguments[2], end, inputs).ptr == end;
  const std::vector<std::string> files = contents_of(arguments + 4, arguments + count);
  if (target == kTargets.end() || !numbered || files.empty()) {
    fmt::print(stderr, "no such target, no number of inputs, or no files to begin with\n");
    return 2;
  }
#if !defined(__SANITIZE_ADDRESS__)
  const rlimit memory{kMostMemory, kMostMemory};
  promise(setrlimit(RLIMIT_AS, &memory) == 0, "memory can be limited");
#endif
  Replay replay(target->second, arguments[3]);
  for (const std::string& file : files) replay.ask(file);
  Mutator mutator(files, 12);
  for (std::size_t i = 0; i < inputs; ++i) replay.ask(mutator.next());
  fmt::print("{}: {} files and {} spoilt ones\n", arguments[1], files.size(), inputs);
  return 0;
}
