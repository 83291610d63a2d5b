// SPDX-License-Identifier: MIT
//
// Literal level selection: the formulas of the specification (GL 4.6 core, 8.14 and 8.14.3) in
// whole numbers, and every setting of filters and alternatives.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "rules/textures/level_selection.h"

namespace edgecase {

constexpr int kUnit = 1024;  // lambda is counted in steps of so many to a level

inline int floor_quotient(int a, int b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

struct Expected {
  Filter filter;
  int level, next;
  double weight;
  bool magnified;
};

struct Setting {
  Sampler sampler;
  int last = 0;
  LevelRules rules;
};

// 8.14: is lambda <= c?
inline bool is_magnified(int lambda, const Setting& s) {
  const bool nearest_mipmap =
      s.sampler.minify == Filter::nearest &&
      (s.sampler.mipmap == MipFilter::nearest || s.sampler.mipmap == MipFilter::linear);
  const bool half = s.rules.crossover == Crossover::by_filters &&
                    s.sampler.magnify == Filter::linear && nearest_mipmap;
  return lambda <= (half ? kUnit / 2 : 0);
}

// 8.14.3, the level d: base for lambda <= 1/2, ceil(base + lambda + 1/2) - 1 up to q + 1/2, else q.
inline int nearest_by_formula(int lambda, const Setting& s) {
  const int base = s.sampler.base_level;
  if (2 * lambda <= kUnit) return base;
  if (2 * (base * kUnit + lambda) > (2 * s.last + 1) * kUnit) return s.last;
  return -floor_quotient(-(2 * base * kUnit + 2 * lambda + kUnit), 2 * kUnit) - 1;
}

inline int nearest(int lambda, const Setting& s) {
  const int down = nearest_by_formula(lambda, s);
  const bool tie = lambda > 0 && lambda % kUnit == kUnit / 2;
  if (!tie || s.rules.nearest == NearestLevel::down_at_ties) return down;
  const bool up = s.rules.nearest == NearestLevel::up_at_ties || (lambda / kUnit) % 2 == 1;
  return std::min(up ? s.sampler.base_level + lambda / kUnit + 1 : down, s.last);
}

inline double weight(int fraction, LevelWeight choice) {
  const auto steps_of = [&](int steps, int added) {
    return static_cast<double>((2 * fraction * steps + added) / (2 * kUnit)) / steps;
  };
  switch (choice) {
    case LevelWeight::exact:
      return static_cast<double>(fraction) / kUnit;
    case LevelWeight::floor_8:
      return steps_of(256, 0);
    case LevelWeight::nearest_8:
      return steps_of(256, kUnit);
    case LevelWeight::floor_4:
      return steps_of(16, 0);
    case LevelWeight::nearest_4:
      return steps_of(16, kUnit);
    case LevelWeight::floor_3:
      return steps_of(8, 0);
    case LevelWeight::nearest_3:
      return steps_of(8, kUnit);
    case LevelWeight::whole:
      return 2 * fraction < kUnit ? 0 : 1;
    case LevelWeight::narrow:
      if (fraction < 7 * kUnit / 16) return 0;
      if (fraction > 9 * kUnit / 16) return 1;
      return (static_cast<double>(fraction) / kUnit - 7.0 / 16) / (2.0 / 16);
    case LevelWeight::one_at_ties:
      return 2 * fraction == kUnit ? 1 : static_cast<double>(fraction) / kUnit;
  }
  return 0;
}

inline Expected literal(int lambda, const Setting& s) {
  const int base = s.sampler.base_level;
  if (is_magnified(lambda, s)) return {s.sampler.magnify, base, base, 0, true};
  if (s.sampler.mipmap == MipFilter::none) return {s.sampler.minify, base, base, 0, false};
  if (s.sampler.mipmap == MipFilter::nearest) {
    const int d = nearest(lambda, s);
    return {s.sampler.minify, d, d, 0, false};
  }
  if (base * kUnit + lambda >= s.last * kUnit) return {s.sampler.minify, s.last, s.last, 0, false};
  const int d = base + floor_quotient(lambda, kUnit);
  return {s.sampler.minify, d, d + 1, weight(lambda % kUnit, s.rules.weight), false};
}

inline bool same_levels(const LevelPick& pick, const Expected& e) {
  return pick.filter == e.filter && pick.level == e.level && pick.next == e.next &&
         pick.magnified == e.magnified;
}

inline LevelPicks picks_of(Interval lambda, const Setting& s) {
  return pick_levels(lambda, s.sampler, s.last, s.rules);
}

template <class Visit>
void for_each_setting(Visit visit) {
  Setting s;
  for (const Filter magnify : {Filter::nearest, Filter::linear})
    for (const Filter minify : {Filter::nearest, Filter::linear})
      for (const MipFilter mipmap : {MipFilter::none, MipFilter::nearest, MipFilter::linear})
        for (const Crossover crossover : values_of<Crossover>())
          for (const auto& [base, last] : {std::pair{0, 6}, {0, 0}, {2, 5}}) {
            s.sampler.magnify = magnify;
            s.sampler.minify = minify;
            s.sampler.mipmap = mipmap;
            s.sampler.base_level = base;
            s.last = last;
            s.rules.crossover = crossover;
            const bool is_nearest = mipmap == MipFilter::nearest;
            const bool is_linear = mipmap == MipFilter::linear;
            for (const NearestLevel tie : values_of<NearestLevel>())
              for (const LevelWeight choice : values_of<LevelWeight>()) {
                if (!is_nearest && tie != NearestLevel::down_at_ties) continue;
                if (!is_linear && choice != LevelWeight::exact) continue;
                s.rules.nearest = tie;
                s.rules.weight = choice;
                visit(s);
              }
          }
}

}  // namespace edgecase
