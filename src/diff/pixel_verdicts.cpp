// SPDX-License-Identifier: MIT
#include "diff/pixel_verdicts.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "diff/coverage/cause.h"
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

// Each pixel at which something differs, with the worst of it.
std::vector<JudgedPixel> judged_pixels(const Result& result, Latitude latitude) {
  std::vector<JudgedPixel> pixels;
  for (const Disagreement& d : result.disagreements)
    pixels.push_back({d.x, d.y, verdict_of(d, latitude)});
  for (const ValueAggregate& values : result.values) {
    const Verdict verdict = verdict_of(values, latitude);
    for (const ValueAggregate::Place& place : values.differing)
      pixels.push_back({place.x, place.y, verdict});
  }
  // The worst of a pixel first, which is the one that stays.
  std::sort(pixels.begin(), pixels.end(), [](const JudgedPixel& a, const JudgedPixel& b) {
    return std::tie(a.y, a.x, b.verdict) < std::tie(b.y, b.x, a.verdict);
  });
  pixels.erase(std::unique(pixels.begin(), pixels.end(), is_same_pixel), pixels.end());
  return pixels;
}

}  // namespace

Verdict verdict_of(const Disagreement& disagreement, Latitude latitude) {
  if (latitude == Latitude::none || disagreement.legality == Legality::illegal)
    return Verdict::violation;
  if (disagreement.legality == Legality::contested) return Verdict::contested;
  return is_open_choice(disagreement.cause) ? Verdict::convention : Verdict::permitted;
}

Verdict verdict_of(const ValueAggregate& values, Latitude latitude) {
  if (latitude == Latitude::none) return Verdict::violation;
  return is_open_choice(values.cause) ? Verdict::convention : Verdict::permitted;
}

void count_pixels(Result& result, Latitude latitude) {
  const PixelCounts before = result.pixel_counts;
  const std::size_t all =
      before.agree + before.convention + before.permitted + before.contested + before.violation;
  if (all == 0) return;
  PixelCounts& counts = result.pixel_counts = {};
  counts.same = before.same;
  for (const JudgedPixel& pixel : judged_pixels(result, latitude))
    ++(pixel.verdict == Verdict::violation   ? counts.violation
       : pixel.verdict == Verdict::contested ? counts.contested
       : pixel.verdict == Verdict::permitted ? counts.permitted
                                             : counts.convention);
  counts.agree = all - counts.convention - counts.permitted - counts.contested - counts.violation;
}

}  // namespace edgecase
