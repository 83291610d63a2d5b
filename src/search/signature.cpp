// SPDX-License-Identifier: MIT
#include "search/signature.h"

#include <algorithm>
#include <utility>

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
  // Clusters of a run with only this result.
  Results run;
  run.cases.resize(1);
  CaseResults& one = run.cases.front();
  one.surface = name_of(surface);
  one.results.resize(1);
  one.results.front().disagreements = result.disagreements;
  one.results.front().values = result.values;
  std::vector<Signature> signatures;
  for (const Cluster& cluster : clusters_of(run, 0)) {
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

}  // namespace edgecase
