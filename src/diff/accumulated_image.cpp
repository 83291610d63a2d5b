// SPDX-License-Identifier: MIT
#include "diff/accumulated_image.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "diff/coverage/legality.h"
#include "diff/findings/add_disagreement.h"
#include "diff/findings/patience.h"
#include "diff/textures/untold_colors.h"
#include "diff/values/pixel_truth.h"
#include "diff/values/value_diff.h"
#include "raster/samples.h"
#include "rules/all_rules.h"
#include "rules/choices.h"
#include "rules/rule.h"
#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

constexpr RuleId kRule = RuleId::supersample_accumulation;
constexpr int kRuling = 36;
constexpr RuleId kBytesRule = RuleId::framebuffer_unorm8;
constexpr int kBytesRuling = 10;

bool reports_all_colors(std::span<const Rendering> passes) {
  return std::ranges::all_of(passes, [](const Rendering& pass) {
    return std::ranges::all_of(pass.fragments, &Fragment::has_color);
  });
}

// The renderer's passes, each colour that it does not report being `color_of` its truth.
template <class ColorOf>
std::vector<Rendering> with_colors(const Drawing& drawing, const ColorOf& color_of) {
  const auto& [scene, policy, exact, rendered, facts] = drawing;
  const RuleChoices& choices = policy.on(scene.target.surface);
  std::vector<Rendering> passes = rendered.passes;
  for (std::size_t k = 0; k < passes.size(); ++k) {
    const Scene pass = pass_of(scene, k);
    const std::vector<ScenePrimitive> primitives = primitives_of(pass);
    ValueContext values(pass, primitives, choices, latitude_bits(facts.reported_subpixel_bits),
                        policy.latitude());
    values.follow_limits(facts.lookups);
    UntoldColors untold(values, exact.passes[k], rendered.passes[k]);
    values.follow_lookups([&](const Fragment& fragment) { return untold.of(fragment); });
    for (std::size_t i = 0; i < passes[k].fragments.size(); ++i) {
      const Fragment& told = rendered.passes[k].fragments[i];
      if (told.has_color) continue;
      const PixelTruth truth = truth_of_fragment(values, told);
      for (std::size_t c = 0; c < 4; ++c) passes[k].fragments[i].color[c] = color_of(truth, c);
    }
  }
  return passes;
}

class AccumulationComparison {
 public:
  AccumulationComparison(const Drawing& drawing, Result& result)
      : scene_(drawing.scene),
        rendered_(drawing.rendered),
        chosen_(drawing.policy.on(scene_.target.surface).samples.accumulation),
        are_colors_reported_(reports_all_colors(rendered_.passes)),
        result_(result) {
    if (are_colors_reported_) {
      permitted_ = permitted_image(rendered_.passes, chosen_);
      expected_ = accumulated_image(scene_, rendered_.passes, chosen_);
      return;
    }
    const auto colors = [&](const auto& color_of) { return with_colors(drawing, color_of); };
    permitted_ = permitted_image(
        colors([](const PixelTruth& truth, std::size_t c) { return accepted(truth, c).low; }),
        chosen_);
    const auto high = permitted_image(
        colors([](const PixelTruth& truth, std::size_t c) { return accepted(truth, c).high; }),
        chosen_);
    for (std::size_t i = 0; i < high.size(); ++i) permitted_[i] = hull(permitted_[i], high[i]);
    expected_ = accumulated_image(
        scene_, colors([](const PixelTruth& truth, std::size_t c) { return truth.exact[c]; }),
        chosen_);
  }

  void run() {
    const Cause cause = are_colors_reported_ ? find_cause() : Cause();
    ValueAggregator means("accumulated color", kRule, kRuling, cause);
    ValueAggregator bytes("accumulated pixel", kBytesRule, kBytesRuling);
    for (int y = 0; y < rendered_.height; ++y) {
      Patience::check();
      for (int x = 0; x < rendered_.width; ++x) {
        compare_mean({x, y}, cause, means);
        compare_bytes({x, y}, bytes);
      }
    }
    means.flush(result_);
    bytes.flush(result_);
  }

 private:
  std::size_t first_of(PixelPosition pixel) const {
    return 4 * rendered_.pixel_index(pixel.x, pixel.y);
  }

  std::vector<Interval> permitted_image(std::span<const Rendering> passes,
                                        Accumulation choice) const {
    std::vector<Interval> image;
    for_each_shown(scene_, passes, [&](std::span<const double> shown) {
      image.push_back(accumulation_permitted(shown, scene_.supersampling, choice));
    });
    return image;
  }

  // True if a number follows a choice: to the bit where ruling 36 allows the choice, in double or
  // in single precision; otherwise to within what the ruling would allow.
  bool is_as(std::size_t i, std::span<const double> shown, Accumulation choice) const {
    const double reported = rendered_.accumulated[i];
    const Alternative& alternative = *find_alternative(rule_of(kRule), name_of(choice));
    if (alternative.openness == Openness::illegal)
      return accumulation_permitted(shown, scene_.supersampling, choice).contains(reported);
    return is_nearest(reported, accumulated(shown, scene_.supersampling, choice));
  }

  static bool is_nearest(double reported, double expected) {
    if (std::isnan(expected)) return std::isnan(reported);
    return reported == expected || reported == to_float(expected);
  }

  // The first alternative that yields the whole image; none if no alternative does, or the chosen
  // one.
  Cause find_cause() const {
    std::vector<Accumulation> left(values_of<Accumulation>().begin(),
                                   values_of<Accumulation>().end());
    std::size_t i = 0;
    for_each_shown(scene_, rendered_.passes, [&](std::span<const double> shown) {
      std::erase_if(left, [&](Accumulation choice) { return !is_as(i, shown, choice); });
      ++i;
    });
    if (left.empty() || std::ranges::find(left, chosen_) != left.end()) return {};
    return alternative_id(kRule, name_of(left.front()));
  }

  bool is_permitted(std::size_t first) const {
    for (std::size_t c = 0; c < 4; ++c)
      if (!permitted_[first + c].contains(rendered_.accumulated[first + c]) &&
          !holds_anything(permitted_[first + c]))
        return false;
    return true;
  }

  // NaN lies in no interval.
  static bool holds_anything(const Interval& permitted) {
    return std::isinf(permitted.low) && std::isinf(permitted.high);
  }

  void compare_mean(PixelPosition pixel, const Cause& cause, ValueAggregator& aggregator) {
    const std::size_t first = first_of(pixel);
    aggregator.count_compared(4);
    if (!is_permitted(first)) {
      report_mean(pixel, cause);
      return;
    }
    bool differs = false;
    for (std::size_t c = 0; c < 4; ++c) {
      const double reported = rendered_.accumulated[first + c];
      const double expected = expected_[first + c];
      if (is_nearest(reported, expected)) continue;
      differs = true;
      ValueAggregator::Error error{static_cast<int>(c), expected, reported,
                                   error_in_ulp(expected, reported), 1};
      if (!are_colors_reported_) error.permitted = permitted_[first + c];
      aggregator.add_error({pixel.x, pixel.y, -1}, error);
    }
    if (differs) aggregator.add_place({pixel.x, pixel.y, -1});
  }

  std::span<const double> reported_at(std::size_t first) const {
    return std::span(rendered_.accumulated).subspan(first, 4);
  }

  void report_mean(PixelPosition pixel, const Cause& cause) {
    const std::size_t first = first_of(pixel);
    Disagreement d = value_disagreement(pixel, -1, kRule, kRuling);
    d.cause = cause;
    const auto reported = reported_at(first);
    std::string ranges;
    for (std::size_t c = 0; c < 4; ++c) {
      d.exact.push_back(expected_[first + c]);
      d.rendered.push_back(reported[c]);
      ranges += fmt::format("{}{:.9g} to {:.9g}", c == 0 ? "" : ", ", permitted_[first + c].low,
                            permitted_[first + c].high);
    }
    d.explanation = fmt::format(
        "the accumulated pixel should hold ({:.9g}), the weighted mean of what the renderer's own "
        "{} passes show there; it holds ({:.9g}), and ruling {} permits {}",
        fmt::join(d.exact, ", "), rendered_.passes.size(), fmt::join(d.rendered, ", "), kRuling,
        ranges);
    add_disagreement(result_, std::move(d));
  }

  static Unorm8Range bytes_of(double component) {
    return unorm8_permitted(std::isnan(component) ? Interval::everything() : component);
  }

  void compare_bytes(PixelPosition pixel, ValueAggregator& aggregator) {
    const std::size_t first = first_of(pixel);
    aggregator.count_compared(4);
    bool differs = false;
    for (std::size_t c = 0; c < 4; ++c) {
      const double reported = rendered_.accumulated[first + c];
      const std::uint8_t stored = rendered_.pixels[first + c];
      const Unorm8Range range = bytes_of(reported);
      if (stored < range.low || stored > range.high) {
        report_bytes(pixel);
        return;
      }
      if (std::isnan(reported) || stored == to_unorm8(reported)) continue;
      differs = true;
      aggregator.add_error({pixel.x, pixel.y, -1},
                           {static_cast<int>(c), reported * 255, static_cast<double>(stored),
                            std::fabs(stored - reported * 255), 255});
    }
    if (differs) aggregator.add_place({pixel.x, pixel.y, -1});
  }

  void report_bytes(PixelPosition pixel) {
    const std::size_t first = first_of(pixel);
    Disagreement d = value_disagreement(pixel, -1, kBytesRule, kBytesRuling);
    for (std::size_t c = 0; c < 4; ++c) {
      d.exact.push_back(to_unorm8(rendered_.accumulated[first + c]));
      d.rendered.push_back(rendered_.pixels[first + c]);
    }
    d.explanation = fmt::format(
        "the pixel should hold ({}), the renderer's own accumulated colour ({:.9g}) in 8 bits; it "
        "holds ({})",
        fmt::join(d.exact, ", "), fmt::join(reported_at(first), ", "), fmt::join(d.rendered, ", "));
    add_disagreement(result_, std::move(d));
  }

  const Scene& scene_;
  const Rendering& rendered_;
  const Accumulation chosen_;
  const bool are_colors_reported_;  // all colours of fragments are reported
  // By component of each pixel. Expected: under the choice, with exact's colours where none are
  // reported.
  std::vector<Interval> permitted_;
  std::vector<double> expected_;
  Result& result_;
};

}  // namespace

void compare_accumulated(const Drawing& drawing, Result& result) {
  AccumulationComparison(drawing, result).run();
}

}  // namespace edgecase
