// SPDX-License-Identifier: MIT
#include "rules/samples/alpha_thresholds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <numbers>
#include <vector>

#include "exact/elementary.h"

namespace edgecase {
namespace {

// Pixels of one alpha: how many of them keep each number of samples.
struct AlphaGroup {
  double alpha;
  double pixels;
  std::vector<double> by_kept;

  double mean() const {
    double sum = 0;
    for (std::size_t kept = 0; kept < by_kept.size(); ++kept)
      sum += static_cast<double>(kept) * by_kept[kept];
    return sum / pixels;
  }
  bool is_between() const { return alpha > 0 && alpha < 1; }
};

// In ascending order of alpha.
std::vector<AlphaGroup> groups_of(std::span<const KeptByAlpha> pixels, int samples) {
  std::map<double, AlphaGroup> groups;
  for (const KeptByAlpha& pixel : pixels) {
    const auto counts = static_cast<std::size_t>(samples) + 1;
    AlphaGroup& group =
        groups.try_emplace(pixel.alpha, AlphaGroup{pixel.alpha, 0, std::vector<double>(counts)})
            .first->second;
    group.pixels += 1;
    group.by_kept[static_cast<std::size_t>(pixel.kept)] += 1;
  }
  std::vector<AlphaGroup> result;
  for (auto& [alpha, group] : groups) result.push_back(std::move(group));
  return result;
}

// The odds of each number of kept samples where each is kept with the odds alpha, 0 to 1 exclusive.
std::vector<double> binomial(double alpha, std::size_t samples) {
  std::vector<double> odds(samples + 1);
  odds[0] = 1;
  for (std::size_t i = 1; i <= samples; ++i)
    for (std::size_t kept = i + 1; kept-- > 0;)
      odds[kept] = odds[kept] * (1 - alpha) + (kept > 0 ? odds[kept - 1] * alpha : 0);
  return odds;
}

bool falls(std::span<const AlphaGroup> groups) {
  return std::ranges::adjacent_find(groups, [](const AlphaGroup& one, const AlphaGroup& next) {
           return next.mean() < one.mean();
         }) != groups.end();
}

bool is_one_function(std::span<const AlphaGroup> groups) {
  double log_odds = 0;
  for (const AlphaGroup& group : groups) {
    if (!group.is_between()) continue;
    if (std::ranges::find(group.by_kept, group.pixels) == group.by_kept.end()) return false;
    double all_equal = 0;
    for (const double odds : binomial(group.alpha, group.by_kept.size() - 1))
      all_equal += raised(odds, group.pixels);
    // Of one pixel this is 1.
    log_odds += binary_logarithm(std::min(all_equal, 1.0));
  }
  return log_odds < binary_logarithm(kLeastOdds);
}

// What a pixel of an alpha that keeps so many samples adds to a sum over all pixels.
using Term = std::function<double(double alpha, double kept)>;

// A group with the term of each number of samples.
struct WeighedGroup {
  double pixels;
  std::vector<double> odds;
  std::vector<double> terms;
};

// The binary logarithm of an upper bound for the odds that a sum of the terms reaches `reached`:
// the least mean of exp(strength (sum - reached)) over positive strengths (Chernoff, 1952). The
// logarithm is convex in the strength.
double log_odds_of(std::span<const WeighedGroup> groups, double reached) {
  double largest = 0;
  for (const WeighedGroup& group : groups)
    for (const double term : group.terms) largest = std::max(largest, std::fabs(term));
  if (largest == 0) return 0;
  const auto log_mean = [&](double strength) {
    double sum = -strength * reached * std::numbers::log2e;
    for (const WeighedGroup& group : groups) {
      double mean = 0;
      for (std::size_t kept = 0; kept < group.odds.size(); ++kept)
        mean += group.odds[kept] * exponential(strength * group.terms[kept]);
      sum += group.pixels * binary_logarithm(mean);
    }
    return sum;
  };
  constexpr int kRounds = 40;
  constexpr double kStrongest = 200;  // exp(200) is finite
  double low = 0;
  double high = kStrongest / largest;
  for (int round = 0; round < kRounds; ++round) {
    const double third = (high - low) / 3;
    if (log_mean(low + third) < log_mean(high - third))
      high -= third;
    else
      low += third;
  }
  return std::min(0.0, log_mean(low));
}

// True if thresholds practically never yield a sum so large, or with `sign` -1 so small.
bool is_unlikely(std::span<const AlphaGroup> groups, double sign, const Term& term) {
  std::vector<WeighedGroup> weighed;
  double reached = 0;
  for (const AlphaGroup& group : groups) {
    if (!group.is_between()) continue;
    const std::size_t samples = group.by_kept.size() - 1;
    WeighedGroup next{group.pixels, binomial(group.alpha, samples), {}};
    for (std::size_t kept = 0; kept <= samples; ++kept) {
      next.terms.push_back(sign * term(group.alpha, static_cast<double>(kept)));
      reached += group.by_kept[kept] * next.terms.back();
    }
    weighed.push_back(std::move(next));
  }
  return log_odds_of(weighed, reached) < binary_logarithm(kLeastOdds);
}

double mean_alpha(std::span<const AlphaGroup> groups) {
  double sum = 0;
  double pixels = 0;
  for (const AlphaGroup& group : groups) {
    if (!group.is_between()) continue;
    sum += group.pixels * group.alpha;
    pixels += group.pixels;
  }
  return pixels == 0 ? 0 : sum / pixels;
}

}  // namespace

AlphaTrend trend_of(std::span<const KeptByAlpha> pixels, int samples) {
  const std::vector<AlphaGroup> groups = groups_of(pixels, samples);
  if (is_one_function(groups))
    return falls(groups) ? AlphaTrend::falling : AlphaTrend::disproportionate;
  const double middle = mean_alpha(groups);
  const Term slope = [&](double alpha, double kept) { return (alpha - middle) * kept; };
  const Term distance = [&](double alpha, double kept) {
    return (kept - alpha * samples) * (kept - alpha * samples);
  };
  const Term number = [](double, double kept) { return kept; };
  if (is_unlikely(groups, -1, slope)) {
    double rise = 0;
    for (const AlphaGroup& group : groups)
      if (group.is_between()) rise += group.pixels * slope(group.alpha, group.mean());
    return rise < 0 ? AlphaTrend::falling : AlphaTrend::disproportionate;
  }
  const bool is_off = is_unlikely(groups, 1, slope) || is_unlikely(groups, 1, distance) ||
                      is_unlikely(groups, 1, number) || is_unlikely(groups, -1, number);
  return is_off ? AlphaTrend::disproportionate : AlphaTrend::proportional;
}

}  // namespace edgecase
