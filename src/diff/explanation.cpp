// SPDX-License-Identifier: MIT
#include "diff/explanation.h"

#include <fmt/format.h>

#include "exact/numeral.h"
#include "rules/all_rules.h"
#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {
namespace {

// Lines of width 1 by the diamond-exit rule are explained by its numbers, others by the algorithm.
Explanation explain_line_choice(const ScenePrimitive& line, const Segment& segment, PixelPosition p,
                                const CoverageChoice& choice) {
  Explanation why = explain_line(segment, p.x, p.y, *choice.line.boundary);
  const bool thin = line.state->line_width == Fixed::from_integer(1);
  if (thin && choice.line.algorithm == LineAlgorithm::diamond_exit) return why;
  const Rule& rule = *find_rule(thin ? "line.algorithm" : "line.width");
  const char* name = thin ? name_of(choice.line.algorithm) : name_of(choice.line.wide);
  why.text =
      fmt::format("the segment {} to {} of width {} is drawn as {} says ({})",
                  format_point(segment.a), format_point(segment.b),
                  to_decimal(line.state->line_width), name, find_alternative(rule, name)->meaning);
  return why;
}

// What the rule's own explanation does not know: an algorithm other than edge functions, an offset,
// a target that is seen upside down.
std::string notes_on(const ScenePrimitive& primitive, const CoverageChoice& choice) {
  std::string notes;
  const auto add = [&](const char* rule, const char* name) {
    notes +=
        fmt::format("; as {} has it: {}", name, find_alternative(*find_rule(rule), name)->meaning);
  };
  if (primitive.kind == PrimitiveKind::triangle &&
      choice.triangle_algorithm != TriangleAlgorithm::edge_functions)
    add("triangle.algorithm", name_of(choice.triangle_algorithm));
  if (primitive.kind == PrimitiveKind::point && choice.point_offset != PointOffset::none)
    add("point.offset", name_of(choice.point_offset));
  if (choice.rows != RowOrder::bottom_up)
    add(row_order_rule_of(primitive.kind), name_of(choice.rows));
  return notes;
}

// By the rule that decides, with the vertices where the choice has them.
Explanation explain_by_rule(const ScenePrimitive& primitive, PixelPosition p,
                            const CoverageChoice& choice) {
  const auto at = [&](std::size_t i) { return choice.snap(primitive.vertices[i]->position); };
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return explain_point({at(0), primitive.state->point_size}, p.x, p.y, choice.ties);
    case PrimitiveKind::line:
      return explain_line_choice(primitive, {at(0), at(1)}, p, choice);
    case PrimitiveKind::triangle:
      return explain_triangle({at(0), at(1), at(2)}, p.x, p.y, choice.ties);
  }
  return {};
}

}  // namespace

Explanation explain(const ScenePrimitive& primitive, PixelPosition pixel,
                    const CoverageChoice& choice) {
  Explanation why = explain_by_rule(primitive, pixel, choice);
  why.text += notes_on(primitive, choice);
  return why;
}

}  // namespace edgecase
