// SPDX-License-Identifier: MIT
#include "run/answer_digest.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "diff/compare.h"
#include "model/names.h"
#include "model/text.h"
#include "run/source_digest.h"
#include "wire/message.h"

namespace edgecase {
namespace {

void add_choices(const Choices& choices, Digest& digest) {
  for (const auto& [rule, alternative] : choices) digest.add(rule).add(alternative);
  digest.add("");
}

void add_policy(const Policy& policy, Digest& digest) {
  digest.add(policy.name).add(name_of(policy.latitude));
  add_choices(policy.rules, digest);
  for (const auto& [surface, choices] : policy.surfaces)
    add_choices(choices, digest.add(name_of(surface)));
}

// What a comparison knows of a renderer, beside its profile. A member that is added there has to be
// added here.
std::string text_of(const RendererFacts& facts) {
  const auto& [bits, profile, sizes, lookups, likely_first] = facts;
  const auto& [points, lines] = sizes;
  const auto& [bias, is_es] = lookups;
  return fmt::format("{} {} {} {} {} {} {}", bits, points.least, points.step, lines.least,
                     lines.step, bias, is_es);
}

}  // namespace

const std::string& digest_of_source(const Case& one) {
  thread_local SharedText last;
  thread_local std::string digest = digest_of_text("");
  if (!is_same_object(last, one.source)) digest = digest_of_text(*(last = one.source));
  return digest;
}

std::string digest_of(const Policy& policy, const Profiles& profiles,
                      const std::vector<RendererInfo>& renderers) {
  std::map<std::string, const Policy*> by_name;
  for (const RendererInfo& info : renderers)
    if (const Policy* profile = profiles_of(profiles, info.name).policy(info))
      by_name.emplace(profile->name, profile);
  Digest digest;
  add_policy(policy, digest);
  for (const auto& [name, profile] : by_name) add_policy(*profile, digest);
  return digest.text();
}

const std::string& AnswerDigests::of_rules(const Policy* profile) {
  const std::lock_guard lock(mutex_);
  const auto [found, is_new] = of_rules_.try_emplace(profile);
  if (!is_new) return found->second;
  Digest digest;
  digest.add(kSourceDigest);
  add_policy(policy_, digest);
  if (profile != nullptr) add_policy(*profile, digest);
  return found->second = digest.text();
}

std::uint64_t AnswerDigests::of(const Case& one, const Rendering& rendering,
                                const RendererInfo& info, std::uint64_t outcome_digest) {
  if (outcome_digest == 0) outcome_digest = digest_of_answer(one.scene, rendering);
  Digest digest;
  digest.add(of_rules(profiles_of(profiles_, info.name).policy(info)));
  digest.add(text_of(facts_of(info, nullptr)))
      .add(one.file.generic_string())
      .add(digest_of_source(one));
  digest.add(one.id).add(std::to_string(outcome_digest));
  digest.add(fmt::format("{} {}", rendering.images.drawn, rendering.images.refused));
  for (const Variance& variance : rendering.variances)
    digest.add(fmt::format("{} {} {} {} {}", variance.pixel.x, variance.pixel.y, variance.primitive,
                           variance.ruling, variance.what));
  return std::max<std::uint64_t>(digest.number(), 1);
}

}  // namespace edgecase
