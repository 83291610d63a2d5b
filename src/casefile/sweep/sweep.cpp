// SPDX-License-Identifier: MIT
#include "casefile/sweep/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "casefile/json/numbers.h"
#include "casefile/json/text.h"
#include "exact/numeral.h"

namespace edgecase {

namespace {

const Keys kAxisKeys{{}, {"set", "add_to", "values", "range", "points", "base", "zip"}, {}};

// The only given key of `names`; nothing, and a finding, if there is not exactly one.
std::optional<std::string> only_one(const Place& place, const ObjectReader& object,
                                    std::span<const std::string> names, Findings& findings) {
  std::vector<std::string> given;
  for (const std::string& name : names)
    if (object.find(name)) given.push_back(name);
  if (given.size() == 1) return given.front();
  findings.add(place,
               given.empty() ? fmt::format("an axis has none of {}", join_names(names))
                             : fmt::format("an axis has all of {}", join_names(given)),
               "give exactly one of them");
  return std::nullopt;
}

void read_pointer(const Place& place, SweepAxis& axis, Findings& findings) {
  if (!expect_kind(place, JsonKind::string, "a pointer", findings)) return;
  const std::string& text = place.node->text;
  const std::optional<Tokens> tokens = split_pointer(text);
  if (!tokens || tokens->size() < 2 ||
      (tokens->front() != "target" && tokens->front() != "textures" && tokens->front() != "draws" &&
       tokens->front() != "transform")) {
    findings.add(
        place,
        fmt::format("{} is no pointer into the target, the textures, the draws or the transform",
                    quote(text)),
        "write one like \"/draws/0/vertices/0/x\" or \"/target/width\"");
    return;
  }
  const bool twice = std::any_of(axis.targets.begin(), axis.targets.end(),
                                 [&](const AxisTarget& other) { return other.tokens == *tokens; });
  if (twice)
    findings.add(place, fmt::format("{} stands twice in a list of pointers", quote(text)),
                 "keep one");
  axis.targets.push_back({*tokens, place});
}

void read_pointers(const Place& place, SweepAxis& axis, Findings& findings) {
  if (!expect_kind(place, JsonKind::array, "a list of pointers", findings)) return;
  if (place.node->children.empty())
    findings.add(place, "an axis has no pointers", "name what takes the values");
  for (std::size_t i = 0; i < place.node->children.size(); ++i)
    read_pointer(place.child(i), axis, findings);
}

void check_points(const SweepAxis& axis, const Place& points, Findings& findings) {
  if (axis.adds) findings.add(points, "points cannot be added", "use \"set\"");
  for (const AxisTarget& target : axis.targets)
    if (!axis.adds && !is_vertex_pointer(target.tokens))
      findings.add(target.place, fmt::format("{} is no vertex", quote(target.place.node->text)),
                   "points go to vertices, like \"/draws/0/vertices/0\"");
}

void read_values_of_axis(const ObjectReader& object, const std::string& kind, SweepAxis& axis,
                         Findings& findings) {
  const std::optional<Place> place = object.find(kind);
  if (!place) return;
  if (kind == "values") axis.values = read_values(*place, axis.adds, findings);
  if (kind == "range") axis.values = read_range(*place, findings);
  if (kind == "points") {
    axis.points = true;
    axis.values = read_points(*place, findings);
    check_points(axis, *place, findings);
  }
}

void read_zip(const Place& place, SweepAxis& axis, Findings& findings) {
  const auto name = read_text(place, "zip", kNameLimits, findings);
  if (!name) return;
  axis.zip = *name;
  if (!is_axis_name(*name))
    findings.add(place, fmt::format("{} is no name of a group", quote(*name)),
                 "use a letter from a to z first, then a to z, 0 to 9 and dashes");
}

SweepAxis read_axis(const Place& place, Findings& findings) {
  static const std::string kActions[] = {"set", "add_to"};
  static const std::string kSources[] = {"values", "range", "points"};
  SweepAxis axis;
  axis.name = place.node->name;
  if (!is_axis_name(axis.name) || axis.name == "variant")
    findings.add_key(place, fmt::format("{} cannot name an axis", quote(axis.name)),
                     "use a letter from a to z first, then a to z, 0 to 9 and dashes; \"variant\" "
                     "is taken");
  const ObjectReader object(place, "an axis", kAxisKeys, findings);
  if (!object.valid()) return axis;
  if (const auto action = only_one(place, object, kActions, findings)) {
    axis.adds = *action == "add_to";
    read_pointers(*object.find(*action), axis, findings);
  }
  if (const auto source = only_one(place, object, kSources, findings))
    read_values_of_axis(object, *source, axis, findings);
  const auto base = object.find("base");
  if (base && !axis.values.empty()) axis.base = read_value_of(*base, axis, findings);
  if (const auto zip = object.find("zip")) read_zip(*zip, axis, findings);
  return axis;
}

// If two axes set one value, the first has no effect and would seem to be tested.
void check_overlaps(const Sweep& sweep, Findings& findings) {
  std::map<Tokens, const SweepAxis*> setters;
  for (const SweepAxis& axis : sweep.axes) {
    if (axis.adds) continue;
    for (const AxisTarget& target : axis.targets) {
      const auto [first, fresh] = setters.emplace(target.tokens, &axis);
      if (!fresh && first->second != &axis)
        findings.add(target.place,
                     fmt::format("{} is set by the axis {}, too", quote(target.place.node->text),
                                 quote(first->second->name)),
                     "let one axis set it, and another one add to it");
    }
  }
}

void check_group(const Place& place, const Sweep& sweep, const std::vector<std::size_t>& group,
                 Findings& findings) {
  const SweepAxis& first = sweep.axes[group.front()];
  if (group.size() == 1 && !first.zip.empty())
    findings.add(place.child(group.front()),
                 fmt::format("the group {} has one axis only", quote(first.zip)),
                 "give another axis the same \"zip\", or remove it");
  std::optional<std::size_t> base;
  for (const std::size_t a : group) {
    const SweepAxis& axis = sweep.axes[a];
    if (axis.values.size() != first.values.size())
      findings.add(
          place.child(a),
          fmt::format("{} has {} values, and {} of the same group {} has {}", quote(axis.name),
                      axis.values.size(), quote(first.name), quote(first.zip), first.values.size()),
          "give axes that run together equally many values");
    if (base && axis.base && *axis.base != *base)
      findings.add(place.child(a),
                   fmt::format("the base of {} is value {} of its group, and that of another axis "
                               "is value {}",
                               quote(axis.name), *axis.base + 1, *base + 1),
                   "choose bases that run together, or say one of them only");
    if (axis.base) base = axis.base;
  }
}

void make_groups(Sweep& sweep) {
  std::map<std::string, std::size_t> named;
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
    const std::string& zip = sweep.axes[a].zip;
    const auto known = zip.empty() ? named.end() : named.find(zip);
    if (known != named.end()) {
      sweep.groups[known->second].push_back(a);
      continue;
    }
    if (!zip.empty()) named[zip] = sweep.groups.size();
    sweep.groups.push_back({a});
  }
}

}  // namespace

bool is_axis_name(std::string_view name) {
  return !name.empty() && name[0] >= 'a' && name[0] <= 'z' &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
         });
}

Sweep read_sweep(const Place& place, Findings& findings) {
  Sweep sweep;
  const std::size_t before = findings.size();
  if (!expect_kind(place, JsonKind::object, "a sweep", findings)) return sweep;
  if (place.node->children.empty())
    findings.add(place, "a sweep has no axes", "add an axis, or remove the sweep");
  for (std::size_t i = 0; i < place.node->children.size(); ++i)
    sweep.axes.push_back(read_axis(place.child(i), findings));
  make_groups(sweep);
  check_overlaps(sweep, findings);
  // The number of values of a faulty axis is meaningless.
  if (findings.size() != before) return sweep;
  for (const auto& group : sweep.groups) check_group(place, sweep, group, findings);
  return sweep;
}

namespace {

constexpr std::size_t kCountLimit = std::size_t{1} << 32;

// A value and its destination in the tree.
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
  // Setting a whole vertex must not undo setting one of its coordinates.
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

// Replaces a value but keeps its key and line.
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
  // A vertex keeps its colour when its position is set.
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
