// SPDX-License-Identifier: MIT
//
// Findings: what is measured of one surface, subject by subject, and the question that each subject
// is asked with.
//
// Traits say which rules are followed. The numbers behind them are kept as well: errors of values,
// residuals of levels of detail, sample positions, stored codes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exact/interval.h"
#include "exact/pixel.h"
#include "model/fragment_operations.h"
#include "model/policy.h"
#include "model/sampling.h"
#include "model/scene.h"
#include "profile/evidence/drawing.h"
#include "profile/evidence/trait.h"
#include "rules/choices.h"

namespace edgecase {

// ------------------------------------------------------------------------------- errors of values

// What of a fragment is compared.
enum class ValueKind { color, depth, inverse_w };

// "red", …, "depth", "gl_FragCoord.w". `component`: of a colour.
const char* component_name(ValueKind kind, int component);

// One component of one fragment that errs.
struct ValueExample {
  std::string id;  // of the scene that it was found in: "triangle smooth/00042"
  Scene scene;     // that scene, or its primitive alone where that shows the same
  int primitive = 0;
  PixelPosition pixel;
  int component = 0;  // of a colour; 0 otherwise
  double exact = 0;   // the double nearest to it
  double rendered = 0;
  double ulp = 0;       // error in distances of neighbouring float32 numbers at the exact value
  double relative = 0;  // error as a share of the range over the primitive's vertices
  // What ruling 9 allows, where it was asked.
  std::optional<Interval> permitted;
};

// How far the values of a renderer's fragments are from the exact ones, of one primitive type and
// mode.
struct ValueErrors {
  std::string attribute;  // "triangle smooth", "line depth", …
  ValueKind kind = ValueKind::color;
  // Exact by OpenGL's own rules, or by those that the renderer is found to follow instead.
  bool as_found = false;
  std::size_t fragments = 0;
  std::size_t components = 0;   // for which exact is a number
  std::size_t correct = 0;      // components that are correctly rounded
  std::size_t not_numbers = 0;  // NaN and infinity: in no other figure but `beyond`
  double ulp_sum = 0;
  std::map<int, std::size_t> histogram;  // of those not correctly rounded, by floor(log2(ULP))
  std::size_t beyond = 0;                // components outside ruling 9 (as_found: not asked)
  // Components of triangles for which that was not asked: where very many are far off, the search
  // over all moves of the vertices is made for some of them only.
  std::size_t not_asked = 0;
  std::size_t searches = 0;
  std::optional<ValueExample> worst_ulp;
  std::optional<ValueExample> worst_relative;
  std::optional<ValueExample> smallest_beyond;  // least target, then least primitive

  double mean_ulp() const;
  // The least power of two, 2^n ULP, below which the errors of this share of the numbers lie; none
  // where that many are correctly rounded.
  std::optional<int> log2_bound(double share) const;
};

// -------------------------------------------------------------------- residuals of levels of
// detail

// A level of detail that a renderer reports of a fragment, and how it came about.
enum class LevelSource {
  query,  // textureQueryLod: lambda'
  color,  // the level that was looked up, within the levels that there are
};
template <>
inline constexpr auto kNames<LevelSource> = std::to_array<Named<LevelSource>>(
    {{LevelSource::query, "query"}, {LevelSource::color, "color"}});

// What a renderer's formula may be off by and still be called its formula: twice the step of a
// level of detail of 8 bits.
constexpr double kMostResidual = 2 * 0x1p-8;

// The fragment that is farthest off.
struct ResidualExample {
  std::string id;  // of the scene that it was found in: "ramp rotated/00003"
  Scene scene;
  int primitive = 0;
  PixelPosition pixel;
  double told = 0;     // by the renderer, levels
  double formula = 0;  // levels
};

// The distances of the renderer's levels from those of one formula.
struct FormulaResidual {
  ScaleFactor scale_factor = ScaleFactor::lengths;
  Log2Method log2 = Log2Method::exact;
  bool is_found = false;  // the renderer is found to follow it
  std::size_t fragments = 0;
  double sum = 0;
  double largest = 0;
  std::optional<ResidualExample> worst;  // of the one found

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

// A number of samples that was asked for.
struct AskedSamples {
  int samples = 0;
  std::string refusal;  // why the renderer does not make them; empty: it does
};

// Between which positions an edge found a sample, pixels, both inclusive.
struct SampleInterval {
  Fixed low;
  Fixed high;
};

// Where one sample lies.
struct MeasuredPosition {
  Point reported;
  SampleInterval x;
  SampleInterval y;
  bool is_measured = false;  // false: no edges found it, or edges of the two sides contradict
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

// What the location of an invocation's own sample is called.
inline constexpr const char* kOwnSample = "own sample";

// How often the shader ran, and where it had its attributes, of draws that ask for it in one way.
struct InvocationRow {
  std::string asked;       // "once", "share 0.25", "sample"
  std::string location;    // of the attribute: its qualifier
  bool at_sample = false;  // must it be evaluated at the sample (rulings 29 and 30)?
  int least = 1;           // invocations that a wholly covered pixel must have
  // By how many samples of the pixel are covered: pixels by their number of invocations.
  std::map<int, std::map<int, std::size_t>> invocations;
  // By location ("centre", "own sample", …): attributes that were evaluated there, of wholly
  // covered pixels, and of others.
  std::map<std::string, std::size_t> whole;
  std::map<std::string, std::size_t> partial;

  // Was an attribute that is bound to its sample evaluated elsewhere?
  bool is_violation() const;
};

// Neighbouring alphas of which alpha to coverage makes the same mask.
struct AlphaRun {
  float first = 0;
  float last = 0;
  std::uint32_t mask = 0;
};

struct SampleProfile {
  std::string unavailable;  // why nothing was measured; empty: it was
  std::vector<AskedSamples> counts;
  int samples = 0;  // what all that follows, but for positions, was measured with
  std::vector<MeasuredPositions> positions;  // of each number of samples that is made
  std::size_t random_scenes = 0;
  std::size_t with_ties = 0;  // random scenes with a tie
  std::vector<InvocationRow> invocations;
  std::vector<AlphaRun> alphas;
};

// --------------------------------------------------------------------------- fragment operations

// Codes at one distance from the code at or below the exact number, and how far above that code the
// numbers lay, as shares of a step.
struct CodeStep {
  std::size_t numbers = 0;
  double least = 0;
  double largest = 0;
};

// What numbers of 0 to 1 become in an unsigned format.
struct CodeEvidence {
  std::string id;  // "depth16", "depth24", "unorm8"
  int bits = 0;
  std::size_t numbers = 0;
  std::map<long, CodeStep> steps;  // by distance from the code at or below
};

// One unit of polygon offset, measured by the depths of triangles without a slope.
struct MeasuredUnit {
  DepthFormat format = DepthFormat::none;
  int exponent = 0;  // of the largest depth, of a floating-point buffer
  std::size_t depths = 0;
  // In steps of 1/(2^bits - 1), or in 2^(exponent - 23).
  double least = 0;
  double largest = 0;
};

// How blended values differ from those of the alternative that comes closest, by term.
struct BlendResidual {
  BlendTerm term;
  bool is_alpha = false;
  std::size_t values = 0;
  std::map<int, std::size_t> off;  // by difference, 0 not among them
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
  std::size_t random_scenes = 0;  // of coverage of one sample
  std::size_t with_ties = 0;      // those of them with a tie
  std::vector<Trait> traits;
  Choices choices;    // of those traits that name a rule and that something was learnt of
  RuleChoices found;  // of coverage, snapping and values: what the renderer follows
  std::vector<OwnershipTable> tables;
  std::vector<ValueErrors> values;
  std::vector<LevelResiduals> levels;
  SampleProfile samples;
  OutputProfile output;
  // Families of scenes that show coverage, where the renderer may not follow its own profile.
  std::vector<std::vector<Observation>> observations;

  // Adds a trait. One that names a rule chooses its alternative, where something was learnt and an
  // alternative fits.
  void adopt(Trait trait);
};

struct Question {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  // Random scenes of each primitive type; a subject draws a share of it of each of its own kinds.
  std::size_t scenes_per_kind = 20'000;
};

// A part of the measurement: what it draws depends on what was found before.
struct Subject {
  // The most scenes that it draws, but for a few that it draws again alone.
  std::size_t (*scene_count)(std::size_t scenes_per_kind);
  void (*measure)(const Question&, SceneDrawing&, SurfaceFindings&);
};

// Has a subject draw its scenes, and adds to `findings`. Throws MeasurementStopped when `stop`
// became true.
void measure_subject(const Subject& subject, Renderer& renderer, const Question& question,
                     const ObservationProgress& progress, const std::atomic<bool>* stop,
                     SurfaceFindings& findings);

}  // namespace edgecase
