// SPDX-License-Identifier: MIT
//
// Findings: the measurements of one surface, subject by subject, and the input of each subject.
//
// Traits state which rules are followed. The numbers behind them are kept as well: errors of
// values, residuals of levels of detail, sample positions, stored codes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exact/fixed.h"
#include "exact/interval.h"
#include "model/fragment_operations.h"
#include "model/policy.h"
#include "model/sampling.h"
#include "model/scene.h"
#include "profile/evidence/drawing.h"
#include "profile/evidence/inference.h"
#include "rules/choices.h"

namespace edgecase {

// ------------------------------------------------------------------------------- errors of values

// The compared value of a fragment.
enum class ValueKind { color, depth, inverse_w };

// "red", …, "depth", "gl_FragCoord.w". `component`: of a colour.
const char* component_name(ValueKind kind, int component);

// One component of one fragment that errs.
struct ValueExample {
  std::string id;  // of the scene in which it was found: "triangle smooth/00042"
  Scene scene;     // that scene, or only its primitive if that shows the same
  int primitive = 0;
  PixelPosition pixel;
  int component = 0;  // of a colour; otherwise 0
  double exact = 0;   // the double nearest to the exact value
  double rendered = 0;
  double ulp = 0;       // error in distances of neighbouring float32 numbers at the exact value
  double relative = 0;  // error relative to the range over the primitive's vertices
  // The range of ruling 9, if it was computed.
  std::optional<Interval> permitted;
};

// The errors of a renderer's fragment values, for one primitive type and mode.
struct ValueErrors {
  std::string attribute;  // "triangle smooth", "line depth", …
  ValueKind kind = ValueKind::color;
  // Exact under OpenGL's own rules, or under those that the renderer was found to follow.
  bool as_found = false;
  std::size_t fragments = 0;
  std::size_t components = 0;   // those for which exact is a number
  std::size_t correct = 0;      // correctly rounded components
  std::size_t not_numbers = 0;  // NaN and infinity, counted otherwise only in `beyond`
  double ulp_sum = 0;
  std::map<int, std::size_t> histogram;  // of those not correctly rounded, by floor(log2(ULP))
  std::size_t beyond = 0;                // components outside ruling 9 (not computed if as_found)
  // Components of triangles for which `beyond` was not computed: if very many err much, the search
  // over all moves of the vertices is made for only some of them.
  std::size_t not_asked = 0;
  std::size_t searches = 0;
  std::optional<ValueExample> worst_ulp;
  std::optional<ValueExample> worst_relative;
  std::optional<ValueExample> smallest_beyond;  // least target, then least primitive

  double mean_ulp() const;
  // The least power of two, 2^n ULP, above the errors of this share of the components; nothing if
  // that many are correctly rounded.
  std::optional<int> log2_bound(double share) const;
};

// -------------------------------------------------------------------- residuals of levels of
// detail

// A level of detail that a renderer reports for a fragment, and its source.
enum class LevelSource {
  query,  // textureQueryLod: lambda'
  color,  // the level that was looked up, within the existing levels
};
template <>
inline constexpr auto kNames<LevelSource> = std::to_array<Named<LevelSource>>(
    {{LevelSource::query, "query"}, {LevelSource::color, "color"}});

// The largest error with which a formula still counts as the renderer's: twice the step of a level
// of detail of 8 bits.
constexpr double kMostResidual = 2 * 0x1p-8;

// The fragment with the largest error.
struct ResidualExample {
  std::string id;  // of the scene in which it was found: "ramp rotated/00003"
  Scene scene;
  int primitive = 0;
  PixelPosition pixel;
  double reported = 0;  // by the renderer, in levels
  double formula = 0;   // in levels
};

// The distances of the renderer's levels from those of one formula.
struct FormulaResidual {
  ScaleFactor scale_factor = ScaleFactor::lengths;
  Log2Method log2 = Log2Method::exact;
  bool is_found = false;  // the renderer is found to follow it
  std::size_t fragments = 0;
  double sum = 0;
  double largest = 0;
  std::optional<ResidualExample> worst;  // only of the one found

  double mean() const { return fragments == 0 ? 0 : sum / static_cast<double>(fragments); }
};

struct LevelResiduals {
  std::string ramp;  // the kind of footprints: "rotated"
  LevelSource source = LevelSource::query;
  std::string derivatives;                // the method
  std::vector<FormulaResidual> formulas;  // every scale factor with every logarithm

  const FormulaResidual& found() const;
};

// --------------------------------------------------------------------------- multisampled targets

// A requested number of samples.
struct AskedSamples {
  int samples = 0;
  std::string refusal;  // why the renderer does not support it; otherwise empty
};

// The positions between which an edge found a sample, in pixels, both inclusive.
struct SampleInterval {
  Fixed low;
  Fixed high;
};

// The position of one sample.
struct MeasuredPosition {
  Point reported;
  SampleInterval x;
  SampleInterval y;
  bool is_measured = false;  // false if no edges found it, or edges of the two sides contradict
  bool is_as_reported() const {
    return is_measured && x.low <= reported.x && reported.x <= x.high && y.low <= reported.y &&
           reported.y <= y.high;
  }
};

struct MeasuredPositions {
  int samples = 0;
  std::vector<MeasuredPosition> positions;  // by sample; empty: none are reported
  std::string placement;                    // the alternative of sample.positions; empty: none fits
};

// The name of the location of an invocation's own sample.
inline constexpr const char* kOwnSample = "own sample";

// How often the shader ran, and where attributes were evaluated, for one way of requesting it.
struct InvocationRow {
  std::string asked;       // "once", "share 0.25", "sample"
  std::string location;    // of the attribute: its qualifier
  bool at_sample = false;  // it must be evaluated at the sample (rulings 29 and 30)
  int least = 1;           // required invocations for a fully covered pixel
  // By the number of covered samples of a pixel: pixels by their number of invocations.
  std::map<int, std::map<int, std::size_t>> invocations;
  // Attributes by the location where they were evaluated ("centre", "own sample", …), for fully
  // covered pixels and for others.
  std::map<std::string, std::size_t> whole;
  std::map<std::string, std::size_t> partial;

  // Whether an attribute that is bound to its sample was evaluated elsewhere.
  bool is_violation() const;
};

// Neighbouring alphas for which alpha to coverage makes the same mask.
struct AlphaRun {
  float first = 0;
  float last = 0;
  std::uint32_t mask = 0;
};

struct SampleProfile {
  std::string unavailable;  // why nothing was measured; otherwise empty
  std::vector<AskedSamples> counts;
  int samples = 0;                           // for all of the following, except positions
  std::vector<MeasuredPositions> positions;  // for each supported number of samples
  std::size_t random_scenes = 0;
  std::size_t with_ties = 0;  // random scenes with a tie
  std::vector<InvocationRow> invocations;
  std::vector<AlphaRun> alphas;
};

// --------------------------------------------------------------------------- fragment operations

// Codes at one distance from the code at or below the exact number, and how far above that code the
// numbers were, as shares of a step.
struct CodeStep {
  std::size_t numbers = 0;
  double least = 0;
  double largest = 0;
};

// The codes of numbers from 0 to 1 in an unsigned format.
struct CodeEvidence {
  std::string id;  // "depth16", "depth24", "unorm8"
  int bits = 0;
  std::size_t numbers = 0;
  std::map<long, CodeStep> steps;  // by distance from the code at or below
};

// One unit of polygon offset, measured by the depths of triangles without a slope.
struct MeasuredUnit {
  DepthFormat format = DepthFormat::none;
  int exponent = 0;  // of the largest depth, for a floating-point buffer
  std::size_t depths = 0;
  // In steps of 1/(2^bits - 1), or in 2^(exponent - 23).
  double least = 0;
  double largest = 0;
};

// How blended values differ from those of the closest alternative, by term.
struct BlendResidual {
  BlendTerm term;
  bool is_alpha = false;
  std::size_t values = 0;
  std::map<int, std::size_t> off;  // by difference, without 0
  std::size_t wrong() const;
};

struct OutputProfile {
  std::vector<CodeEvidence> codes;
  std::vector<MeasuredUnit> units;
  std::vector<BlendResidual> blending;  // those that differ, the worst first
  std::size_t random_scenes = 0;
};

// -------------------------------------------------------------------------------------- the whole

// The findings of one surface. Every subject adds its own.
struct SurfaceFindings {
  DrawnCounts drawn;
  std::size_t random_scenes = 0;  // of coverage with one sample
  std::size_t with_ties = 0;      // those of them with a tie
  std::vector<Trait> traits;
  Choices choices;    // of traits with a rule about which something was learnt
  RuleChoices found;  // of coverage, snapping and values: what the renderer follows
  std::vector<OwnershipTable> tables;
  std::vector<ValueErrors> values;
  std::vector<LevelResiduals> levels;
  SampleProfile samples;
  OutputProfile output;
  // Families of scenes about coverage, in which the renderer may not follow its own profile.
  std::vector<std::vector<Observation>> observations;

  // Adds a trait. If it names a rule, its alternative is chosen, provided that something was learnt
  // and an alternative fits.
  void adopt(Trait trait);
};

struct Question {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  // Random scenes of each primitive type; a subject draws a share of this for each of its kinds.
  std::size_t scenes_per_kind = 100;
  // So many random scenes of each primitive type are searched for those that tell alternatives of
  // coverage apart which the drawn ones do not; these are drawn as well.
  std::size_t searched_scenes = 20'000;
};

// A part of the measurement; its scenes depend on earlier findings.
struct Subject {
  // The largest number of scenes that it draws, except for a few that it draws again alone.
  std::size_t (*scene_count)(std::size_t scenes_per_kind);
  void (*measure)(const Question&, SceneDrawing&, SurfaceFindings&);
};

// Has a subject draw its scenes, and adds to `findings`. Throws MeasurementStopped once `stop` is
// true.
void measure_subject(const Subject& subject, Renderer& renderer, const Question& question,
                     const ObservationProgress& progress, const std::atomic<bool>* stop,
                     SurfaceFindings& findings);

}  // namespace edgecase
