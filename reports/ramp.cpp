// SPDX-License-Identifier: MIT
#include "reports/ramp.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rules/all_rules.h"

namespace edgecase {
namespace {

// Levels of detail are judged under it.
constexpr int kLevelRuling = 19;

double distance(float a, float b) {
  return a == b ? 0 : std::abs(static_cast<double>(a) - static_cast<double>(b));
}

// A point's numbers, rounded.
struct Rounded {
  float exact;
  float low;
  float high;
  float rendered;

  explicit Rounded(const Result::LevelPoint& point)
      : exact(static_cast<float>(point.exact)),
        low(static_cast<float>(point.low)),
        high(static_cast<float>(point.high)),
        rendered(static_cast<float>(point.rendered)) {}

  bool inside() const { return low <= rendered && rendered <= high; }
  double from_exact() const { return distance(rendered, exact); }
  double from_band() const { return distance(rendered, rendered < low ? low : high); }
};

void keep_largest(double& largest, double value) {
  if (std::isfinite(value)) largest = std::max(largest, value);
}

std::string levels(double distance) {
  const std::string figure = fmt::format("{:.3g}", distance);
  if (figure == "1") return "1 level";
  return figure + (distance < 1 ? " of a level" : " levels");
}

// "12 of 256 fragments", "the only fragment".
std::string share(std::size_t part, std::size_t all) {
  if (all == 1) return "the only fragment";
  return part == all ? fmt::format("all {} fragments", all)
                     : fmt::format("{} of {} fragments", part, all);
}

std::string exact_words(const RampSummary& summary) {
  const std::size_t all = summary.fragments - summary.unknown;
  if (all == 0) return "Exact has no number";
  if (!summary.farthest) return fmt::format("Equal to exact at {}", share(all, all));
  std::string text;
  if (summary.not_numbers > 0)
    text = fmt::format("Not a number at {}", share(summary.not_numbers, all));
  if (summary.infinitely_far > 0)
    text += fmt::format("{} from exact at {}", text.empty() ? "Infinitely far" : ", infinitely far",
                        share(summary.infinitely_far, all));
  if (text.empty()) return fmt::format("At most {} from exact", levels(summary.from_exact));
  if (summary.not_numbers + summary.infinitely_far < all)
    text += summary.from_exact > 0
                ? fmt::format(", elsewhere at most {} from exact", levels(summary.from_exact))
                : ", elsewhere equal to exact";
  return text;
}

}  // namespace

RampSummary summarize_ramp(const std::vector<Result::LevelPoint>& ramp) {
  RampSummary summary;
  summary.fragments = ramp.size();
  double farthest = 0;
  for (std::size_t i = 0; i < ramp.size(); ++i) {
    const Rounded point(ramp[i]);
    if (!point.inside()) summary.outside.push_back(i);
    if (!point.inside()) keep_largest(summary.from_band, point.from_band());
    if (std::isnan(point.exact)) {
      ++summary.unknown;
      continue;
    }
    const double away = point.from_exact();
    const bool no_number = std::isnan(point.rendered);
    if (no_number) ++summary.not_numbers;
    if (std::isinf(away)) ++summary.infinitely_far;
    keep_largest(summary.from_exact, away);
    // No number is farther than NaN, so the first one stays.
    if ((no_number && !std::isnan(farthest)) || away > farthest) {
      farthest = away;
      summary.farthest = i;
    }
  }
  return summary;
}

std::string describe(const RampSummary& summary) {
  std::string text = exact_words(summary);
  if (summary.unknown > 0 && summary.unknown < summary.fragments)
    text += fmt::format(", exact has no number at {}", share(summary.unknown, summary.fragments));
  if (summary.outside.empty()) return text + ", inside the permitted band.";
  text += fmt::format("; outside the permitted band at {}",
                      share(summary.outside.size(), summary.fragments));
  if (summary.from_band > 0) text += fmt::format(", by at most {}", levels(summary.from_band));
  return text + ".";
}

std::vector<std::string> open_causes_of_levels(const Result& result) {
  const bool blamed = std::ranges::any_of(
      result.disagreements, [](const Disagreement& d) { return d.ruling == kLevelRuling; });
  std::vector<std::string> causes;
  if (blamed) return causes;
  for (const ValueAggregate& values : result.values)
    if (values.ruling == kLevelRuling && !values.cause.empty() &&
        std::ranges::find(causes, text_of(values.cause)) == causes.end())
      causes.push_back(text_of(values.cause));
  return causes;
}

}  // namespace edgecase
