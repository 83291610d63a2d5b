// SPDX-License-Identifier: MIT
//
// Find: a disagreement that a search came upon, with what tells it from all others.
//
// Two scenes show the same find where signature and geometry are the same: what differs and why,
// and of which kind of primitive on how many samples.
#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

#include "model/policy.h"
#include "model/result.h"
#include "model/scene.h"
#include "search/minimize.h"
#include "search/scene_source.h"
#include "search/signature.h"

namespace edgecase {

struct FindKey {
  Signature signature;
  // "line", "wide line", "point", "large point", "triangle", "whole pixel"; then ", 4 samples" of
  // a multisampled target. "scene" where the renderer fails.
  std::string geometry;
  friend auto operator<=>(const FindKey&, const FindKey&) = default;
};

// One thing that a judged result shows, with its verdict: not_run where the renderer fails.
struct Shown {
  FindKey key;
  Verdict verdict = Verdict::agree;
};

// All that a judged result shows, each once: worst first, then by key.
std::vector<Shown> shown_by(const Scene& scene, const Result& result, Latitude latitude);

// What one of the renderers that were asked makes of a find's scene.
struct FindAnswer {
  std::string renderer;
  std::string words;  // "violation, extra (3, 3), missing (4, 3)"
};

// In words: the verdict, and what differs where.
std::string describe(const Result& result);

struct Find {
  std::string renderer;  // as the command line names it
  FindKey key;
  Verdict verdict = Verdict::agree;
  Scene scene;         // the smallest found that shows it
  Result result;       // of that scene, judged as the run reads it
  SceneOrigin origin;  // of the scene that it was minimised from
  MinimizeEnd end = MinimizeEnd::finished;
  int least_bits = 0;      // fraction bits that a scene like it needs to show it; 0: not known
  std::size_t asks = 0;    // scenes asked to minimise it
  std::size_t scenes = 1;  // of the search that showed it
  std::vector<FindAnswer> answers;  // of all renderers
};

// "violation of line.diamond-exit extra, …, not allowed, fbo (line)".
std::string title_of(const Find& find);

// The rule that a find is about: of several that its cause joins, that of the first disagreement.
std::string rule_of(const Find& find);

// The disagreement that stands for the find; null where values or failures do.
const Disagreement* first_disagreement(const Find& find);

}  // namespace edgecase
