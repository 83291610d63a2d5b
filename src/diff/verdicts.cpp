// SPDX-License-Identifier: MIT
#include "diff/verdicts.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "diff/coverage/legality.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

struct JudgedPixel {
  int x;
  int y;
  Verdict verdict;
};

bool is_same_pixel(const JudgedPixel& a, const JudgedPixel& b) {
  return a.x == b.x && a.y == b.y;
}

// The worst difference of a pixel comes first.
bool comes_first(const JudgedPixel& a, const JudgedPixel& b) {
  return std::tie(a.y, a.x, b.verdict) < std::tie(b.y, b.x, a.verdict);
}

// Adds pixels, which mostly are in order already, to others in order.
void merge_pixels(std::vector<JudgedPixel> more, std::vector<JudgedPixel>& pixels) {
  if (!std::ranges::is_sorted(more, comes_first)) std::ranges::sort(more, comes_first);
  std::vector<JudgedPixel> all;
  all.reserve(pixels.size() + more.size());
  std::ranges::merge(pixels, more, std::back_inserter(all), comes_first);
  pixels = std::move(all);
}

// Every pixel that differs, with its worst legality.
std::vector<JudgedPixel> judged_pixels(const Result& result, Latitude latitude) {
  std::vector<JudgedPixel> pixels;
  for (const Disagreement& d : result.disagreements)
    pixels.push_back({d.x, d.y, verdict_of(d, latitude)});
  std::ranges::sort(pixels, comes_first);
  for (const ValueAggregate& values : result.values) {
    const Verdict verdict = verdict_of(values, latitude);
    std::vector<JudgedPixel> more;
    more.reserve(values.differing.size());
    for (const ValueAggregate::Place& place : values.differing)
      more.push_back({place.x, place.y, verdict});
    merge_pixels(std::move(more), pixels);
  }
  pixels.erase(std::unique(pixels.begin(), pixels.end(), is_same_pixel), pixels.end());
  return pixels;
}

// The same of a gross fault, as the numbers of pixels by verdict. It differs at most pixels, and a
// byte for each is less than a list.
std::map<Verdict, std::size_t> count_gross(const Result& result, Latitude latitude) {
  int width = 0;
  int height = 0;
  const auto reach = [&](int x, int y) {
    width = std::max(width, x + 1);
    height = std::max(height, y + 1);
  };
  for (const Disagreement& d : result.disagreements) reach(d.x, d.y);
  for (const CountedDisagreements& counted : result.counted)
    for (const PixelRun& run : counted.runs) reach(run.end - 1, run.y);
  for (const ValueAggregate& values : result.values)
    for (const ValueAggregate::Place& place : values.differing) reach(place.x, place.y);
  std::vector<std::uint8_t> worst(static_cast<std::size_t>(width) *
                                  static_cast<std::size_t>(height));
  const auto add = [&](int y, int begin, int end, Verdict verdict) {
    const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    for (std::size_t x = row + static_cast<std::size_t>(begin);
         x < row + static_cast<std::size_t>(end); ++x)
      worst[x] = std::max(worst[x], static_cast<std::uint8_t>(verdict));
  };
  for (const Disagreement& d : result.disagreements)
    add(d.y, d.x, d.x + 1, verdict_of(d, latitude));
  for (const CountedDisagreements& counted : result.counted)
    for (const PixelRun& run : counted.runs)
      add(run.y, run.begin, run.end, verdict_of(counted, latitude));
  for (const ValueAggregate& values : result.values)
    for (const ValueAggregate::Place& place : values.differing)
      add(place.y, place.x, place.x + 1, verdict_of(values, latitude));
  std::map<Verdict, std::size_t> counts;
  for (const std::uint8_t verdict : worst) ++counts[static_cast<Verdict>(verdict)];
  return counts;
}

}  // namespace

Verdict verdict_of(const DisagreementClass& disagreement, Latitude latitude) {
  return verdict_of(disagreement.legality, is_open_choice(disagreement.cause), latitude);
}

Verdict verdict_of(const ValueAggregate& values, Latitude latitude) {
  return verdict_of(Legality::legal, is_open_choice(values.cause), latitude);
}

void count_pixels(Result& result, Latitude latitude) {
  PixelCounts& counts = result.pixel_counts;
  const std::size_t all = counts.all();
  if (all == 0) return;
  std::map<Verdict, std::size_t> found;
  if (result.counted.empty())
    for (const JudgedPixel& pixel : judged_pixels(result, latitude)) ++found[pixel.verdict];
  else
    found = count_gross(result, latitude);
  found[Verdict::agree] = 0;
  for (const Verdict verdict : kDrawnVerdicts) counts[verdict] = found[verdict];
  counts[Verdict::agree] = all - counts.all();
}

}  // namespace edgecase
