// SPDX-License-Identifier: MIT
//
// Holds the measurements of one `edgecase bench` against those of another: of another build, or of
// another day.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace edgecase {

// One figure that both have: a median, or seconds a case.
struct ComparedFigure {
  std::string path;  // "scenes / flat fill, 20 layers / exact / seconds"
  double here = 0;
  double there = 0;
};

// `here` and `there`: two texts of bench_json. What only one of them has is left out. A text that
// is none gives the message.
std::variant<std::vector<ComparedFigure>, std::string> compare_benches(const std::string& here,
                                                                       const std::string& there);

void print_comparison(const std::vector<ComparedFigure>& figures);

}  // namespace edgecase
