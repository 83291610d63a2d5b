// SPDX-License-Identifier: MIT
//
// The rule book's worked scenes: cases of the suite, a pixel of each, and the rule of the question.
// Exact answers whether the pixel is drawn, and why.
#pragma once

#include <span>
#include <string_view>

#include "model/rule_id.h"

namespace edgecase {

struct WorkedScene {
  RuleId rule = RuleId::none;  // the section of the book
  std::string_view case_id;    // as `edgecase run --list` prints it
  int x = 0;                   // pixel of the target, y up
  int y = 0;
};

// In the order of the book.
std::span<const WorkedScene> worked_scenes();

}  // namespace edgecase
