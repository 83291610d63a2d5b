// SPDX-License-Identifier: MIT
//
// Compares resolved pixels (rulings 31 and 51): each must lie between the renderer's own samples,
// either those that it reports or those that its fragments make.
#include "diff/samples/sample_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "diff/findings/add_disagreement.h"
#include "diff/values/pixel_truth.h"
#include "diff/values/sample_writers.h"
#include "rules/samples/resolve.h"

namespace edgecase {
namespace {

constexpr RuleId kAlphaRule = RuleId::sample_alpha_to_coverage;
constexpr int kAlphaRuling = 33;

// One component of a pixel's samples.
class SampleValues {
 public:
  void add(std::uint8_t value) { values_[count_++] = value; }
  operator std::span<const std::uint8_t>() const { return {values_.data(), count_}; }  // NOLINT

 private:
  std::array<std::uint8_t, kMaxSamples> values_;
  std::size_t count_ = 0;
};

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

  // Stops when `visit` returns false; returns true if it never did.
  template <class Visit>
  bool for_each_pixel(const Visit& visit) const {
    for (int y = 0; y < rendered_.height; ++y)
      for (int x = 0; x < rendered_.width; ++x)
        if (!visit(PixelPosition{x, y})) return false;
    return true;
  }

  SampleValues values_at(const std::vector<std::uint8_t>& planes, PixelPosition pixel,
                         std::size_t component) const {
    SampleValues values;
    for (int s = 0; s < rendered_.samples; ++s)
      values.add(planes[4 * rendered_.sample_index(pixel.x, pixel.y, s) + component]);
    return values;
  }
  SampleValues samples_at(PixelPosition pixel, std::size_t component) const {
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

  ResolvedRange permitted_by_own(const SamplePlanes& samples, PixelPosition pixel,
                                 std::size_t component) const {
    return {resolve_permitted(values_at(samples.low, pixel, component)).low,
            resolve_permitted(values_at(samples.high, pixel, component)).high};
  }
  // From the samples of the pixel and its neighbours, since filters wider than a pixel exist.
  ResolvedRange permitted(const SamplePlanes& samples, PixelPosition pixel,
                          std::size_t component) const {
    ResolvedRange range{255, 0};
    for (int y = std::max(pixel.y - 1, 0); y <= std::min(pixel.y + 1, rendered_.height - 1); ++y)
      for (int x = std::max(pixel.x - 1, 0); x <= std::min(pixel.x + 1, rendered_.width - 1); ++x) {
        const ResolvedRange own = permitted_by_own(samples, {x, y}, component);
        range = {std::min(range.low, own.low), std::max(range.high, own.high)};
      }
    return range;
  }
  bool is_permitted(const SamplePlanes& samples, PixelPosition pixel) const {
    for (std::size_t c = 0; c < 4; ++c) {
      const std::uint8_t stored = stored_at(pixel, c);
      // The range has that of the pixel itself, which mostly decides.
      if (!permitted_by_own(samples, pixel, c).contains(stored) &&
          !permitted(samples, pixel, c).contains(stored))
        return false;
    }
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
                                        alpha ? kAlphaRuling : kRulingBeyondSamples);
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
    add_disagreement(result, std::move(d));
  }

  const ValueContext& context_;
  const Rendering& rendered_;
  const ResolveMethod chosen_;
  const bool are_reported_;
  const SamplePlanes samples_;
  std::optional<SamplePlanes> without_alpha_;
};

}  // namespace

void compare_resolved_pixels(const ValueContext& context, const Rendering& rendered,
                             Result& result) {
  ResolveComparison(context, rendered).run(result);
}

}  // namespace edgecase
