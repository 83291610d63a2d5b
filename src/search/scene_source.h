// SPDX-License-Identifier: MIT
//
// SceneSource: which scenes a search asks next.
//
// Families take turns, a batch each; then comes a batch of scenes that are mutated from the corpus:
// from scenes that were given, and from finds of the search itself, as they join it. Surfaces
// alternate from round to round. Which scenes come depends on the seed and on what joined the
// corpus before the round, and on nothing else. Families that have an end come no more after it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "generate/random_source.h"
#include "model/rule_id.h"
#include "model/scene.h"

namespace edgecase {

// ---------------------------------------------------------------------------------------- families

// A kind of random scenes among which a search looks for disagreements.
//
// A family is about some rules. Each of its scenes is a function of seed, surface and index alone,
// on every machine, built round ties and boundaries where it can be; so a find is named by these
// three. Most generators are those by which renderers are measured (src/generate, src/profile).
struct Family {
  const char* name;   // "shared-edges"
  const char* about;  // a phrase
  std::vector<RuleId> rules;
  // What its scenes are about is coverage: nothing else is asked of the renderer.
  bool coverage_only;
  bool has_windows;  // else its scenes are of framebuffer objects, whatever surface is given
  Scene (*scene)(std::uint64_t seed, Surface surface, std::uint64_t index);
  std::uint64_t scenes = 0;  // how many there are, on each surface; 0: there is no end of them
};

std::span<const Family> all_families();

// Null when there is none of that name.
const Family* find_family(const std::string& name);

// The families that names or rule ids mean, shell globs allowed, in the order of all_families and
// each once; none given: all. A sentence with all that is known where one means nothing.
std::variant<std::vector<const Family*>, std::string> select_families(
    std::span<const std::string> patterns);

// ---------------------------------------------------------------------------------------- mutation

// Mutation: a scene that is another one but for a small change.
//
// Scenes near to one that shows something often show more: a vertex a sub-pixel step
// further on, or upon the next tie; a primitive less, or twice; another order, width, number of
// samples; the whole transposed, mirrored or moved by whole pixels.

// One to three changes. The scene is what a case file can say, so that all of its coordinates reach
// OpenGL unrounded; none where no such scene was found in a few tries. A function of the scene and
// the numbers alone. Vertices given as clip coordinates stay where they are.
std::optional<Scene> mutated(const Scene& scene, RandomSource& random);

// ------------------------------------------------------------------------------------------ source

// Where a scene came from, so that it can be made again.
struct SceneOrigin {
  std::string family;  // "mutated": of no family
  Surface surface = Surface::fbo;
  std::uint64_t index = 0;
  std::string parent;  // of a mutated scene: what it was mutated from
};

// "lines, seed 1, index 123, window"; "mutated from lines/short/between-diamonds, seed 1, index 7".
std::string describe(const SceneOrigin& origin, std::uint64_t seed);

struct CorpusScene {
  std::string name;  // id of a case, or words of a find
  Scene scene;
};

inline constexpr const char* kMutated = "mutated";

// Scenes of one family and surface that follow each other.
struct Batch {
  const Family* family = nullptr;  // null: mutated ones
  Surface surface = Surface::fbo;  // of a family
  std::uint64_t first = 0;         // index
  std::size_t count = 0;
};

struct SourcedScene {
  Scene scene;
  SceneOrigin origin;
};

class SceneSource {
 public:
  static constexpr std::size_t kBatch = 256;  // scenes of a batch at most

  // Surfaces: at least one. Without families all scenes are mutated.
  SceneSource(std::uint64_t seed, std::vector<const Family*> families,
              std::vector<Surface> surfaces, std::vector<CorpusScene> corpus);
  // The scenes of families and no others: nothing is mutated, whatever joins the corpus.
  SceneSource(std::uint64_t seed, std::vector<const Family*> families,
              std::vector<Surface> surfaces);

  // The next batch of each family, and one of mutated scenes where there is a corpus: `most` scenes
  // together at most. Empty when nothing is left to ask.
  std::vector<Batch> next_round(std::size_t most);

  // The scene at `place` of a batch of the latest round; none where no mutation was found. May be
  // called from any thread.
  std::optional<SourcedScene> scene(const Batch& batch, std::size_t place) const;

  // From the next round on.
  void add_to_corpus(CorpusScene scene);
  // The family comes no more: no renderer draws its scenes.
  void retire(const Family& family);

 private:
  struct Progress {
    const Family* family;
    std::vector<std::uint64_t> asked;  // by surface
  };

  std::uint64_t seed_;
  std::vector<Progress> families_;
  std::vector<Surface> surfaces_;
  std::vector<CorpusScene> corpus_;
  bool mutates_ = true;
  std::uint64_t mutated_ = 0;
  std::size_t round_ = 0;
};

}  // namespace edgecase
