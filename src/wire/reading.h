// SPDX-License-Identifier: MIT
//
// Strict reading of JSON values from another program, for use in src/wire only: its readers throw a
// Refusal, which the public functions of this folder turn into a WireError.
//
// A Path names the current value as an RFC 6901 pointer. It is a chain of links on the stack, so an
// array of a million numbers needs no text until one of them is wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace edgecase::wire {

class Refusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Path {
 public:
  Path() = default;
  Path(const Path& parent, const char* key) : parent_(&parent), key_(key) {}
  Path(const Path& parent, std::size_t index) : parent_(&parent), index_(index) {}

  // "/fragments/3/x"; "the line" for the document itself.
  std::string text() const;

 private:
  std::string pointer() const;

  const Path* parent_ = nullptr;
  const char* key_ = nullptr;
  std::size_t index_ = 0;
};

// Parses a whole line; refuses anything after the first value.
nlohmann::json parse_text(std::string_view line);

// Refuses values that are not objects, and keys other than `known`.
void require_object(const nlohmann::json& value, const Path& path,
                    std::span<const char* const> known);
void require_object(const nlohmann::json& value, const Path& path,
                    std::initializer_list<const char*> known);

// Refuses values that are not arrays of length `size`.
void require_array(const nlohmann::json& value, const Path& path, std::size_t size);

// The member `key`, which is required; and the optional form (nullptr if absent).
const nlohmann::json& member(const nlohmann::json& object, const Path& path, const char* key);
const nlohmann::json* optional_member(const nlohmann::json& object, const char* key);

// An integer, written as one (3, not 3.0), from low to high, both inclusive.
std::int64_t read_integer(const nlohmann::json& value, const Path& path, std::int64_t low,
                          std::int64_t high);

// The same, with limits of type int.
int read_int(const nlohmann::json& value, const Path& path, int low, int high);

bool read_bool(const nlohmann::json& value, const Path& path);

// A finite number.
double read_finite(const nlohmann::json& value, const Path& path);

// A number, or one of the strings "nan", "inf" and "-inf".
double read_number(const nlohmann::json& value, const Path& path);

const std::string& read_string(const nlohmann::json& value, const Path& path);

[[noreturn]] void refuse_name(const std::string& name, const Path& path);

// A value of an enumeration that has a parse_name.
template <class Enum>
Enum read_name(const nlohmann::json& value, const Path& path) {
  const std::string& name = read_string(value, path);
  Enum result{};
  if (!parse_name(name, result)) refuse_name(name, path);
  return result;
}

// The start of `text`, made printable, at most `limit` characters, with "..." if it was cut.
std::string excerpt(std::string_view text, std::size_t limit);

}  // namespace edgecase::wire
