// SPDX-License-Identifier: MIT
#include "tests/fuzz/spoils.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace edgecase {
namespace {

using nlohmann::json;

const std::vector<json>& extreme_numbers() {
  static const std::vector<json> numbers = {
      0,      1,     -1,     2,      3,    15,         16,         255,
      256,    65535, 0.5,    0.25,   0.75, -0.0,       1e-46,      -1e-46,
      1e-38,  1e300, -1e300, 3.4e38, 1.5,  254.5,      "nan",      "inf",
      "-inf", 1e20,  0.9999, -2e9,   2e9,  2147483647, 4294967295, -2147483648LL};
  return numbers;
}

constexpr const char* kTexts[] = {"",
                                  "0",
                                  "nan",
                                  "OpenGL ES",
                                  "1 to 64 by 0.125",
                                  "1 to 1e300 by 1e-300",
                                  "-1 to 1 by 0",
                                  "0 to 0 by 1",
                                  "1 to 9 by nan",
                                  "64 to 1 by 1000",
                                  "1e9999",
                                  "-5",
                                  "16",
                                  "inf",
                                  "0x1p1023"};

// A number next to it, or one that has a bit changed.
json neighbour_of(const json& value, ByteChoices& choices) {
  const bool up = choices.flag();
  if (value.is_number_integer()) return value.get<std::int64_t>() + (up ? 1 : -1);
  if (value.is_number_float()) {
    const double number = value.get<double>();
    constexpr double kSteps[] = {0x1p-52, 0x1p-24, 0x1p-16, 0x1p-8, 0.25, 1};
    const double step = choices.one_of(kSteps) * (number == 0 ? 1 : number);
    return up ? number + step : number - step;
  }
  return value;
}

void change_leaf(json& leaf, ByteChoices& choices) {
  if (leaf.is_string() && choices.flag())
    leaf = choices.one_of(kTexts);
  else if (choices.flag())
    leaf = choices.one_of(extreme_numbers());
  else
    leaf = neighbour_of(leaf, choices);
}

// All elements become the same: a blank picture, or fragments in one place.
void fill(json& list, ByteChoices& choices) {
  const json element = choices.flag() ? json(choices.one_of(extreme_numbers()))
                                      : json(list[choices.below(list.size())]);
  for (json& one : list) one = element;
}

// Each fragment has the member of another one, or an extreme value there.
void change_members(json& list, ByteChoices& choices) {
  const json& model = list[choices.below(list.size())];
  if (!model.is_object() || model.empty()) return;
  const std::string key =
      std::next(model.begin(), static_cast<std::ptrdiff_t>(choices.below(model.size()))).key();
  const bool removes = choices.flag();
  const json value = choices.flag() ? model[key] : json(choices.one_of(extreme_numbers()));
  for (json& one : list) {
    if (!one.is_object()) continue;
    if (removes)
      one.erase(key);
    else
      one[key] = value;
  }
}

void change_list(json& list, ByteChoices& choices) {
  if (list.empty()) return;
  const std::size_t at = choices.below(list.size());
  const std::size_t other = choices.below(list.size());
  const auto place = [&](std::size_t index) {
    return list.begin() + static_cast<std::ptrdiff_t>(index);
  };
  switch (choices.below(8)) {
    case 0:
      list.erase(place(at));
      break;
    case 1:
      list.insert(place(other), json(list[at]));
      break;
    case 2:
      std::swap(list[at], list[other]);
      break;
    case 3:
      list.clear();
      break;
    case 4:
      fill(list, choices);
      break;
    case 5:
      std::rotate(list.begin(), place(at), list.end());
      break;
    case 6:
      list[at] = json(list[other]);
      break;
    default:
      change_members(list, choices);
  }
}

}  // namespace

void tell_less(json& answer, ByteChoices& choices) {
  const std::uint8_t silent = choices.byte();
  const auto omit = [](json& from, int told, std::initializer_list<const char*> keys) {
    for (const char* key : keys)
      if (told != 0) from.erase(key);
  };
  const auto of_fragments = [&](json& drawing) {
    if (!drawing.contains("fragments")) return;
    for (json& fragment : drawing["fragments"]) {
      omit(fragment, silent & 1, {"color"});
      omit(fragment, silent & 2, {"depth"});
      omit(fragment, silent & 4,
           {"coordinates", "derivatives", "texture_coordinates", "level_of_detail"});
    }
  };
  of_fragments(answer);
  omit(answer, silent & 8, {"hits"});
  omit(answer, silent & 16, {"sample_positions"});
  omit(answer, silent & 32, {"sample_pixels"});
  omit(answer, silent & 64, {"mip_chains"});
  if (answer.contains("passes"))
    for (json& pass : answer["passes"]) of_fragments(pass);
}

void spoil(json& answer, ByteChoices& choices) {
  json* at = &answer;
  // Down to a leaf, or to a list on the way.
  while (at->is_structured() && !at->empty()) {
    const bool is_list = at->is_array();
    if (is_list && choices.below(3) == 0) return change_list(*at, choices);
    const std::size_t next = choices.below(at->size());
    if (is_list) {
      at = &(*at)[next];
      continue;
    }
    const auto member = std::next(at->begin(), static_cast<std::ptrdiff_t>(next));
    if (choices.below(16) == 15) {
      at->erase(member);
      return;
    }
    at = &member.value();
  }
  if (!at->is_structured()) change_leaf(*at, choices);
}

}  // namespace edgecase
