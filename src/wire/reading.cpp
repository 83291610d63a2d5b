// SPDX-License-Identifier: MIT
#include "wire/reading.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace edgecase::wire {

using nlohmann::json;

namespace {

[[noreturn]] void refuse_type(const json& value, const Path& path, const char* wanted) {
  throw Refusal(fmt::format("{} must be {}, but it is {}", path.text(), wanted,
                            value.is_structured() ? value.type_name() : excerpt(value.dump(), 40)));
}

}  // namespace

std::string Path::pointer() const {
  if (parent_ == nullptr) return "";
  return parent_->pointer() + "/" + (key_ != nullptr ? std::string(key_) : std::to_string(index_));
}

std::string Path::text() const {
  return parent_ == nullptr ? "the line" : pointer();
}

json parse_text(std::string_view line) {
  try {
    return json::parse(line);
  } catch (const json::exception& error) {
    // The library's message follows its tag in brackets.
    const std::string_view text = error.what();
    const std::size_t tag = text.find("] ");
    throw Refusal("this is no line of JSON: " +
                  excerpt(tag == text.npos ? text : text.substr(tag + 2), 200));
  }
}

void require_object(const json& value, const Path& path, std::initializer_list<const char*> known) {
  require_object(value, path, std::span(known.begin(), known.size()));
}

void require_object(const json& value, const Path& path, std::span<const char* const> known) {
  if (!value.is_object()) refuse_type(value, path, "an object");
  for (const auto& [key, ignored] : value.items()) {
    const auto is_key = [&key = key](const char* name) { return key == name; };
    if (std::any_of(known.begin(), known.end(), is_key)) continue;
    throw Refusal(fmt::format("{} has the unknown key \"{}\"; known are {}", path.text(),
                              excerpt(key, 40), fmt::join(known, ", ")));
  }
}

void require_array(const json& value, const Path& path, std::size_t size) {
  if (!value.is_array()) refuse_type(value, path, "an array");
  if (value.size() == size) return;
  throw Refusal(
      fmt::format("{} must have {} elements, but it has {}", path.text(), size, value.size()));
}

const json& member(const json& object, const Path& path, const char* key) {
  const json* found = optional_member(object, key);
  if (found == nullptr) throw Refusal(fmt::format("{} has no \"{}\"", path.text(), key));
  return *found;
}

const json* optional_member(const json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

std::int64_t read_integer(const json& value, const Path& path, std::int64_t low,
                          std::int64_t high) {
  if (!value.is_number_integer()) refuse_type(value, path, "an integer");
  // The library stores nonnegative numbers as unsigned: one beyond int64 is beyond `high`.
  const bool huge = value.is_number_unsigned() &&
                    value.get<std::uint64_t>() >
                        static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  const std::int64_t number = huge ? 0 : value.get<std::int64_t>();
  if (huge || number < low || number > high)
    throw Refusal(
        fmt::format("{} is {}, but it must be {} to {}", path.text(), value.dump(), low, high));
  return number;
}

int read_int(const json& value, const Path& path, int low, int high) {
  return static_cast<int>(read_integer(value, path, low, high));
}

bool read_bool(const json& value, const Path& path) {
  if (!value.is_boolean()) refuse_type(value, path, "true or false");
  return value.get<bool>();
}

double read_finite(const json& value, const Path& path) {
  if (!value.is_number()) refuse_type(value, path, "a number");
  return value.get<double>();
}

double read_number(const json& value, const Path& path) {
  if (value.is_number()) return value.get<double>();
  if (value == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (value == "inf") return std::numeric_limits<double>::infinity();
  if (value == "-inf") return -std::numeric_limits<double>::infinity();
  refuse_type(value, path, "a number, \"nan\", \"inf\" or \"-inf\"");
}

const std::string& read_string(const json& value, const Path& path) {
  if (!value.is_string()) refuse_type(value, path, "a string");
  return value.get_ref<const std::string&>();
}

void refuse_name(const std::string& name, const Path& path) {
  throw Refusal(fmt::format("{} is the unknown name \"{}\"", path.text(), excerpt(name, 40)));
}

std::string excerpt(std::string_view text, std::size_t limit) {
  std::string result;
  for (char c : text.substr(0, limit)) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 0x20 || byte >= 0x7f ? '?' : c;
  }
  return text.size() > limit ? result + "..." : result;
}

}  // namespace edgecase::wire
