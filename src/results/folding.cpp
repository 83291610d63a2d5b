// SPDX-License-Identifier: MIT
#include "results/folding.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <tuple>

#include "results/base64.h"
#include "results/deflate.h"
#include "results/findings_json.h"
#include "results/shallow_json.h"
#include "results/whole_number.h"

namespace edgecase {
namespace {

using Place = ValueAggregate::Place;

constexpr std::string_view kMark = "zlib:";
constexpr int kLongestRun = 4096;                           // columns of the largest target
constexpr std::size_t kMostOfAList = std::size_t{1} << 24;  // places: its pixels

auto in_reading_order(const Place& p) {
  return std::tie(p.y, p.x, p.primitive);
}
auto by_primitive(const Place& p) {
  return std::tie(p.primitive, p.y, p.x);
}

// Sorted, none twice?
bool is_set(const std::vector<Place>& places) {
  return std::adjacent_find(places.begin(), places.end(), [](const Place& a, const Place& b) {
           return in_reading_order(a) >= in_reading_order(b);
         }) == places.end();
}

// How many neighbours in a row of one primitive stand from `at` on.
std::size_t length_of_run(const std::vector<Place>& places, std::size_t at) {
  const Place& first = places[at];
  int count = 1;
  const auto continues = [&](const Place& p) {
    return p.primitive == first.primitive && p.y == first.y && p.x == first.x + count;
  };
  while (++at < places.size() && continues(places[at])) ++count;
  return static_cast<std::size_t>(count);
}

void write_runs(JsonWriter& json, std::vector<Place> places) {
  std::sort(places.begin(), places.end(),
            [](const Place& a, const Place& b) { return by_primitive(a) < by_primitive(b); });
  json.list([&] {
    for (std::size_t i = 0; i < places.size();) {
      const std::size_t count = length_of_run(places, i);
      json.array(places[i].x, places[i].y, places[i].primitive, count);
      i += count;
    }
  });
}

}  // namespace

void fold(std::string& text, std::size_t first) {
  const std::string_view json = std::string_view(text).substr(first);
  if (json.size() <= kLongest) return;
  const std::string folded = to_base64(deflated(json));
  text.erase(first);
  text.append(1, '"').append(kMark).append(folded).append(1, '"');
}

nlohmann::json unfolded(const nlohmann::json& json) {
  if (!json.is_string()) return json;
  const std::string& text = json.get_ref<const std::string&>();
  if (!text.starts_with(kMark)) return json;
  return parse_shallow(inflated(from_base64(std::string_view(text).substr(kMark.size()))));
}

void write_places(JsonWriter& json, const std::vector<Place>& places) {
  if (places.size() > kMostPlaces && is_set(places)) return write_runs(json, places);
  json.list(places, write_place);
}

std::vector<Place> to_places(const nlohmann::json& json) {
  if (!json.is_array()) throw std::runtime_error("a list is missing");
  std::vector<Place> places;
  bool has_runs = false;
  for (const nlohmann::json& item : json) {
    Place place{WholeNumber(item.at(0)), WholeNumber(item.at(1)), WholeNumber(item.at(2))};
    has_runs = has_runs || item.size() > 3;
    const int count = item.size() > 3 ? WholeNumber(item.at(3)) : 1;
    if (count < 1 || count > kLongestRun || place.x > kLongestRun ||
        places.size() + static_cast<std::size_t>(count) > kMostOfAList)
      throw std::runtime_error(
          fmt::format("[{}, {}, {}, {}] stands for more places than there can be", place.x, place.y,
                      place.primitive, count));
    for (int i = 0; i < count; ++i, ++place.x) places.push_back(place);
  }
  if (has_runs)
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
      return in_reading_order(a) < in_reading_order(b);
    });
  return places;
}

}  // namespace edgecase
