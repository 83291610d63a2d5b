// SPDX-License-Identifier: MIT
//
// The rule book's worked scenes: cases of the suite, a pixel of each, and the rule to which the
// question belongs. Whether it is drawn, and why, is not said here: exact does.
#pragma once

#include <span>
#include <string_view>

#include "model/rule_id.h"

namespace edgecase {

struct WorkedScene {
  RuleId rule = RuleId::none;  // in whose section it stands
  std::string_view case_id;    // as `edgecase run --list` prints it
  int x = 0;                   // pixel of the target, y up
  int y = 0;
};

// In the order of the book.
std::span<const WorkedScene> worked_scenes();

}  // namespace edgecase
