// SPDX-License-Identifier: MIT
//
// Every vertex moved by a fraction of a pixel, as a wrong viewport or a wrong rounding moves them.
// A renderer that reports 8 bits may move a vertex by less than 1/256 pixel, and no more.
#include <fmt/format.h>

#include "raster/rasterizer.h"
#include "tests/diff/coverage/fragment_changes.h"

namespace edgecase {
namespace {

// No vertex and no boundary lies where so small a move could tell.
const std::vector<std::string> kClear = {
    "line x-major", "line y-major",         "line 45 degrees",      "line short", "two lines",
    "line smooth",  "joined lines x-major", "joined lines y-major", "fan",        "sliver"};

constexpr const char* kFill = "triangle.fill-rule";
constexpr const char* kLine = "line.diamond-exit";
constexpr const char* kPoint = "point.ownership";

Mutant moved_by(int x, int y, int parts, Verdict verdict, std::vector<std::string> scenes,
                const char* rule, const char* cause = "") {
  Mutant mutant;
  mutant.name = fmt::format("moved by ({}/{}, {}/{})", x, parts, y, parts);
  mutant.scenes = std::move(scenes);
  mutant.mutate = [=](const Scene& scene, const Rendering&) {
    return rasterize(moved(scene, static_cast<double>(x) / parts, static_cast<double>(y) / parts),
                     {});
  };
  mutant.verdict = verdict;
  mutant.rule = rule;
  mutant.cause = cause;
  return mutant;
}

}  // namespace

std::vector<Mutant> moved_mutants() {
  constexpr auto kViolation = Verdict::violation;
  constexpr auto kPermitted = Verdict::permitted;
  constexpr auto kConvention = Verdict::convention;
  std::vector<Mutant> mutants = {
      moved_by(-1, 0, 256, kViolation, {"triangle a 256th off"}, kFill, "triangle.snap=7-truncate"),
      moved_by(0, 1, 256, kViolation, {"triangle a 256th off"}, kFill, "triangle.snap=7-half-up"),
      moved_by(-1, 1, 256, kViolation, {"triangle a 256th off"}, kFill,
               "triangle.snap=7-half-even"),
      moved_by(-1, 0, 256, kPermitted, {"triangle a 512th off"}, kFill, "triangle.snap=8-truncate"),
      moved_by(0, 1, 256, kPermitted, {"triangle a 512th off"}, kFill, "triangle.snap=8-half-up"),
      moved_by(1, 1, 256, kViolation, {"points a 256th off"}, kPoint, "point.snap=7-half-even"),
      moved_by(-1, -1, 256, kConvention, {"points on borders"}, kPoint,
               "point.ownership=left-bottom"),
      moved_by(1, -1, 256, kPermitted, {"triangles with ties"}, kFill,
               "triangle.fill-rule=bottom-right"),
      moved_by(1, 0, 256, kPermitted, {"triangle", "triangle smooth", "shared edge", "overdraw"},
               kFill, "triangle.fill-rule=right-bottom"),
      moved_by(1, 0, 256, kPermitted,
               {"strip x-major", "strip that turns back", "lines from one point"}, kLine,
               "line.diamond-exit=right-bottom"),
      moved_by(1, 0, 256, kPermitted, {"strip y-major", "strip leftward", "strip downward"}, kLine,
               "line.algorithm=walk-ends-tested"),
      moved_by(1, 1, 2, kViolation, {"triangle", "fan", "sliver"}, kFill),
  };
  // Coverage stays; depth shows that the vertices moved.
  for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}})
    mutants.push_back(moved_by(x, y, 256, kPermitted, kClear, "fragment.depth"));
  return mutants;
}

}  // namespace edgecase
