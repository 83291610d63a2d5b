// SPDX-License-Identifier: MIT
//
// Screen: which of many scenes a renderer draws otherwise than exact, found quickly.
//
// Most scenes show nothing. So of scenes that are about coverage only that is asked for, and only
// primitives that differ are looked at closely; nothing is explained of those that agree. What
// remains has results as compare() makes them, but for what is alike, and not judged yet: a run's
// reading belongs to the caller, who knows the run (search/ledger.h).
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
    // Something differs, or the renderer failed; not judged. Without pictures, and of disagreements
    // that only their pixels tell apart a few.
    Result result;
  };
  std::vector<Suspect> suspects;   // in the order of scenes
  std::size_t drawn = 0;           // scenes that have a rendering
  std::optional<Failure> failure;  // of the first scene that has none
};

class Screen {
 public:
  // `profile`: what the renderer is measured to follow, where that is known.
  Screen(Policy policy, std::optional<Policy> profile);

  // `coverage_only`: nothing but coverage is looked at, of targets of one sample. Throws
  // SearchStopped (search/trial.h) when `stop` became true.
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
