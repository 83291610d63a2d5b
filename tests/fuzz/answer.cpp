// SPDX-License-Identifier: MIT
//
// Answers of exec: programs and workers, and what a recording keeps of them, to one of a few
// scenes: the input's first byte is its number.
#include <array>
#include <vector>

#include "casefile/loader.h"
#include "recording/recording.h"
#include "tests/fuzz/target.h"
#include "wire/answer_line.h"
#include "wire/request_line.h"

namespace {

using namespace edgecase;

struct Asked {
  Scene scene;
  std::string digest;
};

// The base cases of the files that fuzz.py lists as SCENES, in its order.
std::vector<Asked> asked_scenes() {
  std::vector<Asked> result;
  for (const char* name : {EDGECASE_FUZZ_SCENES}) {
    const std::string file = std::string(EDGECASE_ROOT "/cases/") + name + ".json";
    LoadedCases loaded = load_cases(file, name);
    promise(!loaded.cases.empty(), "the suite has the scenes");
    Scene scene = std::move(loaded.cases.front().scene);
    std::string digest = digest_of(scene_json(scene));
    result.push_back({std::move(scene), std::move(digest)});
  }
  return result;
}

void check(const Outcome& outcome, const Scene& scene) {
  if (const auto* failure = std::get_if<Failure>(&outcome)) {
    promise(!failure->reason.empty(), "a failure has a reason");
    return;
  }
  const Rendering& rendering = std::get<Rendering>(outcome);
  promise(rendering.width == scene.target.width && rendering.height == scene.target.height,
          "a rendering has the scene's size");
  for (const Fragment& fragment : rendering.fragments)
    promise(fragment.x >= 0 && fragment.x < rendering.width && fragment.y >= 0 &&
                fragment.y < rendering.height,
            "fragments lie in the target");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::vector<Asked> asked = asked_scenes();
  if (size == 0) return 0;
  const Asked& one = asked[data[0] % asked.size()];
  const std::string line(text_of(data + 1, size - 1));
  for (const bool coverage_only : {false, true}) {
    const auto read = parse_answer(line, one.digest, one.scene, coverage_only);
    if (const auto* answer = std::get_if<Answer>(&read)) check(answer->outcome, one.scene);
  }
  check(recording::outcome_of(line, one.scene), one.scene);
  return 0;
}
