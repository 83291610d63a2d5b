// SPDX-License-Identifier: MIT
//
// Results made up for tests of judging, which asks nothing of a scene.
#pragma once

#include <algorithm>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "diff/judge.h"
#include "tests/support/causes.h"

namespace edgecase {

inline std::vector<Result*> pointers(std::deque<Result>& results) {
  std::vector<Result*> list;
  for (Result& result : results) list.push_back(&result);
  return list;
}

inline std::string judge_all(std::deque<Result>& results, Latitude latitude = Latitude::opengl) {
  return judge(pointers(results), latitude);
}

// A case with one triangle that differs and is legal.
inline Result triangle_result(const std::vector<std::string>& causes, int x = 0) {
  Result result;
  Disagreement d;
  d.x = x;
  d.primitive = 0;
  d.rule = rule_named("triangle.fill-rule");
  d.ruling = 4;
  d.legality = Legality::legal;
  result.disagreements = {d};
  result.evidence = {{0, causes_named(causes), {}, ""}};
  return result;
}

// A case that agrees, and that one alternative would have drawn otherwise.
inline Result agreeing_but_for(const std::string& refuted) {
  Result result;
  result.refuted.add(cause_named(refuted).parts.at(0));
  return result;
}

}  // namespace edgecase
