// SPDX-License-Identifier: MIT
//
// Trial: holds one renderer against exact, scene by scene, for those who search among scenes.
//
//   scenes -> {renderer, exact} -> compare -> judge, each scene alone or as a run reads it ->
//   TrialAnswer
//
// It keeps no scene and knows no case: its caller decides what to ask next.
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
  Result result;  // judged; not-run with its reason where there is no rendering
  std::vector<Signature> signatures;
};

struct TrialOptions {
  Policy policy;                  // of the exact side
  std::optional<Policy> profile;  // what the renderer is measured to follow; none: not known
  // How scenes on a surface are read. Of a surface that is not there, each scene by itself.
  std::map<Surface, RunReading> readings;
  // Becomes true when the search should end; or null. Give it to the renderer as well, or one that
  // hangs is waited for.
  const std::atomic<bool>* stop = nullptr;
};

// Thrown by Trial::ask when `stop` became true. What was asked and not answered is lost.
struct SearchStopped {};

class Trial {
 public:
  // The renderer must outlive the trial.
  Trial(Renderer& renderer, TrialOptions options);

  // One answer for each scene, in their order; the renderer gets them all at once. Throws
  // SearchStopped.
  std::vector<TrialAnswer> ask(std::span<const Scene> scenes);
  TrialAnswer ask(const Scene& scene);

  // Scenes that were answered so far, failures included.
  std::size_t asked() const { return asked_; }
  // From now on, scenes on this surface are read so.
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
