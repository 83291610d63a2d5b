// SPDX-License-Identifier: MIT
//
// Screen: finds quickly which of many scenes a renderer draws differently from exact.
//
// Most scenes show nothing. So scenes about coverage only request coverage, only primitives that
// differ are examined, and nothing is explained for those that agree. The remaining results are as
// from compare(), with similar disagreements reduced, and not yet judged: the reading of a run
// belongs to the caller (search/ledger.h).
#pragma once

#include <atomic>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/policy.h"
#include "model/renderer.h"
#include "model/result.h"
#include "rules/choices.h"

namespace edgecase {

struct Screening {
  struct Suspect {
    std::size_t scene = 0;  // index
    // Something differs, or the renderer failed; not judged. Without pictures, and with only a few
    // of the disagreements that differ just in their pixels.
    Result result;
  };
  std::vector<Suspect> suspects;   // in the order of scenes
  std::size_t drawn = 0;           // scenes that have a rendering
  std::optional<Failure> failure;  // of the first scene that has none
};

class Screen {
 public:
  // `profile`: what the renderer is measured to follow, if that is known.
  Screen(Policy policy, std::optional<Policy> profile);

  // `coverage_only`: only coverage is compared, on targets with one sample. Throws SearchStopped
  // (search/trial.h) once `stop` is true.
  Screening ask(Renderer& renderer, std::span<const Scene> scenes, bool coverage_only,
                const std::atomic<bool>* stop) const;

  const Policy& policy() const { return policy_; }

 private:
  std::optional<Result> screened(const Scene& scene, Outcome outcome, bool coverage_only,
                                 int bits) const;
  std::optional<Result> coverage_of(const Scene& scene, const Rendering& rendering, int bits) const;

  Policy policy_;
  ResolvedPolicy resolved_;
  std::optional<ResolvedPolicy> profile_;
};

}  // namespace edgecase
