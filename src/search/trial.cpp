// SPDX-License-Identifier: MIT
#include "search/trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>
#include <variant>

#include "diff/compare.h"
#include "diff/coverage/coverage_compare.h"
#include "diff/coverage/legality.h"
#include "model/side_clipping.h"
#include "raster/rasterizer.h"
#include "results/clusters.h"
#include "rules/all_rules.h"
#include "rules/renderer_claims.h"

namespace edgecase {
namespace {

Signature signature_of(const Cluster& cluster) {
  Signature signature;
  signature.cause = cluster.cause;
  signature.surface = cluster.surface;
  signature.legality = cluster.legality;
  if (!cluster.cause.empty()) return signature;
  signature.rule = cluster.rule;
  signature.kind = cluster.kind;
  signature.attribute = cluster.attribute;
  return signature;
}

// Of a cluster whose cause is not known, one for each situation. What is only counted shows nothing
// that those in full do not.
void add_unexplained(const Cluster& cluster, std::vector<Signature>& signatures) {
  Signature signature = signature_of(cluster);
  if (cluster.situations.empty()) signatures.push_back(signature);
  for (const ClusterSituation& situation : cluster.situations) {
    if (situation.is_counted) continue;
    signature.situation = situation.text;
    signatures.push_back(signature);
  }
}

// The rules and kinds that a cause breaks, without duplicates, in the order of the disagreements.
void add_broken(const Result& result, const std::string& cause, Legality legality, Surface surface,
                std::vector<Signature>& signatures) {
  for (const Disagreement& d : result.disagreements) {
    if (d.legality != legality || text_of(d.cause) != cause) continue;
    Signature signature = signature_of(d, surface);
    if (std::find(signatures.begin(), signatures.end(), signature) == signatures.end())
      signatures.push_back(std::move(signature));
  }
}

bool is_find(FailureKind kind) {
  return kind == FailureKind::crashed || kind == FailureKind::timed_out ||
         kind == FailureKind::garbage;
}

}  // namespace

std::vector<Signature> signatures_of(const Result& result, Surface surface) {
  if (result.failure) {
    if (!is_find(result.failure->kind)) return {};
    Signature signature;
    signature.surface = name_of(surface);
    signature.failure = name_of(result.failure->kind);
    return {signature};
  }
  if (result.disagreements.empty() && result.values.empty()) return {};
  CaseResults one;
  one.surface = name_of(surface);
  ClusterGatherer gatherer;
  gatherer.add(one, result);
  std::vector<Signature> signatures;
  for (const Cluster& cluster : gatherer.take_apart()) {
    if (cluster.cause.empty())
      add_unexplained(cluster, signatures);
    else if (cluster.legality == Legality::legal)
      signatures.push_back(signature_of(cluster));
    else
      add_broken(result, cluster.cause, cluster.legality, surface, signatures);
  }
  return signatures;
}

std::vector<Signature> signatures_of(const CaseResults& results, std::size_t renderer) {
  Surface surface = Surface::fbo;
  parse_name(results.surface, surface);
  return signatures_of(results.results.at(renderer), surface);
}

Signature signature_of(const Disagreement& disagreement, Surface surface) {
  Signature signature;
  signature.cause = text_of(disagreement.cause);
  signature.surface = name_of(surface);
  signature.legality = disagreement.legality;
  // An allowed cause covers several rules and kinds, and it does not matter which of them a scene
  // shows.
  if (!disagreement.cause.empty() && is_legal(disagreement)) return signature;
  signature.rule = name_of(disagreement.rule);
  signature.kind = name_of(disagreement.kind);
  if (disagreement.cause.empty()) signature.situation = disagreement.situation;
  return signature;
}

Signature signature_of(const ValueAggregate& values, Surface surface) {
  Signature signature;
  signature.cause = text_of(values.cause);
  signature.surface = name_of(surface);
  signature.legality = Legality::legal;
  if (!values.cause.empty()) return signature;
  signature.rule = name_of(values.rule);
  signature.kind = name_of(DisagreementKind::value);
  signature.attribute = values.attribute;
  return signature;
}

std::vector<const Disagreement*> disagreements_of(const Result& result,
                                                  const Signature& signature) {
  Surface surface = Surface::fbo;
  parse_name(signature.surface, surface);
  std::vector<const Disagreement*> found;
  for (const Disagreement& disagreement : result.disagreements) {
    Result one;
    one.disagreements = {disagreement};
    if (signatures_of(one, surface).front() == signature) found.push_back(&disagreement);
  }
  return found;
}

std::string title_of(const Signature& signature) {
  if (!signature.failure.empty())
    return "the renderer fails: " + signature.failure + ", " + signature.surface;
  Cluster cluster;
  cluster.cause = signature.cause;
  cluster.rule = signature.rule;
  cluster.kind = signature.kind;
  cluster.attribute = signature.attribute;
  std::string title = title_of(cluster);
  if (!signature.situation.empty()) title += ", " + signature.situation;
  if (!signature.cause.empty() && !signature.rule.empty())
    title = signature.rule + " " + signature.kind + " by " + title;
  if (signature.attribute.empty()) title += std::string(", ") + describe(signature.legality);
  return title + ", " + signature.surface;
}

namespace {

// Groups scenes by size, since changes of size are slow in some window systems.
std::vector<std::size_t> by_size(std::span<const Scene> scenes) {
  std::vector<std::size_t> order(scenes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto size = [&](std::size_t i) {
    const Target& target = scenes[i].target;
    return std::tuple(target.surface, target.width, target.height, target.samples);
  };
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
  return order;
}

}  // namespace

Trial::Trial(Renderer& renderer, TrialOptions options)
    : renderer_(renderer), options_(std::move(options)), policy_(options_.policy) {}

void Trial::read(Surface surface, RunReading reading) {
  options_.readings.insert_or_assign(surface, std::move(reading));
}

TrialAnswer Trial::ask(const Scene& scene) {
  return std::move(ask(std::span(&scene, 1)).front());
}

std::vector<TrialAnswer> Trial::ask(std::span<const Scene> scenes) {
  const auto stopped = [&] { return options_.stop != nullptr && options_.stop->load(); };
  const std::vector<std::size_t> order = by_size(scenes);
  std::vector<Task> tasks;
  for (std::size_t k = 0; k < order.size(); ++k)
    tasks.push_back({fmt::format("search/{}", asked_ + k), &scenes[order[k]], false, with_images_});
  std::vector<TrialAnswer> answers(scenes.size());
  if (stopped()) throw SearchStopped{};
  renderer_.render(tasks, [&](std::size_t k, Outcome outcome) {
    // Being stopped may itself cause a failure.
    if (stopped()) throw SearchStopped{};
    const Scene& scene = scenes[order[k]];
    answers[order[k]] = judged(scene, compare_outcome(scene, std::move(outcome)));
    ++asked_;
  });
  return answers;
}

Result Trial::compare_outcome(const Scene& scene, Outcome outcome) const {
  if (auto* failure = std::get_if<Failure>(&outcome)) return not_run(std::move(*failure));
  const auto& rendering = std::get<Rendering>(outcome);
  const RendererFacts facts =
      facts_of(renderer_.info(), options_.profiles.resolved(renderer_.info()));
  const SceneOfApi asked(scene, facts.lookups.is_es);
  if (!asked.is_exact()) return not_run({FailureKind::unsupported, kBeyondExactSides});
  // The renderer may have other sample positions; exact then uses these, too.
  const Rendering exact =
      rasterize_for_comparison(asked.scene(), policy_, rendering.sample_positions);
  return compare(asked.scene(), policy_, exact, rendering, facts);
}

TrialAnswer Trial::judged(const Scene& scene, Result result) const {
  Result* const one = &result;
  const std::span<Result* const> results(&one, 1);
  const Surface surface = scene.target.surface;
  const auto reading = options_.readings.find(surface);
  if (reading == options_.readings.end())
    judge(results, options_.policy.latitude);
  else
    judge(results, options_.policy.latitude, reading->second);
  std::vector<Signature> signatures = signatures_of(result, surface);
  return {std::move(result), std::move(signatures)};
}

namespace {

constexpr std::size_t kMostAlike = 4;  // disagreements that differ only in their pixels

using Drawn = std::vector<std::vector<PixelPosition>>;  // by primitive

Drawn drawn_of(std::size_t primitives, const Rendering& rendering) {
  Drawn drawn(primitives);
  for (const Fragment& fragment : rendering.fragments)
    drawn[static_cast<std::size_t>(fragment.primitive)].push_back({fragment.x, fragment.y});
  return drawn;
}

// The coverage under the choices, by primitive.
Drawn covered_under(const RuleChoices& choices, const Target& target,
                    std::span<const ScenePrimitive> primitives) {
  Drawn covered;
  for (const ScenePrimitive& primitive : primitives)
    covered.push_back(covered_pixels(primitive, target, choices.of(primitive.kind)));
  return covered;
}

// Keeps only what judging and reporting a result need: values may differ at every pixel, and some
// thousand results wait to be judged.
void lighten(Result& result) {
  result.pixel_counts = {};
  std::map<std::tuple<RuleId, DisagreementKind, int, int, Legality, int, bool, Cause, std::string>,
           std::size_t>
      alike;
  std::erase_if(result.disagreements, [&](const Disagreement& d) {
    return ++alike[{d.rule, d.kind, d.primitive, d.sample, d.legality, d.ruling, d.policy_agrees,
                    d.cause, d.situation}] > kMostAlike;
  });
  result.disagreements.shrink_to_fit();
}

}  // namespace

Screen::Screen(Policy policy, ReleaseProfiles profiles)
    : policy_(std::move(policy)), resolved_(policy_), profiles_(std::move(profiles)) {}

Screening Screen::ask(Renderer& renderer, std::span<const Scene> scenes, bool coverage_only,
                      const std::atomic<bool>* stop) const {
  const std::vector<std::size_t> order = by_size(scenes);
  std::vector<Task> tasks;
  tasks.reserve(order.size());
  for (const std::size_t i : order)
    tasks.push_back(
        {fmt::format("fuzz/{}", i), &scenes[i], coverage_only && scenes[i].target.samples == 1});
  Screening screening;
  renderer.render(tasks, [&](std::size_t k, Outcome outcome) {
    // Being stopped may itself cause a failure.
    if (stop != nullptr && stop->load()) throw SearchStopped{};
    if (const auto* failure = std::get_if<Failure>(&outcome)) {
      if (!screening.failure) screening.failure = *failure;
    } else {
      ++screening.drawn;
    }
    auto result =
        screened(scenes[order[k]], std::move(outcome), tasks[k].coverage_only, renderer.info());
    if (!result) return;
    lighten(*result);
    screening.suspects.push_back({order[k], std::move(*result)});
  });
  std::ranges::sort(screening.suspects, {}, &Screening::Suspect::scene);
  return screening;
}

std::optional<Result> Screen::screened(const Scene& given, Outcome outcome, bool coverage_only,
                                       const RendererInfo& info) const {
  if (auto* failure = std::get_if<Failure>(&outcome)) {
    if (failure->kind == FailureKind::unsupported || failure->kind == FailureKind::unavailable)
      return std::nullopt;
    return not_run(std::move(*failure));
  }
  const auto& rendering = std::get<Rendering>(outcome);
  const SceneOfApi asked(given, claims_of(info).lookups.is_es);
  if (!asked.is_exact()) return std::nullopt;
  const Scene& scene = asked.scene();
  if (coverage_only) return coverage_of(scene, rendering, info);
  const Rendering exact = rasterize_for_comparison(scene, resolved_, rendering.sample_positions);
  const RendererFacts facts{info.subpixel_bits, profiles_.resolved(info)};
  Result result = compare(scene, resolved_, exact, rendering, facts);
  if (result.disagreements.empty() && result.values.empty()) return std::nullopt;
  return result;
}

std::optional<Result> Screen::coverage_of(const Scene& scene, const Rendering& rendering,
                                          const RendererInfo& info) const {
  const Surface surface = scene.target.surface;
  const RuleChoices& policy = resolved_.on(surface);
  const auto primitives = primitives_of(scene);
  Drawn drawn = drawn_of(primitives.size(), rendering);
  Drawn covered = covered_under(policy, scene.target, primitives);
  // Pixels that the specification's own choice draws, too, are beyond doubt.
  if (drawn == covered && drawn == covered_under(standard_choices(), scene.target, primitives))
    return std::nullopt;
  std::vector<PrimitiveCoverage> coverage;
  for (std::size_t i = 0; i < primitives.size(); ++i)
    coverage.push_back({{std::move(covered[i])}, {std::move(drawn[i])}});
  const ResolvedPolicy* profile = profiles_.resolved(info);
  Result result;
  compare_coverage({scene,
                    primitives,
                    coverage,
                    policy,
                    profile ? &profile->on(surface) : nullptr,
                    policy_.latitude,
                    latitude_bits(info.subpixel_bits),
                    false,
                    {}},
                   result);
  if (result.disagreements.empty()) return std::nullopt;
  return result;
}

}  // namespace edgecase
