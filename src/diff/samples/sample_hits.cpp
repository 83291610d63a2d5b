// SPDX-License-Identifier: MIT
//
// Compares how often samples were written (rulings 32 and 33): as often as the renderer's own
// fragments cover them, less those that alpha to coverage removes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "diff/findings/add_disagreement.h"
#include "diff/samples/sample_values.h"
#include "diff/values/ignored_multisample.h"
#include "diff/values/pixel_truth.h"
#include "diff/values/sample_writers.h"
#include "rules/samples/alpha_thresholds.h"
#include "rules/samples/sample_mask.h"

namespace edgecase {
namespace {

constexpr RuleId kAlphaRule = RuleId::sample_alpha_to_coverage;
constexpr int kAlphaRuling = 33;

class HitComparison {
 public:
  HitComparison(const ValueContext& context, const Rendering& rendered)
      : context_(context),
        rendered_(rendered),
        chosen_(context.choices.samples.alpha_to_coverage) {}

  void run(Result& result) {
    cause_ = cause();
    ValueAggregator aggregator("written samples", kAlphaRule, kAlphaRuling, cause_);
    for_each_sample([&](PixelPosition pixel, std::span<const Fragment> fragments, int sample) {
      aggregator.count_compared(1);
      compare(pixel, fragments, sample, aggregator, result);
      return true;
    });
    aggregator.flush(result);
    judge_masks(result);
  }

 private:
  // Calls `visit` with each pixel and its fragments, by row and column.
  template <class Visit>
  bool for_each_pixel(const Visit& visit) const {
    auto next = rendered_.fragments.begin();
    for (int y = 0; y < rendered_.height; ++y) {
      for (int x = 0; x < rendered_.width; ++x) {
        const auto first = next;
        while (next != rendered_.fragments.end() && next->x == x && next->y == y) ++next;
        if (!visit(PixelPosition{x, y}, std::span<const Fragment>(first, next))) return false;
      }
    }
    return true;
  }
  template <class Visit>
  bool for_each_sample(const Visit& visit) const {
    return for_each_pixel([&](PixelPosition pixel, std::span<const Fragment> fragments) {
      for (int sample = 0; sample < rendered_.samples; ++sample)
        if (!visit(pixel, fragments, sample)) return false;
      return true;
    });
  }

  // A pixel whose only fragment covers all samples, and how many of them it kept.
  struct WholePixel {
    PixelPosition pixel;
    double alpha = 0;
    int kept = 0;
  };

  // True if all fragments of a pixel are thinned, cover all samples and certainly have one alpha.
  bool have_one_alpha(std::span<const Fragment> fragments) const {
    const std::uint32_t all = mask_of_all(rendered_.samples);
    return !fragments.empty() && std::ranges::all_of(fragments, [&](const Fragment& f) {
      return is_thinned(context_, f) && f.has_color && (f.coverage & all) == all &&
             f.color[3] == fragments.front().color[3] && !may_fade(context_, f);
    });
  }

  // Reports numbers of samples that are not proportional to alpha, not even over all pixels, and
  // fragments of one alpha that keep different samples of a pixel.
  void judge_masks(Result& result) const {
    std::vector<WholePixel> whole;
    for_each_pixel([&](PixelPosition pixel, std::span<const Fragment> fragments) {
      if (!have_one_alpha(fragments)) return true;
      const std::optional<int> kept = kept_samples(pixel, fragments, result);
      if (kept && fragments.size() == 1)
        whole.push_back({pixel, fragments.front().color[3], *kept});
      return true;
    });
    std::erase_if(whole, [](const WholePixel& one) { return std::isnan(one.alpha); });
    note_alphas(whole, result);
    const auto is_off = [&](const WholePixel& one) {
      const bool is_end = !(one.alpha > 0 && one.alpha < 1);  // other rulings decide the ends
      return !is_end && !is_proportional(one.alpha, one.kept, rendered_.samples);
    };
    if (std::ranges::none_of(whole, is_off)) return;
    std::vector<KeptByAlpha> pixels;
    for (const WholePixel& one : whole) pixels.push_back({one.alpha, one.kept});
    const AlphaTrend trend = trend_of(pixels, rendered_.samples);
    if (trend == AlphaTrend::proportional) return;
    const int ruling = trend == AlphaTrend::falling ? kAlphaRuling : kRulingOnProportion;
    for (const WholePixel& one : whole)
      if (is_off(one)) report_proportion(one, ruling, result);
  }

  // Notes of each number of samples whether the pixel keeps it at an alpha no larger than its own,
  // or at one no smaller. Only of few pixels: a run needs no more than its small scenes.
  void note_alphas(const std::vector<WholePixel>& whole, Result& result) const {
    constexpr std::size_t kMost = 256;  // notes
    const int samples = rendered_.samples;
    if (context_.scene.target.surface != Surface::fbo ||
        whole.size() * static_cast<std::size_t>(samples) > kMost)
      return;
    for (const auto& [pixel, alpha, kept] : whole) {
      if (!(alpha > 0 && alpha < 1)) continue;  // other rulings decide the ends
      for (int count = 1; count <= samples; ++count)
        result.shown.push_back({{SingleThing::Kind::alpha, samples, count, pixel.x, pixel.y},
                                count > kept ? alpha : 0,
                                count > kept ? 1 : alpha,
                                {}});
    }
  }

  // The number of samples that were written by all fragments of a pixel, which have one alpha;
  // nothing if some sample was not written by all or by none of them, which is reported. More hits
  // than fragments are reported as such.
  std::optional<int> kept_samples(PixelPosition pixel, std::span<const Fragment> fragments,
                                  Result& result) const {
    int kept = 0;
    bool is_one_mask = true;
    for (int sample = 0; sample < rendered_.samples; ++sample) {
      const std::uint32_t hits = hits_at(pixel, sample);
      if (hits == fragments.size()) ++kept;
      if (hits == 0 || hits == fragments.size()) continue;
      is_one_mask = false;
      if (hits < fragments.size()) report_two_masks(pixel, fragments, sample, hits, result);
    }
    return is_one_mask ? std::optional(kept) : std::nullopt;
  }

  void report_proportion(const WholePixel& one, int ruling, Result& result) const {
    Disagreement d = value_disagreement(one.pixel, -1, kAlphaRule, ruling);
    d.exact = {one.alpha * rendered_.samples};
    d.rendered = {static_cast<double>(one.kept)};
    d.explanation = fmt::format(
        "an alpha of {:.9g} is {:.9g} of {} samples; a fragment that covers all of them kept {}",
        one.alpha, d.exact[0], rendered_.samples, one.kept);
    d.cause = cause_;
    add_disagreement(result, std::move(d));
  }

  void report_two_masks(PixelPosition pixel, std::span<const Fragment> fragments, int sample,
                        std::uint32_t hits, Result& result) const {
    Disagreement d = value_disagreement(pixel, -1, kAlphaRule, kAlphaRuling);
    d.sample = sample;
    d.exact = {static_cast<double>(fragments.size())};
    d.rendered = {static_cast<double>(hits)};
    d.explanation = fmt::format(
        "{} fragments of the pixel have the same alpha, {:.9g}, and cover all samples; {} of them "
        "wrote sample {}",
        fragments.size(), fragments.front().color[3], hits, sample);
    add_disagreement(result, std::move(d));
  }

  // How often a sample is written under a choice, by the renderer's own fragments.
  std::uint32_t writes(std::span<const Fragment> fragments, int sample,
                       AlphaToCoverage choice) const {
    return writes(fragments, sample, choice, MultisampleSwitch::honoured);
  }
  std::uint32_t writes(std::span<const Fragment> fragments, int sample, AlphaToCoverage choice,
                       MultisampleSwitch without) const {
    std::uint32_t count = 0;
    for (const Fragment& fragment : fragments) {
      if (!covers_sample(context_, fragment, sample, without)) continue;
      const std::uint32_t kept = is_thinned(context_, fragment)
                                     ? kept_by_alpha(context_, fragment, fragments, choice)
                                     : ~std::uint32_t{0};
      count += kept >> sample & 1;
    }
    return count;
  }

  // The least and the largest number of writes that ruling 33 permits.
  std::pair<std::uint32_t, std::uint32_t> permitted(std::span<const Fragment> fragments,
                                                    int sample) const {
    std::uint32_t least = 0;
    std::uint32_t most = 0;
    for (const Fragment& fragment : fragments) {
      if (!covers_sample(context_, fragment, sample)) continue;
      const SampleCounts counts = written_samples(context_, fragment);
      least += counts.least == rendered_.samples ? 1 : 0;
      most += counts.most > 0 ? 1 : 0;
    }
    return {least, most};
  }

  std::uint32_t hits_at(PixelPosition pixel, int sample) const {
    return rendered_.hits[rendered_.sample_index(pixel.x, pixel.y, sample)];
  }

  Cause cause() const {
    return cause_among(
        values_of<AlphaToCoverage>(), chosen_, kAlphaRule, [&](AlphaToCoverage choice) {
          return for_each_sample(
              [&](PixelPosition pixel, std::span<const Fragment> fragments, int sample) {
                return writes(fragments, sample, choice) == hits_at(pixel, sample);
              });
        });
  }

  void compare(PixelPosition pixel, std::span<const Fragment> fragments, int sample,
               ValueAggregator& aggregator, Result& result) const {
    const std::uint32_t hits = hits_at(pixel, sample);
    const std::uint32_t exact = writes(fragments, sample, chosen_);
    if (hits == exact) return;
    const auto [least, most] = permitted(fragments, sample);
    if (hits < least || hits > most) {
      report(pixel, fragments, sample, hits, result);
      return;
    }
    const ValueAggregate::Place place{pixel.x, pixel.y, -1};
    const double error = std::abs(static_cast<double>(hits) - static_cast<double>(exact));
    aggregator.add_error(place, {sample, static_cast<double>(exact), static_cast<double>(hits),
                                 error, static_cast<double>(rendered_.samples)});
    aggregator.add_place(place);
  }

  // The rule by which writes may differ from what a fragment covers.
  std::pair<RuleId, int> rule_on(std::span<const Fragment> fragments) const {
    if (std::ranges::any_of(fragments, [&](const Fragment& f) { return is_thinned(context_, f); }))
      return {kAlphaRule, kAlphaRuling};
    const bool switched_off = std::ranges::any_of(fragments, [&](const Fragment& f) {
      return !context_.primitive_of(f).state->multisampling.enabled;
    });
    const RuleId rule = switched_off ? RuleId::sample_enable : RuleId::sample_mask;
    return {rule, rule_of(rule).ruling};
  }

  void report(PixelPosition pixel, std::span<const Fragment> fragments, int sample,
              std::uint32_t hits, Result& result) const {
    const auto [rule, ruling] = rule_on(fragments);
    Disagreement d = value_disagreement(pixel, -1, rule, ruling);
    d.sample = sample;
    d.exact = {static_cast<double>(writes(fragments, sample, chosen_))};
    d.rendered = {static_cast<double>(hits)};
    d.explanation = fmt::format(
        "fragments wrote sample {}: {}; by those that the renderer reports, it should have been "
        "{}. Ruling {}",
        sample, hits, d.exact[0], ruling);
    if (d.rule == kAlphaRule) d.cause = cause_;
    for (const MultisampleSwitch choice : switches_beside(context_, fragments))
      if (d.cause.empty() && writes(fragments, sample, chosen_, choice) == hits)
        d.cause = cause_of(choice);
    add_disagreement(result, std::move(d));
  }

  const ValueContext& context_;
  const Rendering& rendered_;
  const AlphaToCoverage chosen_;
  Cause cause_;  // of the effect of alpha to coverage
};

}  // namespace

void compare_sample_hits(const ValueContext& context, const Rendering& rendered, Result& result) {
  HitComparison(context, rendered).run(result);
}

}  // namespace edgecase
