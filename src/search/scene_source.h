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
#include <string>
#include <vector>

#include "model/scene.h"
#include "search/families.h"

namespace edgecase {

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
