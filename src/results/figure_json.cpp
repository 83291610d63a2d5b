// SPDX-License-Identifier: MIT
#include "results/figure_json.h"

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

#include "results/whole_number.h"
#include "rules/rule.h"

namespace edgecase {
namespace {

using Position = std::pair<double, double>;

// The number of 65536ths, where it is whole and is read back as the same.
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

// Numbers points in the order in which they come, told apart by their bits.
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

MarkRole to_role(const ReadJson& json) {
  const std::string text = json.get<std::string>();
  for (int i = 0; i <= static_cast<int>(MarkRole::edge); ++i)
    if (text == name_of(static_cast<MarkRole>(i))) return static_cast<MarkRole>(i);
  throw std::runtime_error(fmt::format("\"{}\" is not known here", text));
}

Mark to_mark(const ReadJson& json, const std::vector<Position>& points, std::size_t primitives) {
  Mark mark;
  mark.role = to_role(json.at(0));
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

}  // namespace edgecase
