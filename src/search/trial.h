// SPDX-License-Identifier: MIT
//
// Trial: compares one renderer with exact, scene by scene, for searches among scenes.
//
//   scenes -> {renderer, exact} -> compare -> judge, each scene alone or as a run reads it ->
//   TrialAnswer
//
// It keeps no scenes and knows no cases: its caller decides what to try next.
#pragma once

#include <atomic>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "diff/judge.h"
#include "model/renderer.h"
#include "model/result.h"
#include "model/scene.h"
#include "rules/choices.h"
#include "search/signature.h"

namespace edgecase {

// What one scene shows.
struct TrialAnswer {
  Result result;  // judged; not-run with its reason if there is no rendering
  std::vector<Signature> signatures;
};

struct TrialOptions {
  Policy policy;                  // of the exact side
  std::optional<Policy> profile;  // what the renderer is measured to follow, if known
  // How scenes on a surface are read. On other surfaces each scene is read by itself.
  std::map<Surface, RunReading> readings;
  // Becomes true if the search should end; or null. Give it to the renderer as well, or the trial
  // waits for one that hangs.
  const std::atomic<bool>* stop = nullptr;
};

// Thrown by Trial::ask once `stop` is true. Unanswered scenes are lost.
struct SearchStopped {};

class Trial {
 public:
  // The renderer must outlive the trial.
  Trial(Renderer& renderer, TrialOptions options);

  // One answer for each scene, in order; the renderer gets them all at once. Throws SearchStopped.
  std::vector<TrialAnswer> ask(std::span<const Scene> scenes);
  TrialAnswer ask(const Scene& scene);

  // Scenes answered so far, including failures.
  std::size_t asked() const { return asked_; }
  // From now on, uses this reading for scenes on this surface.
  void read(Surface surface, RunReading reading);
  const TrialOptions& options() const { return options_; }
  // As Renderer::info.
  const RendererInfo& info() const { return renderer_.info(); }

 private:
  Result compare_outcome(const Scene& scene, Outcome outcome) const;
  TrialAnswer judged(const Scene& scene, Result result) const;

  Renderer& renderer_;
  TrialOptions options_;
  ResolvedPolicy policy_;
  std::optional<ResolvedPolicy> profile_;
  std::size_t asked_ = 0;
};

}  // namespace edgecase
