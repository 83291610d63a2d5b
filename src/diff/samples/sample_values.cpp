// SPDX-License-Identifier: MIT
//
// Compares a multisampled target as a whole (rulings 31 to 33): each resolved pixel must lie
// between the renderer's own samples, either those that it reports or those that its fragments
// make, and each sample must have been written as often as the renderer's own fragments cover it,
// less those that alpha to coverage removes.
#include "diff/samples/sample_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "diff/values/pixel_values.h"
#include "diff/values/sample_writers.h"
#include "rules/samples/resolve.h"
#include "rules/samples/sample_mask.h"

namespace edgecase {
namespace {

constexpr RuleId kAlphaRule = RuleId::sample_alpha_to_coverage;
constexpr int kAlphaRuling = 33;
constexpr int kProportionRuling = 52;

class ResolveComparison {
 public:
  ResolveComparison(const ValueContext& context, const Rendering& rendered)
      : context_(context),
        rendered_(rendered),
        chosen_(context.choices.samples.resolve),
        are_reported_(!rendered.sample_pixels.empty()),
        samples_(are_reported_ ? reported_samples(rendered)
                               : inferred_samples(context, rendered, AlphaEnds::heeded)) {}

  void run(Result& result) {
    ValueAggregator aggregator("resolved pixel", kRule, kRuling, cause());
    for_each_pixel([&](PixelPosition pixel) {
      aggregator.count_compared(4);
      if (!is_permitted(samples_, pixel))
        report(pixel, result);
      else
        aggregate(pixel, aggregator);
      return true;
    });
    aggregator.flush(result);
  }

 private:
  static constexpr RuleId kRule = RuleId::sample_resolve;
  static constexpr int kRuling = 31;
  static constexpr int kRulingBeyond = 51;

  // Stops when `visit` returns false; returns true if it never did.
  template <class Visit>
  bool for_each_pixel(const Visit& visit) const {
    for (int y = 0; y < rendered_.height; ++y)
      for (int x = 0; x < rendered_.width; ++x)
        if (!visit(PixelPosition{x, y})) return false;
    return true;
  }

  std::vector<std::uint8_t> values_at(const std::vector<std::uint8_t>& planes, PixelPosition pixel,
                                      std::size_t component) const {
    std::vector<std::uint8_t> values;
    for (int s = 0; s < rendered_.samples; ++s)
      values.push_back(planes[4 * rendered_.sample_index(pixel.x, pixel.y, s) + component]);
    return values;
  }
  std::vector<std::uint8_t> samples_at(PixelPosition pixel, std::size_t component) const {
    return values_at(samples_.nearest, pixel, component);
  }
  std::uint8_t stored_at(PixelPosition pixel, std::size_t component) const {
    return rendered_.pixels[4 * rendered_.pixel_index(pixel.x, pixel.y) + component];
  }

  // True if the method makes everything that is stored of such samples. It never falls as a sample
  // grows, and moves by one code at most for one code.
  bool yields(ResolveMethod method, const std::vector<std::uint8_t>& low,
              const std::vector<std::uint8_t>& high) const {
    return for_each_pixel([&](PixelPosition pixel) {
      for (std::size_t c = 0; c < 4; ++c)
        if (stored_at(pixel, c) < resolved(values_at(low, pixel, c), method) ||
            stored_at(pixel, c) > resolved(values_at(high, pixel, c), method))
          return false;
      return true;
    });
  }

  // Samples that are not reported are assumed to hold the nearest values when a cause is sought.
  Cause cause() const {
    const auto among = [&](const std::vector<std::uint8_t>& low,
                           const std::vector<std::uint8_t>& high) {
      return cause_among(values_of<ResolveMethod>(), chosen_, kRule,
                         [&](ResolveMethod method) { return yields(method, low, high); });
    };
    const Cause found = among(samples_.nearest, samples_.nearest);
    if (are_reported_ || !found.empty() || yields(chosen_, samples_.low, samples_.high))
      return found;
    return among(samples_.low, samples_.high);
  }

  // From the samples of the pixel and its neighbours, since filters wider than a pixel exist.
  ResolvedRange permitted(const SamplePlanes& samples, PixelPosition pixel,
                          std::size_t component) const {
    ResolvedRange range{255, 0};
    for (int y = std::max(pixel.y - 1, 0); y <= std::min(pixel.y + 1, rendered_.height - 1); ++y)
      for (int x = std::max(pixel.x - 1, 0); x <= std::min(pixel.x + 1, rendered_.width - 1); ++x) {
        const auto low = resolve_permitted(values_at(samples.low, {x, y}, component)).low;
        const auto high = resolve_permitted(values_at(samples.high, {x, y}, component)).high;
        range = {std::min(range.low, low), std::max(range.high, high)};
      }
    return range;
  }
  bool is_permitted(const SamplePlanes& samples, PixelPosition pixel) const {
    for (std::size_t c = 0; c < 4; ++c)
      if (!permitted(samples, pixel, c).contains(stored_at(pixel, c))) return false;
    return true;
  }

  void aggregate(PixelPosition pixel, ValueAggregator& aggregator) const {
    const ValueAggregate::Place place{pixel.x, pixel.y, -1};
    bool differs = false;
    for (std::size_t c = 0; c < 4; ++c) {
      const int exact = resolved(samples_at(pixel, c), chosen_);
      const int stored = stored_at(pixel, c);
      if (exact == stored) continue;
      differs = true;
      aggregator.add_error(
          place, {static_cast<int>(c), static_cast<double>(exact), static_cast<double>(stored),
                  static_cast<double>(std::abs(stored - exact)), 255});
    }
    if (differs) aggregator.add_place(place);
  }

  // True if samples that alpha to coverage wrongly kept or removed account for the pixel.
  bool is_due_to_alpha(PixelPosition pixel) {
    if (are_reported_) return false;
    if (!without_alpha_) without_alpha_ = inferred_samples(context_, rendered_, AlphaEnds::open);
    return is_permitted(*without_alpha_, pixel);
  }

  void report(PixelPosition pixel, Result& result) {
    const bool alpha = is_due_to_alpha(pixel);
    Disagreement d = value_disagreement(pixel, -1, alpha ? kAlphaRule : kRule,
                                        alpha ? kAlphaRuling : kRulingBeyond);
    std::string ranges;
    for (std::size_t c = 0; c < 4; ++c) {
      const ResolvedRange range = permitted(samples_, pixel, c);
      d.exact.push_back(resolved(samples_at(pixel, c), chosen_));
      d.rendered.push_back(stored_at(pixel, c));
      ranges += fmt::format("{}{} to {}", c == 0 ? "" : ", ", range.low, range.high);
    }
    d.explanation = fmt::format(
        "the resolved pixel should hold ({}), the mean of its {} samples; it holds ({}), and the "
        "renderer's own samples {} {}",
        fmt::join(d.exact, ", "), rendered_.samples, fmt::join(d.rendered, ", "),
        are_reported_ ? "are" : "are, by its fragments,", ranges);
    result.disagreements.push_back(std::move(d));
  }

  const ValueContext& context_;
  const Rendering& rendered_;
  const ResolveMethod chosen_;
  const bool are_reported_;
  const SamplePlanes samples_;
  std::optional<SamplePlanes> without_alpha_;
};

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
  template <class Visit>
  bool for_each_sample(const Visit& visit) const {
    auto next = rendered_.fragments.begin();
    for (int y = 0; y < rendered_.height; ++y) {
      for (int x = 0; x < rendered_.width; ++x) {
        const auto first = next;
        while (next != rendered_.fragments.end() && next->x == x && next->y == y) ++next;
        for (int sample = 0; sample < rendered_.samples; ++sample)
          if (!visit(PixelPosition{x, y}, std::span<const Fragment>(first, next), sample))
            return false;
      }
    }
    return true;
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

  // Reports numbers of samples that are not proportional to alpha, and fragments of one alpha that
  // keep different samples of a pixel.
  void judge_masks(Result& result) const {
    std::vector<WholePixel> whole;
    for_each_sample([&](PixelPosition pixel, std::span<const Fragment> fragments, int sample) {
      if (!have_one_alpha(fragments)) return true;
      const std::uint32_t hits = hits_at(pixel, sample);
      if (hits != 0 && hits != fragments.size()) {
        report_two_masks(pixel, fragments, sample, hits, result);
      } else if (fragments.size() == 1) {
        if (sample == 0) whole.push_back({pixel, fragments.front().color[3], 0});
        whole.back().kept += hits != 0 ? 1 : 0;
      }
      return true;
    });
    const int ruling = falls_with_alpha(whole) ? kAlphaRuling : kProportionRuling;
    for (const WholePixel& one : whole) {
      const bool is_end = !(one.alpha > 0 && one.alpha < 1);  // other rulings decide the ends
      if (!is_end && !is_proportional(one.alpha, one.kept, rendered_.samples))
        report_proportion(one, ruling, result);
    }
  }

  // True if the mean number of kept samples falls from an alpha to a larger one.
  static bool falls_with_alpha(std::vector<WholePixel> whole) {
    std::ranges::sort(whole, {}, &WholePixel::alpha);
    double before = 0;
    for (auto first = whole.begin(); first != whole.end();) {
      double sum = 0;
      auto last = first;
      for (; last != whole.end() && last->alpha == first->alpha; ++last) sum += last->kept;
      const double mean = sum / static_cast<double>(last - first);
      if (mean < before) return true;
      before = mean;
      first = last;
    }
    return false;
  }

  void report_proportion(const WholePixel& one, int ruling, Result& result) const {
    Disagreement d = value_disagreement(one.pixel, -1, kAlphaRule, ruling);
    d.exact = {one.alpha * rendered_.samples};
    d.rendered = {static_cast<double>(one.kept)};
    d.explanation = fmt::format(
        "an alpha of {:.9g} is {:.9g} of {} samples; a fragment that covers all of them kept {}",
        one.alpha, d.exact[0], rendered_.samples, one.kept);
    d.cause = cause_;
    result.disagreements.push_back(std::move(d));
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
    result.disagreements.push_back(std::move(d));
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
    return switched_off ? std::pair(RuleId::sample_enable, 35) : std::pair(RuleId::sample_mask, 32);
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
    result.disagreements.push_back(std::move(d));
  }

  const ValueContext& context_;
  const Rendering& rendered_;
  const AlphaToCoverage chosen_;
  Cause cause_;  // of the effect of alpha to coverage
};

}  // namespace

void compare_resolved_pixels(const ValueContext& context, const Rendering& rendered,
                             Result& result) {
  ResolveComparison(context, rendered).run(result);
}

void compare_sample_hits(const ValueContext& context, const Rendering& rendered, Result& result) {
  HitComparison(context, rendered).run(result);
}

}  // namespace edgecase
