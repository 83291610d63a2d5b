// SPDX-License-Identifier: MIT
#include "diff/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "diff/coverage/coverage_report.h"
#include "diff/coverage/legality.h"
#include "diff/differing_planes.h"
#include "diff/drawing_compare.h"
#include "diff/explaining_hypotheses.h"
#include "diff/findings/add_disagreement.h"
#include "diff/invariance.h"
#include "diff/pass_compare.h"
#include "diff/upside_down.h"
#include "diff/values/value_diff.h"
#include "raster/coverage_stages.h"
#include "raster/rasterizer.h"
#include "rules/coverage/clip_volume.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/window.h"
#include "rules/hypotheses.h"

namespace edgecase {
namespace {

bool reads_before(const Disagreement& a, const Disagreement& b) {
  const auto key_of = [](const Disagreement& d) {
    return std::tuple(d.y, d.x, d.primitive, d.sample, d.kind, std::string_view(name_of(d.rule)));
  };
  return key_of(a) < key_of(b);
}

Result compare_whole(const Drawing& drawing, const AlternativeSet& refuted) {
  const auto& [scene, policy, exact, rendered, facts] = drawing;
  if (!scene.supersampling.empty()) return compare_passes(drawing, refuted);
  const bool exact_values = has_exact_values(scene, policy, exact, rendered);
  return compare_drawing(drawing, refuted, exact_values ? Compared::coverage : Compared::all);
}

// Notes whether the answer is upside down, or is evidence that its renderer's answers are not.
void read_upside_down(const Drawing& drawing, Result& result) {
  const auto holds_upside_down = [&] {
    if (!is_covered_upside_down(drawing.exact, drawing.rendered)) return false;
    if (result.disagreements.empty()) return true;
    const Rendering turned = turned_over(drawing.rendered);
    // An alternative that is refuted already is not tried again.
    return compare_whole({drawing.scene, drawing.policy, drawing.exact, turned, drawing.facts},
                         AlternativeSet::all())
        .disagreements.empty();
  };
  if (!holds_upside_down())
    result.refuted.add({kWindowOrigin});
  else if (!result.disagreements.empty())
    note_upside_down(result);
}

// True if a single alternative that the specification forbids draws every primitive as it was
// drawn.
bool has_one_cause(const Result& result) {
  std::vector<Cause> common;
  bool is_first = true;
  for (const Result::Evidence& evidence : result.evidence) {
    if (evidence.primitive == kAllValues) continue;
    std::vector<Cause> singles;
    std::ranges::copy_if(evidence.causes, std::back_inserter(singles), [&](const Cause& cause) {
      return cause.size() == 1 && !is_open_choice(cause) &&
             (is_first || std::ranges::find(common, cause) != common.end());
    });
    common = std::move(singles);
    if (common.empty()) return false;
    is_first = false;
  }
  return !is_first;
}

// True if all that differs is drawn as the other of OpenGL and OpenGL ES has it.
bool is_of_other_api(const Result& result) {
  static const Cause ways[] = {alternative_id(RuleId::point_clip, name_of(PointClip::of_other_api)),
                               alternative_id(RuleId::line_clip, name_of(LineClip::of_other_api))};
  return !result.evidence.empty() &&
         std::ranges::all_of(result.evidence, [](const Result::Evidence& evidence) {
           return std::ranges::find_first_of(evidence.causes, ways) != evidence.causes.end();
         });
}

// True unless all that differs may be an open choice, or the other API's, which says nothing about
// a fault.
bool asks_for_hypotheses(const Result& result) {
  if (is_of_other_api(result)) return false;
  const auto has_no_open_cause = [](const Result::Evidence& evidence) {
    return std::ranges::none_of(evidence.causes,
                                [](const Cause& cause) { return is_open_choice(cause); });
  };
  return breaks_a_ruling(result) || std::ranges::any_of(result.evidence, has_no_open_cause) ||
         std::ranges::any_of(result.values, [](const ValueAggregate& values) {
           return values.cause.empty() && !values.differing.empty() &&
                  values.rule == RuleId::framebuffer_unorm8;
         });
}

// What is drawn in the larger target of an image may lie beyond the scene's own: it is told at the
// nearest pixel.
void report_variances(const Scene& scene, const Rendering& rendered, Result& result) {
  result.images = rendered.images;
  std::vector<Variance> variances = rendered.variances;
  find_variances_of_primitives(scene, rendered, variances);
  for (const Variance& variance : variances) {
    const auto [x, y] = variance.pixel;
    const PixelPosition nearest{std::clamp(x, 0, rendered.width - 1),
                                std::clamp(y, 0, rendered.height - 1)};
    DisagreementClass of =
        value_class(variance.primitive, RuleId::fragment_invariant, variance.ruling);
    of.legality = legality_against(variance.ruling);
    if (Disagreement* const d = add_disagreement(result, nearest, of)) {
      d->figure = value_figure(nearest);
      d->explanation = fmt::format(
          "{}{}. Ruling {}", variance.what,
          nearest == variance.pixel ? "" : fmt::format(", at ({}, {}), beyond the target", x, y),
          variance.ruling);
    }
  }
}

}  // namespace

RendererFacts facts_of(const RendererInfo& info, const ResolvedPolicy* profile) {
  const RendererClaims claims = claims_of(info);
  return {info.subpixel_bits, profile, claims.sizes, claims.lookups};
}

Result compare(const Scene& scene, const ResolvedPolicy& policy, const Rendering& exact,
               const Rendering& rendered, const RendererFacts& facts) {
  const Drawing drawing{scene, policy, exact, rendered, facts};
  Result result = compare_whole(drawing, {});
  if (!has_differences(result)) find_differing_planes(exact, rendered, result);
  read_upside_down(drawing, result);
  if (asks_for_hypotheses(result)) {
    result.hypotheses = explaining_hypotheses(drawing);
    if (has_one_cause(result)) result.hypotheses.push_back({kHasOneCause, kHasOneCause});
  }
  report_variances(scene, rendered, result);
  std::erase_if(result.values, [](const ValueAggregate& v) { return v.differing.empty(); });
  std::sort(result.disagreements.begin(), result.disagreements.end(), reads_before);
  // A run keeps all its results until the last one is there.
  result.disagreements.shrink_to_fit();
  result.pixel_counts[Verdict::agree] = rendered.pixels.size() / 4;
  result.pixel_counts.same = count_same_pixels(exact.pixels, rendered.pixels);
  return result;
}

Result not_run(Failure failure) {
  Result result;
  result.verdict = Verdict::not_run;
  result.failure = std::move(failure);
  return result;
}

Figure scene_figure(const Scene& scene) {
  Figure figure;
  // A vertex that several primitives share is marked once.
  std::set<std::tuple<std::int64_t, std::int64_t, bool>> marked;
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    if (primitive.is_clipped) {
      const Figure seen = figure_of_seen(primitive);
      figure.marks.insert(figure.marks.end(), seen.marks.begin(), seen.marks.end());
      continue;
    }
    const auto count = static_cast<std::size_t>(vertices_of(primitive.kind));
    Mark outline{MarkRole::primitive, count == 3, {}, std::to_string(primitive.index)};
    for (std::size_t i = 0; i < count; ++i) {
      const Point position = nearest_point(primitive.positions[i]);
      const bool is_quotient = primitive.vertices[i]->clip.has_value();
      const char* about = is_quotient ? "about " : "";
      outline.points.push_back(position_of(position));
      if (!marked.emplace(position.x.raw(), position.y.raw(), is_quotient).second) continue;
      figure.marks.push_back(
          {MarkRole::vertex, false, {position_of(position)}, about + format_point(position)});
    }
    figure.marks.push_back(std::move(outline));
  }
  figure.marks.shrink_to_fit();
  return figure;
}

std::vector<PixelExplanation> explain_pixel(const Scene& scene, const ResolvedPolicy& policy, int x,
                                            int y) {
  const RuleChoices& choices = policy.on(scene.target.surface);
  std::vector<PixelExplanation> result;
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    const CoverageChoice& choice = choices.of(primitive.kind);
    const SamplePositions positions = positions_of(scene.target, choice, {});
    const SampleCoverage coverage = covered_samples(primitive, scene.target, choice, {});
    const bool multisampled = is_multisampled(*primitive.state, scene.target);
    const RuleId rule = is_culled(primitive, scene.target, choice)
                            ? RuleId::polygon_facing
                            : rule_on_coverage(primitive, scene.target);
    for (std::size_t s = 0; s < (multisampled ? positions.size() : 1); ++s) {
      const Point within = multisampled ? positions[s] : centre_of_pixel();
      Explanation why = explain(primitive, place_in({x, y}, within), scene.target, choice);
      const bool covered = std::ranges::find(coverage[s], PixelPosition{x, y}) != coverage[s].end();
      result.push_back({primitive.index, multisampled ? static_cast<int>(s) : -1, covered, rule,
                        std::move(why.text), std::move(why.figure)});
    }
  }
  return result;
}

namespace {

constexpr std::size_t kPixel = 4;  // bytes
// Two blocks fit in the first level of every cache.
constexpr std::size_t kBlock = 4096;

// Compares pixels as 32-bit words, copied since neither side need be aligned; the copies are free.
std::size_t count_words(const std::uint8_t* a, const std::uint8_t* b, std::size_t pixels) {
  // The sum of a block fits in 32 bits, and with one width the compiler keeps the lanes.
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    std::uint32_t own = 0;
    std::uint32_t other = 0;
    std::memcpy(&own, a + kPixel * i, kPixel);
    std::memcpy(&other, b + kPixel * i, kPixel);
    count += own == other ? 1 : 0;
  }
  return count;
}

}  // namespace

std::size_t count_same_pixels(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
  const std::size_t bytes = std::min(a.size(), b.size()) / kPixel * kPixel;
  std::size_t count = 0;
  for (std::size_t at = 0; at < bytes; at += kBlock) {
    const std::size_t length = std::min(kBlock, bytes - at);
    const bool is_same = std::memcmp(a.data() + at, b.data() + at, length) == 0;
    count += is_same ? length / kPixel : count_words(a.data() + at, b.data() + at, length / kPixel);
  }
  return count;
}

}  // namespace edgecase
