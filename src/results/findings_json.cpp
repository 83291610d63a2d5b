// SPDX-License-Identifier: MIT
#include "results/findings_json.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "results/packed_text.h"
#include "results/shallow_json.h"
#include "rules/all_rules.h"
#include "rules/rule.h"

namespace edgecase {
namespace {

using Position = std::pair<double, double>;

// True if the value is a whole number of 65536ths that reads back as the same double.
bool is_fixed(double value) {
  constexpr double kMost = 9007199254740992.0;  // 2^53
  const double raw = value * Fixed::kOne;
  return std::abs(raw) < kMost && raw == std::floor(raw) && !(value == 0 && std::signbit(value));
}

void write_coordinate(JsonWriter& json, double value) {
  if (is_fixed(value)) return json.value(static_cast<std::int64_t>(value * Fixed::kOne));
  json.value(value);
}

double to_coordinate(const ReadJson& json) {
  if (json.is_number_integer())
    return static_cast<double>(json.get<std::int64_t>()) / static_cast<double>(Fixed::kOne);
  return to_number(json);
}

// Numbers points in the order of their first use; points with different bits are different.
class Points {
 public:
  std::size_t number(const Position& at) {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    const auto [found, is_new] =
        numbers_.try_emplace({bits(at.first), bits(at.second)}, list_.size());
    if (is_new) list_.push_back(at);
    return found->second;
  }
  const std::vector<Position>& list() const { return list_; }

 private:
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::size_t> numbers_;
  std::vector<Position> list_;
};

bool is_usually_closed(const Mark& mark) {
  return mark.role == MarkRole::primitive && mark.points.size() == 3;
}

// `primitives`: marks of that role before it.
std::string usual_label(const Mark& mark, std::size_t primitives) {
  if (mark.role == MarkRole::primitive) return std::to_string(primitives);
  if (mark.role != MarkRole::vertex || mark.points.size() != 1) return "";
  constexpr double kFar = 1 << 20;  // pixels: beyond any target, and before any overflow
  const auto& [x, y] = mark.points.front();
  if (!is_fixed(x) || !is_fixed(y) || std::abs(x) > kFar || std::abs(y) > kFar) return "";
  const auto fixed = [](double value) {
    return Fixed::from_raw(static_cast<std::int64_t>(value * Fixed::kOne));
  };
  return format_point({fixed(x), fixed(y)});
}

Mark to_mark(const ReadJson& json, const std::vector<Position>& points, std::size_t primitives) {
  Mark mark;
  mark.role = to_named<MarkRole>(json.at(0));
  mark.points.reserve(json.at(1).size());
  for (const ReadJson& index : json.at(1)) {
    const std::size_t at = WholeNumber(index);
    if (at >= points.size()) throw std::runtime_error(fmt::format("there is no point {}", at));
    mark.points.push_back(points[at]);
  }
  mark.closed = is_usually_closed(mark);
  std::size_t next = 2;
  if (json.size() > next && json.at(next).is_boolean()) mark.closed = json.at(next++);
  mark.label =
      json.size() > next ? json.at(next).get<std::string>() : usual_label(mark, primitives);
  return mark;
}

}  // namespace

void write_figure(JsonWriter& json, const Figure& figure) {
  Points points;
  json.object([&] {
    for (const Mark& mark : figure.marks)
      for (const Position& at : mark.points) points.number(at);
    json.key("points").list([&] {
      for (const auto& [x, y] : points.list()) {
        write_coordinate(json, x);
        write_coordinate(json, y);
      }
    });
    std::size_t primitives = 0;
    json.key("marks").list(figure.marks, [&](JsonWriter& list, const Mark& mark) {
      list.list([&] {
        list.value(name_of(mark.role));
        list.list(mark.points, [&](JsonWriter& indices, const Position& at) {
          indices.value(points.number(at));
        });
        if (mark.closed != is_usually_closed(mark)) list.value(mark.closed);
        if (mark.label != usual_label(mark, primitives)) list.value(mark.label);
      });
      if (mark.role == MarkRole::primitive) ++primitives;
    });
  });
}

Figure to_figure(const ReadJson& json) {
  std::vector<Position> points;
  const ReadJson& list = json.at("points");
  for (std::size_t i = 0; i < list.size(); i += 2)
    points.emplace_back(to_coordinate(list.at(i)), to_coordinate(list.at(i + 1)));
  Figure figure;
  figure.marks.reserve(json.at("marks").size());
  std::size_t primitives = 0;
  for (const ReadJson& item : json.at("marks")) {
    figure.marks.push_back(to_mark(item, points, primitives));
    if (figure.marks.back().role == MarkRole::primitive) ++primitives;
  }
  return figure;
}

double to_number(const ReadJson& json) {
  if (json.is_number()) return json.get<double>();
  const std::string text = json.get<std::string>();
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (text == "inf") return std::numeric_limits<double>::infinity();
  if (text == "-inf") return -std::numeric_limits<double>::infinity();
  throw std::runtime_error(fmt::format("\"{}\" is no number", text));
}

namespace {

void write_upright(JsonWriter& json, const Disagreement::Upright& upright) {
  json.object([&] {
    json.member("rule", name_of(upright.rule));
    json.member("ruling", upright.ruling);
    json.member("legality", name_of(upright.legality));
    json.member("cause", text_of(upright.cause));
  });
}

void write_place(JsonWriter& json, const DisagreementClass& d) {
  if (d.sample != 0) json.member("sample", d.sample);
  if (d.primitive != -1) json.member("primitive", d.primitive);
  json.member("kind", name_of(d.kind));
  json.member("rule", name_of(d.rule));
  json.member("legality", name_of(d.legality));
  if (!d.cause.empty()) json.member("cause", text_of(d.cause));
}

void write_judgement(JsonWriter& json, const DisagreementClass& d) {
  if (d.policy_agrees) json.member("policy_agrees", true);
  if (d.ruling != 0) json.member("ruling", d.ruling);
  if (d.upright) write_upright(json.key("upright"), *d.upright);
}

}  // namespace

// Members with default values are left out, because a file holds very many of these.
void write_disagreement(JsonWriter& json, const Disagreement& d) {
  json.object([&] {
    json.key("pixel").array(d.x, d.y);
    write_place(json, d);
    if (!d.situation.empty()) json.member("situation", d.situation);
    write_judgement(json, d);
    if (!d.exact.empty()) json.member("exact", d.exact);
    if (!d.rendered.empty()) json.member("rendered", d.rendered);
    if (!d.explanation.empty()) json.member("explanation", d.explanation);
    if (!d.figure.marks.empty()) write_figure(json.key("figure"), d.figure);
  });
}

void write_counted(JsonWriter& json, const CountedDisagreements& counted) {
  json.object([&] {
    json.member("count", counted.count());
    write_place(json, counted);
    write_judgement(json, counted);
    json.member("pixels", packed_runs(counted.runs));
  });
}

void write_evidence(JsonWriter& json, const Result::Evidence& evidence) {
  json.object([&] {
    json.member("primitive", evidence.primitive);
    if (!evidence.causes.empty())
      json.key("causes").list(evidence.causes, [](JsonWriter& list, const Cause& cause) {
        list.value(text_of(cause));
      });
    if (evidence.pass >= 0) json.member("pass", evidence.pass);
    if (!evidence.illegal_line_snaps.empty())
      json.member("illegal_line_snaps", evidence.illegal_line_snaps);
    if (!evidence.broken_clause.empty()) json.member("broken_clause", evidence.broken_clause);
  });
}

void write_level(JsonWriter& json, const Result::LevelPoint& p) {
  json.array(p.x, p.y, p.exact, p.low, p.high, p.rendered);
}

void write_values(JsonWriter& json, const ValueAggregate& values) {
  json.object([&] {
    json.member("attribute", values.attribute);
    json.member("rule", name_of(values.rule));
    if (values.ruling != 0) json.member("ruling", values.ruling);
    if (!values.cause.empty()) json.member("cause", text_of(values.cause));
    json.member("compared", values.compared);
    json.member("components", values.components);
    json.key("worst").array(values.worst.x, values.worst.y, values.worst.primitive);
    json.member("worst_component", values.worst_component);
    json.member("worst_exact", values.worst_exact);
    json.member("worst_rendered", values.worst_rendered);
    if (!std::isnan(values.worst_low))
      json.key("worst_permitted").array(values.worst_low, values.worst_high);
    json.member("worst_ulp", values.worst_ulp);
    json.member("mean_ulp", values.mean_ulp);
    json.member("worst_relative", values.worst_relative);
    json.key("ulp_histogram").object([&] {
      for (const auto& [bucket, count] : values.ulp_histogram)
        json.member(std::to_string(bucket), count);
    });
    json.member("differing", packed_places(values.differing));
  });
}

}  // namespace edgecase
