// SPDX-License-Identifier: MIT
#include "diff/cause.h"

#include <fmt/format.h>

#include <algorithm>

#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/coverage/diamond_exit.h"

namespace edgecase {
namespace {

// Does one fragment lack inside the run of those that were drawn, and nothing else differ?
bool is_interior_gap(const ScenePrimitive& line, const PrimitiveCoverage& coverage) {
  const auto differing = differences(coverage);
  if (differing.size() != 1 || differing[0].drawn != 0) return false;
  const Segment segment{line.vertices[0].position, line.vertices[1].position};
  const auto along = [&](PixelPosition p) { return segment.x_major() ? p.x : p.y; };
  const int gap = along(differing[0].pixel);
  const auto drawn_where = [&](auto where) {
    return std::any_of(coverage.drawn.begin(), coverage.drawn.end(),
                       [&](PixelPosition p) { return where(along(p)); });
  };
  return drawn_where([&](int at) { return at < gap; }) &&
         drawn_where([&](int at) { return at > gap; });
}

}  // namespace

std::vector<std::string> find_causes(const ScenePrimitive& primitive, const Target& target,
                                     const CoverageChoice& chosen,
                                     const PrimitiveCoverage& coverage) {
  const auto reproduces = [&](Snap snap, const TieRule& ties) {
    return covered_pixels(primitive, target, {snap, ties}) == coverage.drawn;
  };
  const auto tie_cause = [&](const TieRule& ties) {
    return fmt::format("{}={}", coverage_rule_of(primitive.state->primitive), ties.name);
  };
  const auto snap_cause = [&](Snap snap) {
    return fmt::format("{}={}", snap_rule_of(primitive.state->primitive), name_of(snap));
  };
  const std::string_view own_ties = chosen.ties.name;

  std::vector<std::string> causes;
  for (const TieRule& ties : all_tie_rules())
    if (ties.name != own_ties && reproduces(chosen.snap, ties)) causes.push_back(tie_cause(ties));
  for (Snap snap : all_snaps())
    if (snap != chosen.snap && reproduces(snap, chosen.ties)) causes.push_back(snap_cause(snap));
  if (!causes.empty()) return causes;

  for (const TieRule& ties : all_tie_rules())
    for (Snap snap : all_snaps())
      if (ties.name != own_ties && snap != chosen.snap && reproduces(snap, ties))
        causes.push_back(tie_cause(ties) + " + " + snap_cause(snap));
  if (causes.empty() && primitive.state->primitive == Primitive::lines &&
      is_interior_gap(primitive, coverage))
    causes.push_back(kInteriorGap);
  return causes;
}

bool is_open_choice(const std::string& cause) {
  for (std::size_t at = 0; at < cause.size();) {
    const std::size_t end = std::min(cause.find(" + ", at), cause.size());
    const std::string part = cause.substr(at, end - at);
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos) return false;
    const Rule* rule = find_rule(part.substr(0, equals));
    const Alternative* alternative =
        rule != nullptr ? find_alternative(*rule, part.substr(equals + 1)) : nullptr;
    if (alternative == nullptr || alternative->openness == Openness::illegal) return false;
    at = end + 3;
  }
  return !cause.empty();
}

}  // namespace edgecase
