// SPDX-License-Identifier: MIT
#include "run/comparing.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>
#include <variant>

#include "diff/compare.h"
#include "diff/display_data.h"
#include "diff/findings/patience.h"
#include "model/side_clipping.h"
#include "raster/rasterizer.h"

namespace edgecase {

namespace {

// Keeps the renderer's pictures. Most equal exact's, and are then shared with them.
void keep_pictures(const Rendering& rendering, const ExactSide& exact, Result& result) {
  result.pixels = rendering.pixels == exact.rendering.pixels
                      ? exact.pixels
                      : Shared<PackedWords>(rendering.pixels);
  result.samples = sample_image(rendering);
  result.samples.share_with(exact.samples);
}

}  // namespace

ExactSide::ExactSide(Rendering drawn)
    : rendering(std::move(drawn)), pixels(rendering.pixels), samples(sample_image(rendering)) {}

CaseComparison::CaseComparison(std::size_t count, const RunOptions& options)
    : policy_(options.policy),
      profiles_(options.profiles),
      likely_first_(options.likely_first),
      stop_(options.stop),
      patience_(options.comparison_patience),
      made_(std::make_unique<std::once_flag[]>(count)),
      exact_(count) {}

const ExactSide& CaseComparison::exact(std::size_t index, const Scene& scene) {
  std::call_once(made_[index], [&] {
    exact_[index] = std::make_unique<const ExactSide>(rasterize_for_comparison(scene, policy_));
  });
  return *exact_[index];
}

Result CaseComparison::compare_outcome(std::size_t index, const Case& one, Outcome outcome,
                                       const RendererInfo& info) {
  if (auto* failure = std::get_if<Failure>(&outcome)) return not_run(std::move(*failure));
  try {
    return compare_rendering(index, one, std::get<Rendering>(outcome), info);
  } catch (const std::exception& error) {
    return not_run(internal_failure(one.id, error));
  }
}

Result CaseComparison::compare_rendering(std::size_t index, const Case& one,
                                         const Rendering& rendering, const RendererInfo& info) {
  RendererFacts facts = facts_of(info, profiles_of(profiles_, info.name).resolved(info));
  facts.likely_first = likely_first_;
  const Patience patience(stop_, patience_);
  try {
    Result result = compare_with_exact(index, one.scene, rendering, facts);
    if (std::ranges::find(one.tags, kRampTag) != one.tags.end())
      result.ramp =
          level_ramp(SceneOfApi(one.scene, facts.lookups.is_es).scene(), policy_, rendering, facts);
    return result;
  } catch (const ComparisonTooLong&) {
    return not_run({FailureKind::timed_out,
                    fmt::format("comparing its answer took edgecase longer than {} seconds; give "
                                "it more with --timeout",
                                std::chrono::duration<double>(patience_).count())});
  }
}

// If a renderer has its samples elsewhere, or its API other planes that clip, exact is drawn so.
Result CaseComparison::compare_with_exact(std::size_t index, const Scene& scene,
                                          const Rendering& rendering, const RendererFacts& facts) {
  const SceneOfApi asked(scene, facts.lookups.is_es);
  if (!asked.is_exact()) return not_run({FailureKind::unsupported, kBeyondExactSides});
  const auto compare_with = [&](const ExactSide& exact) {
    Result result = compare(asked.scene(), policy_, exact.rendering, rendering, facts);
    report_fragments(exact.rendering, rendering, result);
    keep_pictures(rendering, exact, result);
    return result;
  };
  const ExactSide& usual = exact(index, scene);
  const SamplePositions& reported = rendering.sample_positions;
  const bool is_usual = reported.empty() || reported == usual.rendering.sample_positions;
  if (is_usual && !asked.is_own()) return compare_with(usual);
  const ExactSide own(rasterize_for_comparison(asked.scene(), policy_, reported));
  Result result = compare_with(own);
  result.exact_samples = own.samples;
  result.exact_pixels = own.pixels;
  return result;
}

}  // namespace edgecase
