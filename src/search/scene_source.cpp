// SPDX-License-Identifier: MIT
#include "search/scene_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "generate/random_scenes.h"
#include "search/mutation.h"

namespace edgecase {
namespace {

// Far from the streams of generators.
constexpr std::uint64_t kMutationStream = 0x6400;

}  // namespace

std::string describe(const SceneOrigin& origin, std::uint64_t seed) {
  const char* const window = origin.surface == Surface::window ? ", window" : "";
  if (origin.parent.empty())
    return fmt::format("{}, seed {}, index {}{}", origin.family, seed, origin.index, window);
  return fmt::format("mutated from {}, seed {}, index {}{}", origin.parent, seed, origin.index,
                     window);
}

SceneSource::SceneSource(std::uint64_t seed, std::vector<const Family*> families,
                         std::vector<Surface> surfaces, std::vector<CorpusScene> corpus)
    : seed_(seed), surfaces_(std::move(surfaces)), corpus_(std::move(corpus)) {
  for (const Family* family : families)
    families_.push_back({family, std::vector<std::uint64_t>(surfaces_.size(), 0)});
}

SceneSource::SceneSource(std::uint64_t seed, std::vector<const Family*> families,
                         std::vector<Surface> surfaces)
    : SceneSource(seed, std::move(families), std::move(surfaces), {}) {
  mutates_ = false;
}

std::vector<Batch> SceneSource::next_round(std::size_t most) {
  std::vector<Batch> batches;
  const std::size_t s = round_++ % surfaces_.size();
  const auto count = [&] { return std::min(kBatch, most); };
  for (Progress& progress : families_) {
    // A family without windows has scenes in every round nevertheless.
    const std::size_t place = progress.family->has_windows ? s : 0;
    const Surface surface = progress.family->has_windows ? surfaces_[s] : Surface::fbo;
    const std::uint64_t first = progress.asked[place];
    std::size_t scenes = count();
    if (progress.family->scenes != 0)
      scenes = std::min<std::uint64_t>(scenes, progress.family->scenes - first);
    if (scenes == 0) continue;
    batches.push_back({progress.family, surface, first, scenes});
    progress.asked[place] += batches.back().count;
    most -= batches.back().count;
  }
  if (mutates_ && !corpus_.empty() && count() > 0) {
    batches.push_back({nullptr, Surface::fbo, mutated_, count()});
    mutated_ += batches.back().count;
  }
  return batches;
}

std::optional<SourcedScene> SceneSource::scene(const Batch& batch, std::size_t place) const {
  const std::uint64_t index = batch.first + place;
  if (batch.family != nullptr)
    return SourcedScene{batch.family->scene(seed_, batch.surface, index),
                        {batch.family->name, batch.surface, index, ""}};
  RandomSource random(seed_, kMutationStream, index);
  const CorpusScene& parent =
      corpus_[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(corpus_.size())))];
  auto scene = mutated(parent.scene, random);
  if (!scene) return std::nullopt;
  const Surface surface = scene->target.surface;
  return SourcedScene{std::move(*scene), {kMutated, surface, index, parent.name}};
}

void SceneSource::add_to_corpus(CorpusScene scene) {
  if (mutates_) corpus_.push_back(std::move(scene));
}

void SceneSource::retire(const Family& family) {
  std::erase_if(families_, [&](const Progress& progress) { return progress.family == &family; });
}

}  // namespace edgecase
