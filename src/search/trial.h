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
#include <compare>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "diff/judge.h"
#include "model/policy.h"
#include "model/renderer.h"
#include "model/result.h"
#include "model/scene.h"
#include "results/results.h"
#include "rules/choices.h"
#include "run/profiles.h"

namespace edgecase {

// Signature: what defines a find, so that two scenes can be said to show the same.
//
// For one scene it is what distinguishes clusters (results/clusters.h), and situations within them:
// the cause if there is one, and otherwise rule, kind and situation; always surface and legality.
// If a cause breaks a rule, rule and kind count as well: lines that leave a gap where they meet and
// lines that draw a pixel twice there are two finds, though one algorithm does both. A renderer
// that fails to answer is a find too, identified by its kind of failure.

struct Signature {
  std::string cause;    // "rule=alternative", several joined by " + "; empty: none found
  std::string rule;     // id; empty if the specification allows the cause
  std::string kind;     // "missing"; empty if the specification allows the cause
  std::string surface;  // "fbo", "window"
  Legality legality = Legality::illegal;
  std::string situation;  // as text; empty with a cause, and for values
  std::string attribute;  // of values within the permitted range: "color"; otherwise empty
  std::string failure;    // "crashed", "timed-out", "garbage"; then only the surface is set, too
  friend auto operator<=>(const Signature&, const Signature&) = default;
};

// All signatures of one renderer's judged result, without duplicates: first those that are not
// allowed and have no cause, then in the order of clusters_of. None if nothing differs, if the
// renderer does not support the scene, or if it could not be started.
std::vector<Signature> signatures_of(const Result& result, Surface surface);

// The same for the renderer at index `renderer`.
std::vector<Signature> signatures_of(const CaseResults& results, std::size_t renderer);

// The same for one disagreement, or for one attribute's values within the permitted range.
Signature signature_of(const Disagreement& disagreement, Surface surface);
Signature signature_of(const ValueAggregate& values, Surface surface);

// The disagreements of a result with a signature, in order; none for aggregated values and
// failures.
std::vector<const Disagreement*> disagreements_of(const Result& result, const Signature& signature);

// On one line: "line.diamond-exit extra, first pixel, not allowed, window"; "the renderer fails:
// crashed, fbo".
std::string title_of(const Signature& signature);

// What one scene shows.
struct TrialAnswer {
  Result result;  // judged; not-run with its reason if there is no rendering
  std::vector<Signature> signatures;
};

struct TrialOptions {
  Policy policy;             // of the exact side
  ReleaseProfiles profiles;  // what the renderer is measured to follow, if known
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

  // Whether the images of scenes are drawn, too (diff/invariance.h): by a renderer that can, from
  // now on. At first they are not.
  void ask_for_images(bool with_images) { with_images_ = with_images; }
  bool asks_for_images() const { return with_images_; }
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
  bool with_images_ = false;
  std::size_t asked_ = 0;
};

// Screen: finds quickly which of many scenes a renderer draws differently from exact.
//
// Most scenes show nothing. So scenes about coverage only request coverage, only primitives that
// differ are examined, and nothing is explained for those that agree. The remaining results are as
// from compare(), with similar disagreements reduced, and not yet judged: the reading of a run
// belongs to the caller (search/ledger.h).

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
  // `profiles`: what the renderer is measured to follow, if that is known.
  Screen(Policy policy, ReleaseProfiles profiles);

  // `coverage_only`: only coverage is compared, on targets with one sample. Throws SearchStopped
  // (search/trial.h) once `stop` is true.
  Screening ask(Renderer& renderer, std::span<const Scene> scenes, bool coverage_only,
                const std::atomic<bool>* stop) const;

  const Policy& policy() const { return policy_; }

 private:
  std::optional<Result> screened(const Scene& scene, Outcome outcome, bool coverage_only,
                                 const RendererInfo& info) const;
  std::optional<Result> coverage_of(const Scene& scene, const Rendering& rendering,
                                    const RendererInfo& info) const;

  Policy policy_;
  ResolvedPolicy resolved_;
  ReleaseProfiles profiles_;
};

}  // namespace edgecase
