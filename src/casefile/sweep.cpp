// SPDX-License-Identifier: MIT
#include "casefile/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "casefile/numbers.h"
#include "casefile/text.h"
#include "exact/numeral.h"

namespace edgecase {
namespace {

constexpr std::size_t kCountLimit = std::size_t{1} << 32;

// A value on its way to a place of the tree.
struct Move {
  const AxisTarget* target = nullptr;
  const SweepAxis* axis = nullptr;
  const AxisValue* value = nullptr;
};

std::vector<Move> moves_of(const Sweep& sweep, const Combination& combination, bool adds) {
  std::vector<Move> moves;
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
    const SweepAxis& axis = sweep.axes[a];
    if (axis.adds != adds) continue;
    for (const AxisTarget& target : axis.targets)
      moves.push_back({&target, &axis, &axis.values[combination[a]]});
  }
  // What sets a whole vertex must not undo what sets one of its coordinates.
  std::stable_sort(moves.begin(), moves.end(), [](const Move& a, const Move& b) {
    return a.target->tokens.size() < b.target->tokens.size();
  });
  return moves;
}

void set_lines(JsonNode& node, int line) {
  for (JsonNode& child : node.children) {
    child.line = child.name_line = line;
    set_lines(child, line);
  }
}

// Replaces a value, and leaves its key and line.
void overwrite(JsonNode& node, const JsonNode& value) {
  node.kind = value.kind;
  node.text = value.text;
  node.truth = value.truth;
  node.children = value.children;
  set_lines(node, node.line);
}

void refuse_missing(const Move& move, const char* remedy, Findings& findings) {
  findings.add(move.target->place,
               fmt::format("{} leads to nothing", quote(move.target->place.node->text)), remedy);
}

void set(const Move& move, JsonNode& root, Findings& findings) {
  JsonNode* node = find_at(root, move.target->tokens, Missing::is_created);
  if (node == nullptr) {
    refuse_missing(move, "name a place that the file has; only optional keys may be missing",
                   findings);
    return;
  }
  // A position leaves the vertex its colour.
  if (move.axis->points && node->kind == JsonKind::object &&
      move.value->node.kind == JsonKind::array) {
    if (JsonNode* position = find_position(*node)) {
      position->name = "at";
      node = position;
    }
  }
  overwrite(*node, move.value->node);
}

void add(const Move& move, JsonNode& root, Findings& findings) {
  JsonNode* node = find_at(root, move.target->tokens, Missing::stays);
  if (node == nullptr) {
    refuse_missing(move, "write the number that is to be added to into the file", findings);
    return;
  }
  const Place place{node, move.target->place.node->text};
  constexpr FixedRange kRange{Fixed::from_integer(-kMaxSwept), Fixed::from_integer(kMaxSwept)};
  const auto number = read_coordinate(place, "a number that is added to", kRange, findings);
  if (!number) return;
  node->kind = JsonKind::number;
  node->text = to_decimal(*number + move.value->amount);
}

}  // namespace

std::size_t count_combinations(const Sweep& sweep) {
  std::size_t count = 1;
  for (const auto& group : sweep.groups)
    count = std::min(count * sweep.axes[group.front()].values.size(), kCountLimit);
  return count;
}

std::vector<Combination> all_combinations(const Sweep& sweep) {
  std::vector<Combination> result{Combination(sweep.axes.size())};
  for (const auto& group : sweep.groups) {
    std::vector<Combination> longer;
    for (const Combination& start : result) {
      for (std::size_t v = 0; v < sweep.axes[group.front()].values.size(); ++v) {
        longer.push_back(start);
        for (const std::size_t axis : group) longer.back()[axis] = v;
      }
    }
    result = std::move(longer);
  }
  return result;
}

Combination base_of(const Sweep& sweep) {
  Combination result(sweep.axes.size());
  for (const auto& group : sweep.groups) {
    std::size_t base = 0;
    for (const std::size_t axis : group) base = sweep.axes[axis].base.value_or(base);
    for (const std::size_t axis : group) result[axis] = base;
  }
  return result;
}

std::vector<std::string> parts_of(const Sweep& sweep, const Combination& combination) {
  std::vector<std::string> parts;
  for (std::size_t a = 0; a < sweep.axes.size(); ++a)
    parts.push_back(
        fmt::format("{}={}", sweep.axes[a].name, sweep.axes[a].values[combination[a]].name));
  return parts;
}

void substitute(const Sweep& sweep, const Combination& combination, JsonNode& root,
                Findings& findings) {
  for (const Move& move : moves_of(sweep, combination, false)) set(move, root, findings);
  for (const Move& move : moves_of(sweep, combination, true)) add(move, root, findings);
}

}  // namespace edgecase
