// SPDX-License-Identifier: MIT
//
// Find: a disagreement found by a search, with the key that distinguishes it from all others.
//
// Two scenes show the same find if signature and geometry are equal: what differs and why, and for
// which kind of primitive on how many samples.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "model/case.h"
#include "model/policy.h"
#include "model/result.h"
#include "model/scene.h"
#include "search/minimize.h"
#include "search/scene_source.h"
#include "search/trial.h"

namespace edgecase {

struct FuzzReport;

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

// A find as a case file, a search's report as JSON, and known finds.

// -------------------------------------------------------------------------------------- case files

constexpr std::size_t kMostTitle = 200;  // bytes of the title of a found case

// A renderer's name or message in the form for a case file: one line of at most 500 bytes.
std::string text_for_file(const std::string& words);

struct FindFile {
  std::string name;  // "line.diamond-exit-1f2e3d4c.json": the rule, and a hash of title and scene
  std::string text;  // empty exactly if there are diagnostics
  std::vector<Diagnostic> diagnostics;  // why a case file cannot express it
};

// A case file of the find, with its title, the reason, the answers of all renderers, its origin,
// and its family as a tag. `schema`: relative path from the file to case.schema.json, or empty.
// Equal finds give equal files.
FindFile find_file(const Find& find, std::uint64_t seed, const std::string& schema);

// ----------------------------------------------------------------------------------------- reports

// A search's report as JSON, and the reading of known finds from one.

// The context of the report.
struct FuzzWords {
  std::string tool;
  std::string policy;
  std::uint64_t seed = 1;
  std::vector<std::string> renderers;  // as on the command line
  std::vector<std::string> files;      // of the finds, by index; empty: not saved
};

// {"tool", "policy", "seed", "scenes", "families": {NAME: scenes}, "renderers": [{"name",
// "version", "drawn", "not_drawn", "known"}], "finds": [{"renderer", "verdict", "title",
// "signature", "geometry", "primitives", "target", "bits", "scenes", "asks", "minimized", "origin",
// "answers", "file", "case"}]}, indented; equal reports give equal bytes. "case" is the text of a
// case file if one can express the scene.
std::string fuzz_json(const FuzzReport& report, const FuzzWords& words);

// The finds in such a text, by renderer; or the fault of the text.
using KnownKeys = std::map<std::string, std::vector<FindKey>>;
std::variant<KnownKeys, std::string> read_known_finds(const std::string& text);

}  // namespace edgecase
