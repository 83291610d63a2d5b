// SPDX-License-Identifier: MIT
#include "rules/values/cut_line.h"

#include "exact/rational.h"
#include "model/clipped_line.h"

namespace edgecase {
namespace {

std::array<Interval, 3> weighted(const std::array<std::array<Interval, 2>, 2>& shares,
                                 const std::array<double, 3>& values) {
  // What is one number at both vertices is so all the way.
  if (values[0] == values[1]) return {values[0], values[0], 0};
  const auto mean = [&](std::size_t end) {
    return shares[end][0] * values[0] + shares[end][1] * values[1];
  };
  return {mean(0), mean(1), 0};
}

}  // namespace

std::optional<CutLine> CutLine::of(const ScenePrimitive& line) {
  const RationalClip from = rational_clip(*line.vertices[0], line.viewport);
  const RationalClip to = rational_clip(*line.vertices[1], line.viewport);
  const auto part = visible_part(from, to);
  if (!part) return std::nullopt;
  CutLine result;
  const Rational* const parts[] = {&part->from, &part->to};
  for (std::size_t end = 0; end < 2; ++end) {
    const Rational& t = *parts[end];
    const RationalClip clip = between(from, to, t);
    result.w_[end] = interval_of(clip.w);
    result.depths_[end] = interval_of(Rational(clip.z / clip.w));
    result.shares_[end] = {interval_of(Rational(1 - t)), interval_of(t)};
    result.window_shares_[end] = {interval_of(Rational((1 - t) * from.w / clip.w)),
                                  interval_of(Rational(t * to.w / clip.w))};
  }
  return result;
}

std::array<Interval, 3> CutLine::smooth(const std::array<double, 3>& values) const {
  return weighted(shares_, values);
}

std::array<Interval, 3> CutLine::noperspective(const std::array<double, 3>& values) const {
  return weighted(window_shares_, values);
}

}  // namespace edgecase
