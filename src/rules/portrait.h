// SPDX-License-Identifier: MIT
//
// Portrait: what all answers of a renderer together say of it.
//
// Each answer that breaks a rule, or that nothing explains, says which hypotheses about its
// renderer explain it (rules/hypotheses.h). The run tells the one that explains the most. A
// portrait is a sum over outlines, so the order of answers does not matter, and those of shards add
// up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/result.h"

namespace edgecase {

struct Portrait {
  struct Finding {
    std::uint16_t hypothesis = 0;
    std::size_t answers = 0;  // that it explains
    std::size_t asked = 0;    // all that cover something else, or that show other colours
  };
  std::optional<Finding> coverage;
  std::optional<Finding> colors;

  // What the renderer does where it explains the answer: "samples pixels at their lower left
  // corner"; else empty.
  std::string cause_of(const ResultOutline& answer) const;
};

class PortraitGatherer {
 public:
  // Of answers that are as expected, known or contested none is asked: what explains a driver's
  // known fault as well does so by chance.
  void add(const ResultOutline& answer);
  // Findings that explain at least five answers: nine in ten of those that were asked or, where a
  // quarter of all that ran were asked, a third of them; or, of one part, three or four answers
  // that are all. Of those that explain nearly as much as the best, the one of the fewest parts.
  // What the specification leaves open is no finding, and no hypothesis is needed where single
  // alternatives of the catalogue explain more.
  Portrait portrait() const;

 private:
  // By hypothesis or mark: how many more answers have it than have the number before.
  std::map<int, std::ptrdiff_t> steps_;
  std::size_t ran_ = 0;  // answers that are renderings
};

// "It samples pixels at their lower left corner: that explains 501 of the 642 answers that cover
// something else.", and the same of colours.
std::vector<std::string> sentences_of(const Portrait& portrait);

}  // namespace edgecase
