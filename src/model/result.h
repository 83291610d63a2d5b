// SPDX-License-Identifier: MIT
//
// Result: one renderer's answer to one case, compared and judged.
//
// src/diff fills it in two steps: compare() with what follows from one case alone, judge() with
// what depends on a whole run (which catalogued snap its lines are read with, which of several
// causes explains most). Known faults then decide its standing.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "base/packed_words.h"
#include "base/shared.h"
#include "model/names.h"
#include "model/place_cells.h"
#include "model/renderer.h"
#include "model/sample_image.h"
#include "model/verdict.h"

namespace edgecase {

// A result's relation to the known faults of the renderer.
enum class Standing {
  expected,    // agrees, or differs as the specification allows
  known,       // known faults account for all that the specification forbids
  unexpected,  // no known fault accounts for something that the specification forbids
  tolerated,   // contested or not supported: reported without an accusation
  flake,       // the renderer answered differently when asked again, so no answer can be expected
};

template <>
inline constexpr auto kNames<Standing> =
    std::to_array<Named<Standing>>({{Standing::expected, "expected"},
                                    {Standing::known, "known"},
                                    {Standing::unexpected, "unexpected"},
                                    {Standing::tolerated, "tolerated"},
                                    {Standing::flake, "flake"}});

// Whether it makes a run fail.
constexpr bool is_unexpected(Standing standing) {
  return standing == Standing::unexpected || standing == Standing::flake;
}

// How many pixels of the target have which verdict. Each counts once, by the worst difference found
// at it: in a fragment, seen or hidden, in its samples, in the image or in one of its passes.
// Differences of a whole texture count at pixel (0, 0). All are 0 if there is no picture.
struct PixelCounts {
  std::array<std::size_t, kDrawnVerdicts.size()> by_verdict{};
  std::size_t same = 0;  // the stored colour equals exact's to the bit, whatever else differs there

  // Of any verdict but not-run.
  std::size_t& operator[](Verdict verdict) { return by_verdict[static_cast<std::size_t>(verdict)]; }
  std::size_t operator[](Verdict verdict) const {
    return by_verdict[static_cast<std::size_t>(verdict)];
  }
  // All pixels of the target.
  std::size_t all() const { return std::reduce(by_verdict.begin(), by_verdict.end()); }
  friend bool operator==(const PixelCounts&, const PixelCounts&) = default;
};

// Consecutive numbers, both ends inclusive.
struct NumberRun {
  std::uint16_t first = 0;
  std::uint16_t last = 0;
  friend bool operator==(const NumberRun&, const NumberRun&) = default;
};

// What judging makes of an answer. Two answers that are equal in this show the same.
struct Judgement {
  Verdict verdict = Verdict::agree;
  std::string fingerprint;
  friend bool operator==(const Judgement&, const Judgement&) = default;
};

// One renderer's answer to one case, without what was found in it.
struct ResultOutline {
  Verdict verdict = Verdict::not_run;
  std::optional<Failure> failure;  // set exactly when the verdict is not-run
  std::string fingerprint;         // of rule, kind and pixel set; empty if nothing differs
  Standing standing = Standing::expected;
  // The reasons of the known faults, or why it is unexpected or tolerated.
  std::string standing_reason;
  std::vector<std::string> faults;  // ids of the known faults that account for something in it
  // Of an unexpected answer that was asked for a second time, what came then, where it was another.
  std::optional<Judgement> again;
  ImageCounts images;  // of the scene (diff/invariance.h)
  // Of the answer and of all else that its comparison depends on (run/answer_digest.h); 0: unknown.
  std::uint64_t answer_digest = 0;
  // The hypotheses about its renderer that explain the answer, and marks of what was asked
  // (rules/hypotheses.h), ascending. Empty where nothing asks for them.
  std::vector<NumberRun> hypotheses;
};

inline Judgement judgement_of(const ResultOutline& answer) {
  return {answer.verdict, answer.fingerprint};
}

// A thing that is one for a renderer on a surface, whatever it draws there.
struct SingleThing {
  enum class Kind {
    offset_unit,  // r of polygon offsets in a fixed-point depth buffer
    sample_x,     // where a sample lies in its pixel, in pixels from the lower left corner
    sample_y,
    sample_cells,  // both together: a set of places
    alpha,         // the least alpha of which a pixel keeps so many samples
  };
  Kind kind = Kind::offset_unit;
  int of = 0;      // bits of the depth buffer, or samples of the target
  int sample = 0;  // its index, or how many are kept
  int x = 0;       // of alpha: the pixel
  int y = 0;
  friend auto operator<=>(const SingleThing&, const SingleThing&) = default;
};

template <>
inline constexpr auto kNames<SingleThing::Kind> =
    std::to_array<Named<SingleThing::Kind>>({{SingleThing::Kind::offset_unit, "offset unit"},
                                             {SingleThing::Kind::sample_x, "sample x"},
                                             {SingleThing::Kind::sample_y, "sample y"},
                                             {SingleThing::Kind::sample_cells, "sample cells"},
                                             {SingleThing::Kind::alpha, "alpha"}});

// In place of a primitive: evidence on all differing values of an answer together.
inline constexpr int kAllValues = -2;

// One renderer's answer to one case, compared.
struct Result : ResultOutline {
  // Which alternatives reproduce a primitive as the renderer drew it, smallest sets first.
  struct Evidence {
    // -1: all of them, if the answer is upside down (diff/upside_down.h); or kAllValues
    int primitive = 0;
    std::vector<Cause> causes;
    std::vector<std::string>
        illegal_line_snaps;     // lines: snaps under which a ruling on lines fails
    std::string broken_clause;  // lines: what the given segment violates, or empty
    int pass = -1;              // index if the scene is supersampled; otherwise -1
  };

  // lambda' of one fragment: exact, the permitted minimum and maximum, and the renderer's. Infinite
  // if the texture coordinates are constant.
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
    int pass = -1;  // index if the scene is supersampled; otherwise -1
  };

  // What the answer shows of a thing: it is no less than `low`, and no more than `high`, or in one
  // of the cells.
  struct Shown {
    SingleThing thing;
    double low = 0;
    double high = 0;
    Shared<PlaceCells> cells = {};  // of sample_cells alone
    friend bool operator==(const Shown&, const Shown&) = default;
  };

  // In full: of gross faults only the first (diff/findings/add_disagreement.h). Sorted by pixel,
  // primitive, kind.
  std::vector<Disagreement> disagreements;
  // The rest. An answer without disagreements in full has none.
  std::vector<CountedDisagreements> counted;
  std::vector<ValueAggregate> values;
  std::vector<Evidence> evidence;               // of the primitives that have a disagreement
  std::vector<std::string> illegal_line_snaps;  // snaps under which some line is not legal
  // Alternatives under which some primitive that agrees with exact would differ.
  AlternativeSet refuted;
  // Where it may matter (diff/single_things.h); several primitives may show a thing differently.
  std::vector<Shown> shown;
  // For cases that request it (diff/compare.h): levels of detail along a row of fragments of
  // textured draws.
  std::vector<LevelPoint> ramp;
  // The fragments of both sides where they differ (diff/compare.h); empty if nothing differs.
  std::vector<ReportedFragment> exact_fragments;
  std::vector<ReportedFragment> rendered_fragments;
  Shared<PackedWords> pixels;  // RGBA8, bottom row first; empty when not run, or not kept
  PixelCounts pixel_counts;
  // Exact's pixels if they differ from the case's, with samples at the positions that this renderer
  // reports.
  Shared<PackedWords> exact_pixels;
  SampleImage samples;        // the renderer's, if the case is multisampled
  SampleImage exact_samples;  // exact's, if exact_pixels is set
};

// The number of disagreements, in full or counted.
inline std::size_t count_disagreements(const Result& result) {
  std::size_t count = result.disagreements.size();
  for (const CountedDisagreements& counted : result.counted) count += counted.count();
  return count;
}

// Calls `visit` with the class of each disagreement in full, and of the counted ones with each
// class once.
template <class ResultOrConst, class Visit>
void for_each_class(ResultOrConst& result, const Visit& visit) {
  for (auto& d : result.disagreements) visit(d);
  for (auto& counted : result.counted) visit(counted);
}

// True if `condition` is true of the class of a disagreement.
template <class Condition>
bool any_class(const Result& result, const Condition& condition) {
  return std::ranges::any_of(result.disagreements, condition) ||
         std::ranges::any_of(result.counted, condition);
}

// True if judging the result takes the whole run, as it does for every difference in coverage.
// Where the run has things that cannot be one, so does what shows them (Result::shown). Otherwise
// the result and the latitude decide (diff/judge.h).
inline bool depends_on_run(const Result& result) {
  return !result.disagreements.empty() || !result.evidence.empty();
}

}  // namespace edgecase
