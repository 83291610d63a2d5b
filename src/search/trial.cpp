// SPDX-License-Identifier: MIT
#include "search/trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>
#include <variant>

#include "diff/compare.h"
#include "raster/rasterizer.h"
#include "results/clusters.h"
#include "rules/all_rules.h"

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
  signature.situation = cluster.situation;
  signature.attribute = cluster.attribute;
  return signature;
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
  for (const Cluster& cluster : gatherer.take()) {
    if (cluster.cause.empty() || cluster.legality == Legality::legal)
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
  cluster.situation = signature.situation;
  cluster.attribute = signature.attribute;
  std::string title = title_of(cluster);
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
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    const auto size = [&](std::size_t i) {
      const Target& target = scenes[i].target;
      return std::tuple(target.surface, target.width, target.height);
    };
    return size(a) < size(b);
  });
  return order;
}

}  // namespace

Trial::Trial(Renderer& renderer, TrialOptions options)
    : renderer_(renderer), options_(std::move(options)), policy_(options_.policy) {
  if (options_.profile) profile_ = *options_.profile;
}

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
    tasks.push_back({fmt::format("search/{}", asked_ + k), &scenes[order[k]]});
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
  const RendererFacts facts = facts_of(renderer_.info(), profile_ ? &*profile_ : nullptr);
  // The renderer may have other sample positions; exact then uses these, too.
  const Rendering exact = rasterize_without_details(scene, policy_, rendering.sample_positions);
  return compare(scene, policy_, exact, rendering, facts);
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

}  // namespace edgecase
