// SPDX-License-Identifier: MIT
//
// Find: a disagreement found by a search, with the key that distinguishes it from all others.
//
// Two scenes show the same find if signature and geometry are equal: what differs and why, and for
// which kind of primitive on how many samples.
#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

#include "model/result.h"
#include "model/scene.h"
#include "rules/all_rules.h"
#include "search/minimize.h"
#include "search/scene_source.h"
#include "search/trial.h"

namespace edgecase {

struct FindKey {
  Signature signature;
  // "line", "wide line", "point", "large point", "triangle", "whole pixel"; then ", 4 samples" for
  // a multisampled target. "scene" if the renderer fails.
  std::string geometry;
  friend auto operator<=>(const FindKey&, const FindKey&) = default;
};

// One find that a judged result shows, with its verdict: not_run if the renderer fails.
struct Shown {
  FindKey key;
  Verdict verdict = Verdict::agree;
};

// All finds that a judged result shows, without duplicates: worst first, then by key.
std::vector<Shown> shown_by(const Scene& scene, const Result& result, Latitude latitude);

// The answer of one of the renderers to a find's scene.
struct FindAnswer {
  std::string renderer;
  std::string words;  // "violation, extra (3, 3), missing (4, 3)"
};

// The result as text: the verdict, and what differs where.
std::string describe(const Result& result);

struct Find {
  std::string renderer;  // as on the command line
  FindKey key;
  Verdict verdict = Verdict::agree;
  Scene scene;         // the smallest scene found that shows it
  Result result;       // for that scene, judged under the run's reading
  SceneOrigin origin;  // of the scene that was minimized
  MinimizeEnd end = MinimizeEnd::finished;
  int least_bits = 0;      // fraction bits that any such scene needs to show it; 0: unknown
  std::size_t asks = 0;    // scenes rendered to minimize it
  std::size_t scenes = 1;  // scenes of the search that showed it
  std::vector<FindAnswer> answers;  // of all renderers
};

// "violation of line.diamond-exit extra, …, not allowed, fbo (line)".
std::string title_of(const Find& find);

// The rule of a find; if its cause joins several, the rule of the first disagreement.
std::string rule_of(const Find& find);

// The disagreement that represents the find; null for values and failures.
const Disagreement* first_disagreement(const Find& find);

}  // namespace edgecase
