// SPDX-License-Identifier: MIT
#include "diff/cause.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string_view>

#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/point_ownership.h"

namespace edgecase {
namespace {

// Does one fragment lack inside the run of those that were drawn, and nothing else differ?
bool is_interior_gap(const ScenePrimitive& line, const PrimitiveCoverage& coverage) {
  if (line.state->line_width != Fixed::from_integer(1)) return false;
  const auto differing = differences(coverage);
  if (differing.size() != 1 || differing[0].drawn != 0) return false;
  const Segment segment{line.vertices[0]->position, line.vertices[1]->position};
  const auto along = [&](PixelPosition p) { return segment.x_major() ? p.x : p.y; };
  const int gap = along(differing[0].pixel);
  const auto drawn_where = [&](auto where) {
    return std::any_of(coverage.drawn.begin(), coverage.drawn.end(),
                       [&](PixelPosition p) { return where(along(p)); });
  };
  return drawn_where([&](int at) { return at < gap; }) &&
         drawn_where([&](int at) { return at > gap; });
}

// One alternative of a rule, as a change of a choice.
struct Change {
  std::string cause;  // "rule=alternative"
  std::function<void(CoverageChoice&)> apply;

  CoverageChoice applied_to(CoverageChoice choice) const {
    apply(choice);
    return choice;
  }
};

// The alternatives of one rule, but for the one that is chosen.
using RuleAlternatives = std::vector<Change>;

RuleAlternatives snaps_beside(PrimitiveKind kind, Snap chosen) {
  RuleAlternatives result;
  for (Snap snap : all_snaps())
    if (snap != chosen)
      result.push_back({fmt::format("{}={}", snap_rule_of(kind), name_of(snap)),
                        [snap](CoverageChoice& choice) { choice.snap = snap; }});
  return result;
}

RuleAlternatives ties_beside(PrimitiveKind kind, const TieRule& chosen) {
  RuleAlternatives result;
  const auto rules = kind == PrimitiveKind::point ? point_tie_rules() : all_tie_rules();
  for (const TieRule& ties : rules)
    if (std::string_view(ties.name) != chosen.name)
      result.push_back({fmt::format("{}={}", coverage_rule_of(kind), ties.name),
                        [&ties](CoverageChoice& choice) { choice.ties = ties; }});
  return result;
}

RuleAlternatives algorithms_beside(LineAlgorithm chosen) {
  RuleAlternatives result;
  for (LineAlgorithm algorithm : all_line_algorithms())
    if (algorithm != chosen)
      result.push_back(
          {fmt::format("line.algorithm={}", name_of(algorithm)),
           [algorithm](CoverageChoice& choice) { choice.line.algorithm = algorithm; }});
  return result;
}

RuleAlternatives boundaries_beside(const DiamondBoundary& chosen) {
  RuleAlternatives result;
  for (const DiamondBoundary& boundary : all_diamond_boundaries())
    if (boundary.name != chosen.name)
      result.push_back({fmt::format("line.diamond-exit={}", boundary.name),
                        [&boundary](CoverageChoice& choice) { choice.line.boundary = &boundary; }});
  return result;
}

RuleAlternatives wide_lines_beside(WideLine chosen) {
  RuleAlternatives result;
  for (WideLine wide : {WideLine::replicate, WideLine::rectangle, WideLine::parallelogram})
    if (wide != chosen)
      result.push_back({fmt::format("line.width={}", name_of(wide)),
                        [wide](CoverageChoice& choice) { choice.line.wide = wide; }});
  return result;
}

RuleAlternatives row_orders_beside(RowOrder chosen) {
  RuleAlternatives result;
  for (RowOrder rows : {RowOrder::bottom_up, RowOrder::top_down})
    if (rows != chosen)
      result.push_back({fmt::format("line.row-order={}", name_of(rows)),
                        [rows](CoverageChoice& choice) { choice.line.rows = rows; }});
  return result;
}

// The alternatives of every rule that has a say in the primitive's coverage.
std::vector<RuleAlternatives> alternatives_beside(const ScenePrimitive& primitive,
                                                  const CoverageChoice& chosen) {
  if (primitive.kind != PrimitiveKind::line)
    return {ties_beside(primitive.kind, chosen.ties), snaps_beside(primitive.kind, chosen.snap)};
  std::vector<RuleAlternatives> rules = {
      algorithms_beside(chosen.line.algorithm), boundaries_beside(*chosen.line.boundary),
      snaps_beside(primitive.kind, chosen.snap), row_orders_beside(chosen.line.rows)};
  if (primitive.state->line_width != Fixed::from_integer(1))
    rules.push_back(wide_lines_beside(chosen.line.wide));
  return rules;
}

}  // namespace

std::vector<std::string> find_causes(const ScenePrimitive& primitive, const Target& target,
                                     const CoverageChoice& chosen,
                                     const PrimitiveCoverage& coverage) {
  const auto reproduces = [&](const CoverageChoice& choice) {
    return covered_pixels(primitive, target, choice) == coverage.drawn;
  };
  const std::vector<RuleAlternatives> rules = alternatives_beside(primitive, chosen);
  std::vector<std::string> causes;
  for (const RuleAlternatives& rule : rules)
    for (const Change& change : rule)
      if (reproduces(change.applied_to(chosen))) causes.push_back(change.cause);
  if (!causes.empty()) return causes;

  for (std::size_t i = 0; i < rules.size(); ++i)
    for (std::size_t j = i + 1; j < rules.size(); ++j)
      for (const Change& first : rules[i])
        for (const Change& second : rules[j])
          if (reproduces(second.applied_to(first.applied_to(chosen))))
            causes.push_back(first.cause + " + " + second.cause);
  if (causes.empty() && primitive.kind == PrimitiveKind::line &&
      is_interior_gap(primitive, coverage))
    causes.push_back(kInteriorGap);
  return causes;
}

std::span<const std::string> alternative_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const char* id :
         {"point.ownership", "point.snap", "line.algorithm", "line.diamond-exit", "line.width",
          "line.row-order", "line.snap", "triangle.fill-rule", "triangle.snap"})
      for (const Alternative& alternative : find_rule(id)->alternatives)
        list.push_back(fmt::format("{}={}", id, alternative.name));
    return list;
  }();
  return names;
}

void mark_refuted(const ScenePrimitive& primitive, const Target& target,
                  const CoverageChoice& chosen, const PrimitiveCoverage& coverage,
                  std::string& refuted) {
  static const auto places = [] {
    std::map<std::string, std::size_t> map;
    for (const std::string& name : alternative_names()) map.emplace(name, map.size());
    return map;
  }();
  for (const RuleAlternatives& rule : alternatives_beside(primitive, chosen))
    for (const Change& change : rule) {
      char& mark = refuted[places.at(change.cause)];
      if (mark == '1') continue;
      if (covered_pixels(primitive, target, change.applied_to(chosen)) != coverage.drawn)
        mark = '1';
    }
}

std::vector<std::string> parts_of(const std::string& cause) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at < cause.size();) {
    const std::size_t end = std::min(cause.find(" + ", at), cause.size());
    parts.push_back(cause.substr(at, end - at));
    at = end + 3;
  }
  return parts;
}

bool is_open_choice(const std::string& cause) {
  for (const std::string& part : parts_of(cause)) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos) return false;
    const Rule* rule = find_rule(part.substr(0, equals));
    const Alternative* alternative =
        rule != nullptr ? find_alternative(*rule, part.substr(equals + 1)) : nullptr;
    if (alternative == nullptr || alternative->openness == Openness::illegal) return false;
  }
  return !cause.empty();
}

}  // namespace edgecase
