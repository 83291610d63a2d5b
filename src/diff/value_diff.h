// SPDX-License-Identifier: MIT
//
// Values: colours and depths of fragments, and pixels, held against what is exact under a policy
// and against what the specification permits (rulings 8 to 11), which knows no policy. Coverage is
// not looked at: a fragment that exact does not have is compared with the attribute's value at its
// place all the same.
#pragma once

#include <array>
#include <span>
#include <string>

#include "exact/pixel.h"
#include "model/policy.h"
#include "model/rendering.h"
#include "model/result.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

// What the comparison of values needs of a case.
struct ValueContext {
  const Scene& scene;
  std::span<const ScenePrimitive> primitives;
  ValueChoice choice;  // of the policy
  int bits = 4;        // as in ruling 4
  Latitude latitude = Latitude::opengl;
};

// Both append disagreements (beyond what is permitted) and aggregates (inside it) to `result`.

// Colours and depths, as the renderer tells them per fragment.
void compare_fragment_values(const ValueContext& context, const Rendering& rendered,
                             Result& result);

// Pixels, against the colour of the last fragment that the renderer says it drew there.
void compare_pixels(const ValueContext& context, const Rendering& rendered, Result& result);

// A value disagreement at a pixel, not legal, with the sample marked. primitive -1: the pixel.
Disagreement value_disagreement(PixelPosition pixel, int primitive, std::string rule, int ruling);

// Counts the values of one attribute that differ inside the permitted range, and keeps the worst.
class ValueAggregator {
 public:
  ValueAggregator(std::string attribute, std::string rule, int ruling);

  void count_compared() { ++aggregate_.compared; }
  // Errors of one place: add_error for each component that differs, then add_place once.
  void add_error(ValueAggregate::Place place, int component, std::array<double, 2> exact_rendered,
                 double ulp);
  void add_place(ValueAggregate::Place place) { aggregate_.differing.push_back(place); }
  // Appends the aggregate to the result, if anything differs.
  void flush(Result& result);

 private:
  ValueAggregate aggregate_;
};

}  // namespace edgecase
