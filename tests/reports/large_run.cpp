// SPDX-License-Identifier: MIT
#include "tests/reports/large_run.h"

#include <fmt/format.h>

#include "tests/reports/sample.h"

namespace edgecase::sample {

Results large_run(std::size_t cases, int disagreements) {
  const std::string sentence =
      "line 0: the segment (3.875, 3.875) to (4.125, 4.125) comes within 0.75 < 1 & \"less\" of "
      "the "
      "centre (3.5, 3.5) (not less than 0.5, so it misses the diamond); its end (4.125, 4.125) "
      "lies "
      "outside the diamond; exact does not draw the pixel, the renderer draws it. Ruling 2, for "
      "the "
      "segment as given.";
  Results results;
  results.tool = "edgecase 0.1.0";
  results.policy = "opengl";
  results.renderers.resize(1);
  results.renderers[0].name = "osmesa:softpipe";
  for (std::size_t i = 0; i < cases; ++i) {
    CaseResults one;
    one.id = fmt::format("lines/directions/all-round-the-clock:angle={}:length=12.5", i);
    one.title = "A line in each of so many directions, of one length";
    one.file = "cases/lines/directions/all-round-the-clock.json";
    one.rules = {"line.diamond-exit"};
    one.results.resize(1);
    Result& result = one.results[0];
    result.verdict = Verdict::violation;
    result.standing = Standing::unexpected;
    result.fingerprint = "0123456789abcdef";
    result.standing_reason = "no known fault accounts for this";
    for (int x = 0; x < disagreements; ++x) {
      result.disagreements.push_back(disagreement(x, 0, DisagreementKind::extra, false));
      result.disagreements.back().explanation = sentence;
    }
    results.cases.push_back(std::move(one));
  }
  return results;
}

}  // namespace edgecase::sample
