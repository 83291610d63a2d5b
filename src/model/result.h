// SPDX-License-Identifier: MIT
//
// Result: one renderer's answer to one case, compared and judged.
//
// src/diff fills it in two steps: compare() what can be said of one case alone, judge() what
// depends on a whole run (which catalogued snap its lines are read with, which of several causes
// explains most). Known faults then say how it stands to what is known.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/names.h"
#include "model/renderer.h"
#include "model/storage.h"
#include "model/verdict.h"

namespace edgecase {

// How a result stands to what is known of the renderer.
enum class Standing {
  expected,    // agrees, or differs as the specification allows
  known,       // known faults account for all that the specification forbids
  unexpected,  // no known fault accounts for something that the specification forbids
  tolerated,   // is contested or not supported: told, and nobody is accused
  flake,       // asked again, the renderer answered otherwise: no answer can be expected
};

template <>
inline constexpr auto kNames<Standing> =
    std::to_array<Named<Standing>>({{Standing::expected, "expected"},
                                    {Standing::known, "known"},
                                    {Standing::unexpected, "unexpected"},
                                    {Standing::tolerated, "tolerated"},
                                    {Standing::flake, "flake"}});

// Is it red?
constexpr bool is_unexpected(Standing standing) {
  return standing == Standing::unexpected || standing == Standing::flake;
}

// How many pixels of the target fare how. Each counts once, by the worst that was found at it: in
// a fragment there, seen or hidden, in what its samples hold, in the image or in one of its passes.
// What is wrong with a texture as a whole is found at pixel (0, 0). All are 0 where there is no
// picture.
struct PixelCounts {
  std::size_t agree = 0;       // nothing differs
  std::size_t convention = 0;  // the verdicts of cases, of what is found at the pixel alone
  std::size_t permitted = 0;
  std::size_t contested = 0;
  std::size_t violation = 0;
  std::size_t same = 0;  // the stored colour is exact's to the bit, whatever else is found there
  friend bool operator==(const PixelCounts&, const PixelCounts&) = default;
};

// One renderer's answer to one case, compared.
struct Result {
  // Which alternatives reproduce what the renderer drew of one primitive: smallest sets first.
  struct Evidence {
    int primitive = 0;  // -1: all of them, since the answer is upside down (diff/upside_down.h)
    std::vector<Cause> causes;
    std::vector<std::string>
        illegal_line_snaps;     // lines: snaps under which a ruling on lines fails
    std::string broken_clause;  // lines: what the segment as given breaks, or empty
    int pass = -1;              // index, where the scene is supersampled; else -1
  };

  // lambda' of one fragment: exact, the least and the most that is permitted, and as the renderer
  // tells it. Infinite where the texture does not move.
  struct LevelPoint {
    int x = 0;
    int y = 0;
    double exact = 0;
    double low = 0;
    double high = 0;
    double rendered = 0;
  };

  // A fragment of one side, without its details.
  struct ReportedFragment {
    Fragment fragment;
    int pass = -1;  // index, where the scene is supersampled; else -1
  };

  Verdict verdict = Verdict::not_run;
  std::optional<Failure> failure;  // set exactly when the verdict is not-run
  std::string fingerprint;         // of rule, kind and pixel set; empty when nothing differs
  std::vector<Disagreement> disagreements;  // complete, sorted by pixel, primitive, kind
  std::vector<ValueAggregate> values;
  std::vector<Evidence> evidence;               // of the primitives that have a disagreement
  std::vector<std::string> illegal_line_snaps;  // snaps under which some line is not legal
  // Alternatives under which some primitive that agrees with exact would not do so.
  AlternativeSet refuted;
  // Of cases that ask for it (diff/shown.h): the levels of detail along a row that
  // fragments of textured draws tell.
  std::vector<LevelPoint> ramp;
  // What either side makes where they differ (diff/shown.h); empty where nothing does.
  std::vector<ReportedFragment> exact_fragments;
  std::vector<ReportedFragment> rendered_fragments;
  Shared<PackedWords> pixels;  // RGBA8, bottom row first; empty when not run, or not kept
  PixelCounts pixel_counts;
  // The same of exact, where it is another than the case's: with samples where this renderer says
  // that its own lie.
  Shared<PackedWords> exact_pixels;
  SampleImage samples;        // of the renderer, where the case is multisampled
  SampleImage exact_samples;  // of exact, where exact_pixels is set
  Standing standing = Standing::expected;
  std::string
      standing_reason;  // the reasons of the known faults, or why it is unexpected or tolerated
};

}  // namespace edgecase
