// SPDX-License-Identifier: MIT
//
// SceneSource: the scenes that a search renders next.
//
// Families take turns with a batch each; then comes a batch of scenes mutated from the corpus,
// which consists of given scenes and of the search's own finds. Surfaces alternate from round to
// round. The scenes depend only on the seed and on the corpus before the round. Finite families are
// dropped after their end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "generate/random_scenes.h"
#include "model/rule_id.h"
#include "model/scene.h"

namespace edgecase {

// ---------------------------------------------------------------------------------------- families

// A kind of random scenes among which a search looks for disagreements.
//
// A family concerns some rules. Each of its scenes depends only on seed, surface and index, on
// every machine, and is built round ties and boundaries where possible; so these three identify a
// find. Generators lie in src/generate.
struct Family {
  const char* name;   // "shared-edges"
  const char* about;  // a phrase
  std::vector<RuleId> rules;
  // Its scenes concern only coverage, so nothing else is requested of the renderer.
  bool coverage_only;
  bool has_windows;  // if not, its scenes are of framebuffer objects for either surface
  Scene (*scene)(std::uint64_t seed, Surface surface, std::uint64_t index);
  std::uint64_t scenes = 0;  // the number per surface; 0: unlimited
};

std::span<const Family> all_families();

// Null if there is none of that name.
const Family* find_family(const std::string& name);

// The families selected by names or rule ids (shell globs), in the order of all_families; all
// without patterns. If a pattern selects nothing, a sentence that lists all names.
std::variant<std::vector<const Family*>, std::string> select_families(
    std::span<const std::string> patterns);

// ---------------------------------------------------------------------------------------- mutation

// Mutation: a copy of a scene with a small change.
//
// Scenes near to one that shows something often show more: with a vertex moved by a sub-pixel step
// or onto the next tie, a primitive removed or doubled, another order, width or number of samples,
// or everything transposed, mirrored or moved by whole pixels.

// Applies one to three changes. A case file can express the result, so its coordinates reach OpenGL
// unrounded; nothing if no such scene was found in a few tries. The result depends only on the
// scene and the random numbers. Vertices given as clip coordinates are not moved.
std::optional<Scene> mutated(const Scene& scene, RandomSource& random);

// ------------------------------------------------------------------------------------------ source

// The origin of a scene, from which it can be made again.
struct SceneOrigin {
  std::string family;  // "mutated": of no family
  Surface surface = Surface::fbo;
  std::uint64_t index = 0;
  std::string parent;  // what a mutated scene was mutated from
};

// "lines, seed 1, index 123, window"; "mutated from lines/short/between-diamonds, seed 1, index 7".
std::string describe(const SceneOrigin& origin, std::uint64_t seed);

struct CorpusScene {
  std::string name;  // id of a case, or title of a find
  Scene scene;
};

inline constexpr const char* kMutated = "mutated";

// Consecutive scenes of one family and surface.
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
  static constexpr std::size_t kBatch = 256;  // scenes per batch at most

  // There must be at least one surface. Without families all scenes are mutated.
  SceneSource(std::uint64_t seed, std::vector<const Family*> families,
              std::vector<Surface> surfaces, std::vector<CorpusScene> corpus);
  // Only scenes of families: nothing is mutated, whatever is added to the corpus.
  SceneSource(std::uint64_t seed, std::vector<const Family*> families,
              std::vector<Surface> surfaces);

  // The next batch of each family, and one of mutated scenes if there is a corpus: at most `most`
  // scenes in total. Empty if nothing is left.
  std::vector<Batch> next_round(std::size_t most);

  // The scene at `place` of a batch of the latest round; nothing if no mutation was found. Callable
  // from any thread.
  std::optional<SourcedScene> scene(const Batch& batch, std::size_t place) const;

  // Takes effect in the next round.
  void add_to_corpus(CorpusScene scene);
  // Drops a family whose scenes no renderer draws.
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
